package lightning.document;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.light.Light;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.ShotDiff;
import lightning.scene.shot.Track;
import org.jspecify.annotations.Nullable;

/**
 * Unlimited undo and redo: a history for the document and one for each light (paper §3.4).
 *
 * <p>Undoing one light keeps later edits of all others. It is itself a step of the document, which the document's undo reverts. A step of
 * the document's history also restores each light's own history.
 */
public final class EditHistory {
    private final Deque<Step> undoneSteps = new ArrayDeque<>();
    private final Deque<Step> doneSteps = new ArrayDeque<>();
    private DocumentState state;
    private long lastId;

    private record Step(DocumentState before, DocumentState after, @Nullable Object gesture, String label) {}

    /** Creates a history that starts with a scene. */
    public EditHistory(Scene scene) {
        this(AnimatedScene.of(scene));
    }

    /** Creates a history that starts with a scene and its shot. */
    public EditHistory(AnimatedScene content) {
        state = DocumentState.initial(content, this::nextId);
    }

    /** Returns the scene without keyframes applied. */
    public Scene scene() {
        return state.scene();
    }

    /** Returns the scene with its shot. */
    public AnimatedScene content() {
        return state.content();
    }

    /** Sets the current scene, as a separate step. Keyframes follow renamed objects. An equal scene adds no step. */
    public void edit(Scene edited) {
        edit(edited, null);
    }

    /** Sets the current scene, in one step with all edits of the same gesture: see {@link #edit(AnimatedScene, Object)}. */
    public void edit(Scene edited, @Nullable Object gesture) {
        edit(content().withScene(edited), gesture);
    }

    /**
     * Sets the current scene and its shot, merged with directly preceding edits of the same gesture. A gesture that ends at its start
     * leaves no step.
     *
     * @param gesture object that identifies one drag, compared by identity; null for a separate step
     */
    public void edit(AnimatedScene edited, @Nullable Object gesture) {
        edit(edited, gesture, "");
    }

    /**
     * Sets the current scene and its shot, as {@link #edit(AnimatedScene, Object)} does.
     *
     * @param label name of the step; empty to describe the difference
     */
    void edit(AnimatedScene edited, @Nullable Object gesture, String label) {
        Step last = doneSteps.peek();
        boolean isSameGesture = gesture != null && last != null && last.gesture() == gesture && undoneSteps.isEmpty();
        if (edited.equals(state.content()) && !isSameGesture) {
            return;
        }
        DocumentState base = isSameGesture ? last.before() : state;
        if (isSameGesture) {
            doneSteps.pop();
        }
        undoneSteps.clear();
        state = base;
        if (!edited.equals(base.content())) {
            push(base.afterEdit(edited, this::nextId), gesture,
                    label.isEmpty() ? ShotDiff.summarize(base.content(), edited) : label);
        }
    }

    private void push(DocumentState after, @Nullable Object gesture, String label) {
        doneSteps.push(new Step(state, after, gesture, label));
        state = after;
    }

    /** Returns the label of the step that {@link #undo} reverts; empty if none. */
    public Optional<String> undoLabel() {
        return Optional.ofNullable(doneSteps.peek()).map(Step::label);
    }

    /** Returns what the last step changed, as it was before; empty if there is no step. */
    public Optional<AnimatedScene> beforeLastStep() {
        return Optional.ofNullable(doneSteps.peek()).map(step -> step.before().content());
    }

    /** Returns the label of the step that {@link #redo} repeats; empty if none. */
    public Optional<String> redoLabel() {
        return Optional.ofNullable(undoneSteps.peek()).map(Step::label);
    }

    /** Undoes the last step; does nothing if there is none. */
    public void undo() {
        if (!doneSteps.isEmpty()) {
            Step step = doneSteps.pop();
            undoneSteps.push(step);
            state = step.before();
        }
    }

    /** Redoes the step undone last; does nothing if there is none. */
    public void redo() {
        if (!undoneSteps.isEmpty()) {
            Step step = undoneSteps.pop();
            doneSteps.push(step);
            state = step.after();
        }
    }

    /** Returns the labels of all document steps, oldest first; those after {@link #position} are undone. */
    public List<String> steps() {
        List<String> labels = new ArrayList<>();
        doneSteps.descendingIterator().forEachRemaining(s -> labels.add(s.label()));
        undoneSteps.forEach(s -> labels.add(s.label()));
        return labels;
    }

    /** Returns the number of document steps that are not undone. */
    public int position() {
        return doneSteps.size();
    }

    /** Undoes or redoes until that many steps are done, clamped to the number of steps. */
    public void goTo(int position) {
        while (doneSteps.size() > position && !doneSteps.isEmpty()) {
            undo();
        }
        while (doneSteps.size() < position && !undoneSteps.isEmpty()) {
            redo();
        }
    }

    /**
     * Returns the labels of all steps of one light, oldest first; those after {@link #lightPosition} are undone. Empty if the light does
     * not exist.
     */
    public List<String> lightSteps(long id) {
        Optional<Light> current = light(id);
        if (current.isEmpty()) {
            return List.of();
        }
        Deque<String> labels = new ArrayDeque<>();
        Light after = current.get();
        List<Track> keys = DocumentState.lightTracks(content(), after);
        for (LightHistory.Entry l = state.lightHistory(id).past(); l != null; l = l.next()) {
            labels.addFirst(summary(l.light(), l.keys(), after, keys));
            after = l.light();
            keys = l.keys();
        }
        Light before = current.get();
        keys = DocumentState.lightTracks(content(), before);
        for (LightHistory.Entry l = state.lightHistory(id).future(); l != null; l = l.next()) {
            labels.addLast(summary(before, keys, l.light(), l.keys()));
            before = l.light();
            keys = l.keys();
        }
        return List.copyOf(labels);
    }

    /** Returns the number of steps of one light that are not undone. */
    public int lightPosition(long id) {
        int count = 0;
        for (LightHistory.Entry l = state.lightHistory(id).past(); l != null; l = l.next()) {
            count++;
        }
        return count;
    }

    /**
     * Undoes or redoes steps of one light until that many are done, in one document step. Refused if there are fewer steps, if the position
     * is unchanged, and as {@link #undoLight}.
     */
    public EditOutcome goToLightStep(long id, int position) {
        int current = lightPosition(id);
        if (position < 0 || position > lightSteps(id).size() || position == current) {
            return new EditOutcome.Refused(position > current ? Messages.tr("nothing to redo for this light")
                    : Messages.tr("nothing to undo for this light"));
        }
        return EditOutcome.of(() -> {
            DocumentState changed = state;
            for (int step = current; step != position; step += Integer.signum(position - current)) {
                changed = changed.stepLight(id, position < current);
            }
            String name = light(id).orElseThrow().name();
            undoneSteps.clear();
            push(changed, null, position < current ? Messages.tr("{0}: {1} undone for this light only", name, current - position)
                    : Messages.tr("{0}: {1} redone for this light only", name, position - current));
            return changed.scene();
        });
    }

    /** Returns the label of the edit that {@link #undoLight} reverts; empty if none or no such light. */
    public Optional<String> undoLabel(long id) {
        return light(id).filter(_ -> state.lightHistory(id).past() != null)
                .map(light -> summary(requireNonNull(state.lightHistory(id).past()).light(),
                        requireNonNull(state.lightHistory(id).past()).keys(), light,
                        DocumentState.lightTracks(content(), light)));
    }

    /** Returns the label of the edit that {@link #redoLight} repeats; empty if none or no such light. */
    public Optional<String> redoLabel(long id) {
        return light(id).filter(_ -> state.lightHistory(id).future() != null)
                .map(light -> summary(light, DocumentState.lightTracks(content(), light),
                        requireNonNull(state.lightHistory(id).future()).light(),
                        requireNonNull(state.lightHistory(id).future()).keys()));
    }

    private String summary(Light before, List<Track> oldKeys, Light after, List<Track> keys) {
        return before.equals(after) ? ShotDiff.summarize(scene(), oldKeys, keys) : SceneDiff.summarize(before, after);
    }

    /** Undoes the last edit of one light; refused if there is none, or if its former name is taken. */
    public EditOutcome undoLight(long id) {
        return moveLight(id, true, undoLabel(id));
    }

    /** Redoes the edit undone last of one light; refused as {@link #undoLight}. */
    public EditOutcome redoLight(long id) {
        return moveLight(id, false, redoLabel(id));
    }

    private EditOutcome moveLight(long id, boolean isUndo, Optional<String> label) {
        if (label.isEmpty()) {
            return new EditOutcome.Refused(isUndo ? Messages.tr("nothing to undo for this light")
                    : Messages.tr("nothing to redo for this light"));
        }
        return EditOutcome.of(() -> {
            DocumentState changed = state.stepLight(id, isUndo);
            undoneSteps.clear();
            push(changed, null, isUndo ? Messages.tr("undo {0}", label.get()) : Messages.tr("redo {0}", label.get()));
            return changed.scene();
        });
    }

    /** Returns the number of the light with that name, which survives renames and undo; −1 if none. */
    public long id(String name) {
        for (int i = 0; i < state.ids().size(); i++) {
            if (state.scene().lights().get(i).name().equals(name)) {
                return state.ids().get(i);
            }
        }
        return -1;
    }

    /** Returns the light with that number; empty if it was deleted. */
    public Optional<Light> light(long id) {
        int index = state.ids().indexOf(id);
        return index < 0 ? Optional.empty() : Optional.of(state.scene().lights().get(index));
    }

    /** Returns the light now at the last index of a deleted one, or the last light; empty if there are none. */
    Optional<Light> neighbor(long id) {
        List<Light> lights = state.scene().lights();
        int index = Stream.concat(doneSteps.stream().map(Step::before), undoneSteps.stream().map(Step::after))
                .mapToInt(s -> s.ids().indexOf(id)).filter(p -> p >= 0).findFirst().orElse(lights.size());
        return lights.isEmpty() ? Optional.empty() : Optional.of(lights.get(Math.min(index, lights.size() - 1)));
    }

    private long nextId() {
        return lastId++;
    }
}

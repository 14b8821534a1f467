package lightning.editor.document;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.ShotDiff;
import lightning.scene.shot.Track;

/**
 * Unlimited undo and redo: one history for the document and one for each light alone (paper §3.4).
 *
 * <p>Undoing one light leaves the later edits of all others; it is itself a step of the document, which the document's
 * undo takes back. A step of the document's history brings back each light's own history too.
 */
public final class EditHistory {
    private final Deque<Step> undoneSteps = new ArrayDeque<>();
    private final Deque<Step> doneSteps = new ArrayDeque<>();
    private DocumentState state;
    private long lastId;

    private record Step(DocumentState before, DocumentState after, Object gesture, String label) {}

    /** A history that begins with a scene. */
    public EditHistory(Scene scene) {
        this(AnimatedScene.of(scene));
    }

    /** A history that begins with a scene and its shot. */
    public EditHistory(AnimatedScene content) {
        state = DocumentState.initial(content, this::nextId);
    }

    /** The scene as it is where nothing has keys. */
    public Scene scene() {
        return state.scene();
    }

    /** The scene with its shot. */
    public AnimatedScene content() {
        return state.content();
    }

    /** Makes a scene the current one, as a step of its own; keys follow what has them. An equal scene is no step. */
    public void edit(Scene edited) {
        edit(edited, null);
    }

    /** The same in one step with all edits of the same gesture: see {@link #edit(AnimatedScene, Object)}. */
    public void edit(Scene edited, Object gesture) {
        edit(content().withScene(edited), gesture);
    }

    /**
     * Makes a scene and its shot the current ones, in one step with all edits of the same gesture right before it. A gesture that ends
     * where it began leaves no step.
     *
     * @param gesture any object that stands for one drag, told by identity; null for a step of its own
     */
    public void edit(AnimatedScene edited, Object gesture) {
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
            push(base.afterEdit(edited, this::nextId), gesture, ShotDiff.summarize(base.content(), edited));
        }
    }

    private void push(DocumentState after, Object gesture, String label) {
        doneSteps.push(new Step(state, after, gesture, label));
        state = after;
    }

    /** What {@link #undo} would take back; empty if there is nothing. */
    public Optional<String> undoLabel() {
        return Optional.ofNullable(doneSteps.peek()).map(Step::label);
    }

    /** What {@link #redo} would do again; empty if there is nothing. */
    public Optional<String> redoLabel() {
        return Optional.ofNullable(undoneSteps.peek()).map(Step::label);
    }

    /** Takes the last step back; without one does nothing. */
    public void undo() {
        if (!doneSteps.isEmpty()) {
            Step step = doneSteps.pop();
            undoneSteps.push(step);
            state = step.before();
        }
    }

    /** Does the step undone last again; without one does nothing. */
    public void redo() {
        if (!undoneSteps.isEmpty()) {
            Step step = undoneSteps.pop();
            doneSteps.push(step);
            state = step.after();
        }
    }

    /** All steps of the document, the first first; those after {@link #position} are undone. */
    public List<String> steps() {
        List<String> labels = new ArrayList<>();
        doneSteps.descendingIterator().forEachRemaining(s -> labels.add(s.label()));
        undoneSteps.forEach(s -> labels.add(s.label()));
        return labels;
    }

    /** How many steps of the document are done. */
    public int position() {
        return doneSteps.size();
    }

    /** Undoes or does again until so many steps are done, or as near to that as there are steps. */
    public void goTo(int position) {
        while (doneSteps.size() > position && !doneSteps.isEmpty()) {
            undo();
        }
        while (doneSteps.size() < position && !undoneSteps.isEmpty()) {
            redo();
        }
    }

    /** All steps of one light alone, the first first; those after {@link #lightPosition} are undone. Empty if there is no such light. */
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

    /** How many steps of one light alone are done. */
    public int lightPosition(long id) {
        int count = 0;
        for (LightHistory.Entry l = state.lightHistory(id).past(); l != null; l = l.next()) {
            count++;
        }
        return count;
    }

    /**
     * Undoes or does again edits of one light alone until so many of its steps are done, in one step of the document; refused where there
     * are not so many, where it stands there already, and as {@link #undoLight}.
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

    /** What {@link #undoLight} would take back; empty if there is nothing or no such light. */
    public Optional<String> undoLabel(long id) {
        return light(id).filter(_ -> state.lightHistory(id).past() != null)
                .map(light -> summary(state.lightHistory(id).past().light(), state.lightHistory(id).past().keys(), light,
                        DocumentState.lightTracks(content(), light)));
    }

    /** What {@link #redoLight} would do again; empty if there is nothing or no such light. */
    public Optional<String> redoLabel(long id) {
        return light(id).filter(_ -> state.lightHistory(id).future() != null)
                .map(light -> summary(light, DocumentState.lightTracks(content(), light), state.lightHistory(id).future().light(),
                        state.lightHistory(id).future().keys()));
    }

    private String summary(Light before, List<Track> oldKeys, Light after, List<Track> keys) {
        return before.equals(after) ? ShotDiff.summarize(scene(), oldKeys, keys) : SceneDiff.summarize(before, after);
    }

    /** Takes back the last edit of one light alone; refused if there is none, or if its name of that time is taken. */
    public EditOutcome undoLight(long id) {
        return moveLight(id, true, undoLabel(id));
    }

    /** Does again what was undone last of one light alone; refused as {@link #undoLight}. */
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

    /** The number of the light of that name, which it keeps through renames and undo; −1 if there is none. */
    public long id(String name) {
        for (int i = 0; i < state.ids().size(); i++) {
            if (state.scene().lights().get(i).name().equals(name)) {
                return state.ids().get(i);
            }
        }
        return -1;
    }

    /** The light of that number; empty if it is gone. */
    public Optional<Light> light(long id) {
        int index = state.ids().indexOf(id);
        return index < 0 ? Optional.empty() : Optional.of(state.scene().lights().get(index));
    }

    /** The light that stands now where one that is gone stood last, or the last light; empty if there are none. */
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

package lightning.editor.document;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Texts;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneChange;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.ShotChange;
import lightning.scene.shot.Track;

/**
 * Unlimited undo and redo: one history for the document and one for each light alone (paper §3.4).
 *
 * <p>Undoing one light leaves the later edits of all others; it is itself a step of the document, which the document's
 * undo takes back. A step of the document's history brings back each light's own history too.
 */
public final class History {
    private final Deque<Step> undone = new ArrayDeque<>();
    private final Deque<Step> done = new ArrayDeque<>();
    private DocumentState state;
    private long lastId;

    private record Step(DocumentState before, DocumentState after, Object gesture, String label) {}

    /** A history that begins with a scene. */
    public History(Scene scene) {
        this(AnimatedScene.of(scene));
    }

    /** A history that begins with a scene and its shot. */
    public History(AnimatedScene content) {
        state = DocumentState.first(content, this::freshId);
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
        edit(content().with(edited), gesture);
    }

    /**
     * Makes a scene and its shot the current ones, in one step with all edits of the same gesture right before it. A gesture that ends
     * where it began leaves no step.
     *
     * @param gesture any object that stands for one drag, told by identity; null for a step of its own
     */
    public void edit(AnimatedScene edited, Object gesture) {
        Step last = done.peek();
        boolean goesOn = gesture != null && last != null && last.gesture() == gesture && undone.isEmpty();
        if (edited.equals(state.content()) && !goesOn) {
            return;
        }
        DocumentState base = goesOn ? last.before() : state;
        if (goesOn) {
            done.pop();
        }
        undone.clear();
        state = base;
        if (!edited.equals(base.content())) {
            push(base.after(edited, this::freshId), gesture, ShotChange.summary(base.content(), edited));
        }
    }

    private void push(DocumentState after, Object gesture, String label) {
        done.push(new Step(state, after, gesture, label));
        state = after;
    }

    /** What {@link #undo} would take back; empty if there is nothing. */
    public Optional<String> undoLabel() {
        return Optional.ofNullable(done.peek()).map(Step::label);
    }

    /** What {@link #redo} would do again; empty if there is nothing. */
    public Optional<String> redoLabel() {
        return Optional.ofNullable(undone.peek()).map(Step::label);
    }

    /** Takes the last step back; without one does nothing. */
    public void undo() {
        if (!done.isEmpty()) {
            Step step = done.pop();
            undone.push(step);
            state = step.before();
        }
    }

    /** Does the step undone last again; without one does nothing. */
    public void redo() {
        if (!undone.isEmpty()) {
            Step step = undone.pop();
            done.push(step);
            state = step.after();
        }
    }

    /** All steps of the document, the first first; those after {@link #position} are undone. */
    public List<String> steps() {
        List<String> all = new ArrayList<>();
        done.descendingIterator().forEachRemaining(s -> all.add(s.label()));
        undone.forEach(s -> all.add(s.label()));
        return all;
    }

    /** How many steps of the document are done. */
    public int position() {
        return done.size();
    }

    /** Undoes or does again until so many steps are done, or as near to that as there are steps. */
    public void goTo(int position) {
        while (done.size() > position && !done.isEmpty()) {
            undo();
        }
        while (done.size() < position && !undone.isEmpty()) {
            redo();
        }
    }

    /** All steps of one light alone, the first first; those after {@link #lightPosition} are undone. Empty if there is no such light. */
    public List<String> lightSteps(long id) {
        Optional<Light> now = light(id);
        if (now.isEmpty()) {
            return List.of();
        }
        Deque<String> all = new ArrayDeque<>();
        Light after = now.get();
        List<Track> keys = DocumentState.keys(content(), after);
        for (LightTrack.Link l = state.track(id).past(); l != null; l = l.rest()) {
            all.addFirst(summary(l.light(), l.keys(), after, keys));
            after = l.light();
            keys = l.keys();
        }
        Light before = now.get();
        keys = DocumentState.keys(content(), before);
        for (LightTrack.Link l = state.track(id).future(); l != null; l = l.rest()) {
            all.addLast(summary(before, keys, l.light(), l.keys()));
            before = l.light();
            keys = l.keys();
        }
        return List.copyOf(all);
    }

    /** How many steps of one light alone are done. */
    public int lightPosition(long id) {
        int count = 0;
        for (LightTrack.Link l = state.track(id).past(); l != null; l = l.rest()) {
            count++;
        }
        return count;
    }

    /**
     * Undoes or does again edits of one light alone until so many of its steps are done, in one step of the document; refused where there
     * are not so many, where it stands there already, and as {@link #undoLight}.
     */
    public Change goToOfLight(long id, int position) {
        int from = lightPosition(id);
        if (position < 0 || position > lightSteps(id).size() || position == from) {
            return new Change.Refused(position > from ? Texts.of("there is nothing to redo of this light")
                    : Texts.of("there is nothing to undo of this light"));
        }
        return Change.of(() -> {
            DocumentState moved = state;
            for (int at = from; at != position; at += Integer.signum(position - from)) {
                moved = moved.moved(id, position < from);
            }
            String name = light(id).orElseThrow().name();
            undone.clear();
            push(moved, null, position < from ? Texts.of("{0}: {1} undone of it alone", name, from - position)
                    : Texts.of("{0}: {1} redone of it alone", name, position - from));
            return moved.scene();
        });
    }

    /** What {@link #undoLight} would take back; empty if there is nothing or no such light. */
    public Optional<String> undoLabel(long id) {
        return light(id).filter(_ -> state.track(id).past() != null)
                .map(now -> summary(state.track(id).past().light(), state.track(id).past().keys(), now,
                        DocumentState.keys(content(), now)));
    }

    /** What {@link #redoLight} would do again; empty if there is nothing or no such light. */
    public Optional<String> redoLabel(long id) {
        return light(id).filter(_ -> state.track(id).future() != null)
                .map(now -> summary(now, DocumentState.keys(content(), now), state.track(id).future().light(),
                        state.track(id).future().keys()));
    }

    private String summary(Light before, List<Track> oldKeys, Light after, List<Track> keys) {
        return before.equals(after) ? ShotChange.summary(scene(), oldKeys, keys) : SceneChange.summary(before, after);
    }

    /** Takes back the last edit of one light alone; refused if there is none, or if its name of that time is taken. */
    public Change undoLight(long id) {
        return moveLight(id, true, undoLabel(id));
    }

    /** Does again what was undone last of one light alone; refused as {@link #undoLight}. */
    public Change redoLight(long id) {
        return moveLight(id, false, redoLabel(id));
    }

    private Change moveLight(long id, boolean back, Optional<String> label) {
        if (label.isEmpty()) {
            return new Change.Refused(back ? Texts.of("there is nothing to undo of this light")
                    : Texts.of("there is nothing to redo of this light"));
        }
        return Change.of(() -> {
            DocumentState moved = state.moved(id, back);
            undone.clear();
            push(moved, null, back ? Texts.of("undo {0}", label.get()) : Texts.of("redo {0}", label.get()));
            return moved.scene();
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
        int place = state.ids().indexOf(id);
        return place < 0 ? Optional.empty() : Optional.of(state.scene().lights().get(place));
    }

    /** The light that stands now where one that is gone stood last, or the last light; empty if there are none. */
    Optional<Light> neighbour(long id) {
        List<Light> lights = state.scene().lights();
        int place = Stream.concat(done.stream().map(Step::before), undone.stream().map(Step::after))
                .mapToInt(s -> s.ids().indexOf(id)).filter(p -> p >= 0).findFirst().orElse(lights.size());
        return lights.isEmpty() ? Optional.empty() : Optional.of(lights.get(Math.min(place, lights.size() - 1)));
    }

    private long freshId() {
        return lastId++;
    }
}

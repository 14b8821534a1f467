package lightning.editor.window.animation;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.beans.value.ChangeListener;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.Moment;
import lightning.editor.document.motion.MotionExport;
import lightning.editor.document.motion.MotionPath;
import lightning.editor.document.motion.MotionPathFile;
import lightning.editor.document.motion.MotionRecorder;
import lightning.editor.document.motion.PathKeys;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;

/** The animation of one light, from Make Animation to Close: what it does, without a window. */
final class Motion {
    /** What it does now. */
    enum State {
        RESTING, RECORDING, PLAYING
    }

    private final EditorModel model;
    private final SceneEditor editor;
    private final String light;
    private final ReadOnlyObjectWrapper<State> state = new ReadOnlyObjectWrapper<>(State.RESTING);
    private final ReadOnlyObjectWrapper<MotionPath> path = new ReadOnlyObjectWrapper<>();
    private final IntegerProperty frame = new SimpleIntegerProperty();
    private final ChangeListener<Number> drawn = (_, _, _) -> recordFrame();
    private MotionRecorder recorder;
    private Scene awaited;
    private boolean closed;

    /** Begins an animation of the selected light, which must be there. */
    Motion(EditorModel model) {
        this.model = model;
        editor = model.editor();
        light = editor.selection().lightName();
        editor.beginAnimation();
        model.previewLook().framesProperty().addListener(drawn);
        path.addListener((_, _, now) -> model.workbench().setWay(now != null));
    }

    /** Takes the way that a light goes in the shot. */
    void take(MotionPath way) {
        stop();
        path.set(way);
        show(0);
    }

    /** Ends, and lets the light go its way in the shot, which then has all of its frames; the message says why not. */
    void toKeys() {
        MotionPath way = path.get();
        close();
        Optional<String> refusal = editor.editAllOrReport(scene -> {
            AnimatedScene begun = KeyEdits.begin(scene);
            Shot shot = begun.shot().orElseThrow();
            int first = editor.document().moment().map(Moment::frame).orElse(shot.first());
            Shot with = PathKeys.of(shot, light, way, first);
            return begun.withShot(with.withFrames(shot.first(), Math.max(shot.last(), Math.addExact(first, way.frames() - 1))));
        }, null);
        if (refusal.isEmpty()) {
            model.arrangement().timelineShownProperty().set(true);
        }
    }

    String light() {
        return light;
    }

    ReadOnlyObjectProperty<State> stateProperty() {
        return state.getReadOnlyProperty();
    }

    State state() {
        return state.get();
    }

    /** The way recorded or loaded; null before. */
    ReadOnlyObjectProperty<MotionPath> pathProperty() {
        return path.getReadOnlyProperty();
    }

    Optional<MotionPath> path() {
        return Optional.ofNullable(path.get());
    }

    /** The frame that is shown, from 0. */
    IntegerProperty frameProperty() {
        return frame;
    }

    /** Frames recorded so far. */
    int recorded() {
        return recorder == null ? 0 : recorder.frames();
    }

    /** @param every the resolution number: frames of the preview from one key to the next, within the path's limits */
    void record(int every) {
        stop();
        recorder = new MotionRecorder(every);
        state.set(State.RECORDING);
        recordFrame();
    }

    private void recordFrame() {
        if (state.get() == State.RECORDING) {
            editor.scene().light(light).ifPresent(recorder::frame);
            frame.set(recorder.frames() - 1);
        }
    }

    /** From the begin if it stands at the end. */
    void play() {
        stop();
        if (path.get() != null) {
            state.set(State.PLAYING);
            show(frame.get() >= last() ? 0 : frame.get());
        }
    }

    void stop() {
        if (state.get() == State.RECORDING) {
            path.set(recorder.path().orElse(null));
            frame.set(last());
        }
        awaited = null;
        state.set(State.RESTING);
    }

    /** A frame of the window passed: shows the next frame of the path, once the picture shows the last. */
    void pulse() {
        if (state.get() != State.PLAYING) {
            return;
        }
        if (model.picture().renderingProperty().get().cancelled() || model.picture().renderingProperty().get().problem() != null) {
            stop();
        } else if (model.picture().frame() != null && model.picture().frame().scene().equals(awaited)) {
            show(frame.get() >= last() ? 0 : frame.get() + 1);
        }
    }

    /** Shows one frame of the path; nothing without a path. */
    void show(int number) {
        frame.set(number);
        if (path.get() != null) {
            still().ifPresent(l -> {
                awaited = editor.scene().withLight(path.get().at(l, number));
                editor.animate(awaited);
            });
        }
    }

    private Optional<Light> still() {
        return editor.scene().light(light);
    }

    private int last() {
        return path.get() == null ? 0 : path.get().frames() - 1;
    }

    /**
     * Writes the path.
     *
     * @param failed hears why the file could not be written
     */
    void save(Path file, Runnable saved, Consumer<Throwable> failed) {
        MotionPath written = path.get();
        model.files().inTurn(() -> {
            MotionPathFile.save(written, file);
            return file;
        }, _ -> saved.run(), failed);
    }

    /**
     * Takes a path from a file.
     *
     * @param failed hears why it cannot be read or is no motion path; nothing changes then
     */
    void load(Path file, Consumer<Throwable> failed) {
        model.files().beside(() -> MotionPathFile.load(file), loaded -> {
            if (!closed) {
                stop();
                path.set(loaded);
                show(0);
            }
        }, failed);
    }

    /** The pictures of the path. */
    MotionExport export(int pictures) {
        return new MotionExport(editor.scene(), light, path.get(), pictures, model.picture().viewProperty().get().ofPicture());
    }

    /** Restores the scene as it was. */
    void close() {
        if (closed) {
            return;
        }
        closed = true;
        state.set(State.RESTING);
        model.previewLook().framesProperty().removeListener(drawn);
        editor.endAnimation();
    }
}

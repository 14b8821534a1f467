package lightning.editor.window.animation;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.beans.value.ChangeListener;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.Moment;
import lightning.editor.document.motion.MotionExport;
import lightning.editor.document.motion.MotionPathFile;
import lightning.editor.document.motion.MotionRecorder;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.FramePlayer;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;

/** The animation of one light, from Make Animation to Close: what it does, without a window. */
final class Motion {
    private final EditorModel model;
    private final SceneEditor editor;
    private final String light;
    private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper();
    private final ReadOnlyObjectWrapper<RecordedShot> recorded = new ReadOnlyObjectWrapper<>();
    private final IntegerProperty frame = new SimpleIntegerProperty();
    private final ChangeListener<Number> drawn = (_, _, _) -> recordFrame();
    private final FramePlayer player;
    private MotionRecorder recorder;
    private boolean closed;

    /** Begins an animation of the selected light, which must be there. */
    Motion(EditorModel model) {
        this.model = model;
        editor = model.editor();
        light = editor.selection().lightName();
        player = new FramePlayer(editor, model.picture(), () -> model.picture().renderingProperty().get().cancelled(),
                _ -> show(frame.get() >= last() ? 0 : frame.get() + 1));
        editor.beginAnimation();
        model.previewLook().framesProperty().addListener(drawn);
        recorded.addListener((_, _, now) -> model.workbench().setWay(now != null));
    }

    /** Takes another recorded shot of the light, and shows its begin. */
    void take(RecordedShot other) {
        stop();
        recorded.set(other);
        show(0);
    }

    /** Ends, and adds what was recorded to the document's shot from the frame that is shown on; the message says why not. */
    void toKeys() {
        RecordedShot added = recorded.get();
        close();
        Optional<String> refusal = editor.editAllOrReport(scene -> {
            AnimatedScene begun = KeyEdits.begin(scene);
            Shot shot = begun.shot().orElseThrow();
            int first = editor.document().moment().map(Moment::frame).orElse(shot.first());
            return begun.withShot(added.addTo(shot, first));
        }, null);
        if (refusal.isEmpty()) {
            model.arrangement().timelineShownProperty().set(true);
        }
    }

    String light() {
        return light;
    }

    ReadOnlyBooleanProperty recordingProperty() {
        return recording.getReadOnlyProperty();
    }

    boolean isRecording() {
        return recording.get();
    }

    ReadOnlyBooleanProperty playingProperty() {
        return player.playingProperty();
    }

    boolean isPlaying() {
        return player.isPlaying();
    }

    /** The shot recorded or loaded; null before. */
    ReadOnlyObjectProperty<RecordedShot> recordedProperty() {
        return recorded.getReadOnlyProperty();
    }

    Optional<RecordedShot> recorded() {
        return Optional.ofNullable(recorded.get());
    }

    /** The frame that is shown, from 0. */
    IntegerProperty frameProperty() {
        return frame;
    }

    /** @param every the resolution number: frames of the preview from one key to the next, 1…{@value RecordedShot#MAX_EVERY} */
    void record(int every) {
        stop();
        recorder = new MotionRecorder(every);
        recording.set(true);
        recordFrame();
    }

    private void recordFrame() {
        if (recording.get()) {
            editor.scene().light(light).ifPresent(recorder::frame);
            frame.set(recorder.frames() - 1);
        }
    }

    /** From the begin if it stands at the end. */
    void play() {
        stop();
        if (recorded.get() != null) {
            show(frame.get() >= last() ? 0 : frame.get());
            player.play();
        }
    }

    void stop() {
        player.stop();
        if (recording.get()) {
            recorded.set(recorder.shot().orElse(null));
            frame.set(last());
            recording.set(false);
        }
    }

    /** Shows one frame of what was recorded; returns false if there is nothing to show. */
    boolean show(int number) {
        frame.set(number);
        boolean shows = recorded.get() != null && editor.scene().light(light).isPresent();
        if (shows) {
            editor.animate(recorded.get().shot().at(editor.scene(), number));
        }
        return shows;
    }

    private int last() {
        return recorded.get() == null ? 0 : recorded.get().shot().last();
    }

    /**
     * Writes what was recorded.
     *
     * @param failed hears why the file could not be written
     */
    void save(Path file, Runnable saved, Consumer<Throwable> failed) {
        RecordedShot written = recorded.get();
        model.files().inTurn(() -> {
            MotionPathFile.save(written, file);
            return file;
        }, _ -> saved.run(), failed);
    }

    /**
     * Takes a recorded shot from a file.
     *
     * @param failed hears why it cannot be read or is no motion path; nothing changes then
     */
    void load(Path file, Consumer<Throwable> failed) {
        model.files().beside(() -> MotionPathFile.load(file, light), loaded -> {
            if (!closed) {
                take(loaded);
            }
        }, failed);
    }

    /** The pictures of what was recorded. */
    MotionExport export(int pictures) {
        return new MotionExport(editor.scene(), recorded.get(), pictures, model.picture().viewProperty().get().ofPicture());
    }

    /** Restores the scene as it was. */
    void close() {
        if (closed) {
            return;
        }
        closed = true;
        player.stop();
        recording.set(false);
        model.previewLook().framesProperty().removeListener(drawn);
        editor.endAnimation();
    }
}

package lightning.editor.window.animation;

import static java.util.Objects.requireNonNull;

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
import lightning.editor.document.ShotFrame;
import lightning.editor.document.motion.MotionExport;
import lightning.editor.document.motion.MotionPathFile;
import lightning.editor.document.motion.MotionRecorder;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.FramePlayer;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;

/** Animation of one light, from Make Animation to Close, without its window. */
final class LightAnimation {
    private final EditorModel model;
    private final SceneEditor editor;
    private final String light;
    private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper();
    private final ReadOnlyObjectWrapper<RecordedShot> recorded = new ReadOnlyObjectWrapper<>();
    private final IntegerProperty frame = new SimpleIntegerProperty();
    private final ChangeListener<Number> frameListener = (_, _, _) -> recordFrame();
    private final FramePlayer player;
    private @Nullable MotionRecorder recorder;
    private boolean isClosed;

    /** Starts an animation of the selected light, which must exist. */
    LightAnimation(EditorModel model) {
        this.model = model;
        editor = model.editor();
        light = editor.selection().lightName();
        player = new FramePlayer(editor, model.picture(), () -> model.picture().renderStateProperty().get().canceled(),
                _ -> show(frame.get() >= lastFrame() ? 0 : frame.get() + 1));
        editor.beginAnimation();
        model.previewSettings().framesProperty().addListener(frameListener);
        recorded.addListener((_, _, now) -> model.workbench().setMotionRecorded(now != null));
    }

    /** Replaces the recorded shot and shows its first frame. */
    void setRecorded(RecordedShot newShot) {
        stop();
        recorded.set(newShot);
        show(0);
    }

    /**
     * Closes the animation and adds the recorded shot to the document's shot, starting at the current frame. Shows a message if that fails.
     */
    void convertToKeys() {
        RecordedShot recordedShot = recorded.get();
        close();
        Optional<String> refusal = editor.editShotOrReport(scene -> {
            AnimatedScene sceneWithShot = KeyEdits.addShot(scene);
            Shot shot = sceneWithShot.shot().orElseThrow();
            int first = editor.document().shotFrame().map(ShotFrame::frame).orElse(shot.first());
            return sceneWithShot.withShot(recordedShot.addTo(shot, first));
        }, null);
        if (refusal.isEmpty()) {
            model.layout().timelineShownProperty().set(true);
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

    /** Returns the recorded or loaded shot; null before the first. */
    ReadOnlyObjectProperty<RecordedShot> recordedProperty() {
        return recorded.getReadOnlyProperty();
    }

    Optional<RecordedShot> recorded() {
        return Optional.ofNullable(recorded.get());
    }

    /** Returns the current frame, from 0. */
    IntegerProperty frameProperty() {
        return frame;
    }

    /**
     * Starts recording.
     *
     * @param interval preview frames per keyframe (the paper's resolution), 1…{@value RecordedShot#MAX_INTERVAL}
     */
    void record(int interval) {
        stop();
        recorder = new MotionRecorder(interval);
        recording.set(true);
        recordFrame();
    }

    private void recordFrame() {
        if (recording.get()) {
            editor.scene().light(light).ifPresent(currentRecorder()::recordFrame);
            frame.set(currentRecorder().frameCount() - 1);
        }
    }

    /** Plays from the current frame; restarts at the last frame. */
    void play() {
        stop();
        if (recorded.get() != null) {
            show(frame.get() >= lastFrame() ? 0 : frame.get());
            player.play();
        }
    }

    void stop() {
        player.stop();
        if (recording.get()) {
            recorded.set(currentRecorder().recordedShot().orElse(null));
            frame.set(lastFrame());
            recording.set(false);
        }
    }

    /** Shows one recorded frame. Returns false if there is nothing to show. */
    boolean show(int number) {
        frame.set(number);
        boolean canShow = recorded.get() != null && editor.scene().light(light).isPresent();
        if (canShow) {
            editor.showAnimationScene(recorded.get().shot().sceneAt(editor.scene(), number));
        }
        return canShow;
    }

    private int lastFrame() {
        return recorded.get() == null ? 0 : recorded.get().shot().last();
    }

    /**
     * Saves the recorded shot.
     *
     * @param onFailure called if the file cannot be written
     */
    void save(Path file, Runnable onSaved, Consumer<Throwable> onFailure) {
        RecordedShot shot = recorded.get();
        model.files().runInOrder(() -> {
            MotionPathFile.save(shot, file);
            return file;
        }, _ -> onSaved.run(), onFailure);
    }

    /**
     * Loads a motion path file as the recorded shot.
     *
     * @param onFailure called if the file cannot be read or is not a motion path; the animation stays unchanged
     */
    void load(Path file, Consumer<Throwable> onFailure) {
        model.files().runConcurrently(() -> MotionPathFile.load(file, light), loaded -> {
            if (!isClosed) {
                setRecorded(loaded);
            }
        }, onFailure);
    }

    /** Creates an export of the recorded shot. */
    MotionExport export(int pictures) {
        return new MotionExport(editor.scene(), recorded.get(), pictures, model.picture().viewProperty().get().forOutput());
    }

    /** Restores the scene as it was before the animation. */
    void close() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        player.stop();
        recording.set(false);
        model.previewSettings().framesProperty().removeListener(frameListener);
        editor.endAnimation();
    }

    /** Returns the recorder of the running recording. */
    private MotionRecorder currentRecorder() {
        return requireNonNull(recorder);
    }
}

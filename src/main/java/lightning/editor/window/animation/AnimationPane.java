package lightning.editor.window.animation;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.document.motion.MotionExport;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ExportTask;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;

/** Content of the animation window: recording and playback, motion path files, and export of images. */
final class AnimationPane extends VBox {
    private static final String EXTENSION = "path";

    private final LightAnimation animation;
    private final PathPrompt pathPrompt;
    private final String sceneName;
    private final IntegerField resolution = new IntegerField("resolution", Messages.tr("Keyframe every N frames"),
            Messages.tr("keyframe interval"), RecordedShot.MAX_INTERVAL, RecordedShot.DEFAULT_INTERVAL);
    private final IntegerField pictures =
            new IntegerField("pictures", Messages.tr("Frames to export"), Messages.tr("the number of frames"),
                    MotionExport.MAX_PICTURES, 1);
    private final Slider scrub = new Slider(0, 1, 0);
    private final Label status = new Label();
    private final ProgressBar bar = new ProgressBar(0);
    private final List<Runnable> reasonUpdates = new ArrayList<>();
    private @Nullable ExportTask export;
    private boolean isUpdating;

    /**
     * Creates the pane.
     *
     * @param sceneName default name of saved files
     * @param close closes the window
     * @param keysButton button that converts the path to keyframes
     */
    AnimationPane(LightAnimation animation, String sceneName, PathPrompt pathPrompt, Runnable close, Node keysButton) {
        this.animation = animation;
        this.sceneName = sceneName;
        this.pathPrompt = pathPrompt;
        getStyleClass().add("animation");
        status.setId("animation-status");
        status.getStyleClass().add("status");
        status.setWrapText(true);
        bar.setMaxWidth(Double.MAX_VALUE);
        bar.setAccessibleText(Messages.tr("export progress"));
        bar.setVisible(false);
        getChildren().addAll(transport(), scrub(), resolution.widget(), pictures.widget(), files(), bar, status,
                bottom(close, keysButton));
        reasonUpdates.add(() -> pictures.widget().setDisabledReason(needsPath()));
        reasonUpdates
                .add(() -> resolution.widget()
                        .setDisabledReason(reasonUnless(!animation.isRecording(), Messages.tr("recording is in progress"))));
        animation.recordingProperty().subscribe(_ -> updateStatus());
        animation.playingProperty().subscribe(_ -> updateStatus());
        animation.frameProperty().subscribe(_ -> showFrame());
        animation.recordedProperty().subscribe(this::show);
    }

    private HBox transport() {
        return tools(
                button("record", Messages.tr("Record"), MaterialDesignR.RECORD,
                        Messages.tr("Record the light's position and direction while you move it"),
                        () -> animation.record(resolution.get()),
                        () -> reasonUnless(!animation.isRecording(), Messages.tr("recording is in progress"))),
                button("stop", Messages.tr("Stop"), MaterialDesignS.STOP, Messages.tr("Stop recording or playback"), animation::stop,
                        () -> reasonUnless(animation.isRecording() || animation.isPlaying(),
                                Messages.tr("nothing is recording or playing"))),
                button("play", Messages.tr("Play"), MaterialDesignP.PLAY,
                        Messages.tr("Play the recorded motion"),
                        animation::play, () -> animation.isPlaying() ? Optional.of(Messages.tr("playback is running")) : needsPath()));
    }

    private Node scrub() {
        scrub.setId("scrub");
        scrub.setAccessibleText(Messages.tr("frame"));
        scrub.setBlockIncrement(1);
        scrub.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating) {
                animation.stop();
                animation.show((int) Math.rint(now.doubleValue()));
            }
        });
        return withDisabledReason(scrub, Messages.tr("Current frame"), this::needsPath);
    }

    private HBox files() {
        return tools(
                button("save-animation", Messages.tr("Save…"), MaterialDesignC.CONTENT_SAVE_OUTLINE,
                        Messages.tr("Save the motion path as a text file"),
                        this::save, this::needsPath),
                button("load-animation", Messages.tr("Open…"), MaterialDesignF.FOLDER_OPEN_OUTLINE,
                        Messages.tr("Open a motion path file"),
                        this::load, Optional::empty),
                button("export", Messages.tr("Export…"), MaterialDesignI.IMAGE_MULTIPLE_OUTLINE,
                        Messages.tr("Export numbered PNG images to a folder"),
                        this::export, () -> export != null ? Optional.of(Messages.tr("an export is running")) : needsPath()),
                button("cancel-export", Messages.tr("Cancel"), MaterialDesignC.CANCEL,
                        Messages.tr("Cancel the export; saved images are kept"),
                        () -> requireNonNull(export).cancel(false),
                        () -> reasonUnless(export != null, Messages.tr("no export is running"))));
    }

    private HBox bottom(Runnable close, Node keysButton) {
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        return tools(keysButton, gap,
                button("close-animation", Messages.tr("Close"), MaterialDesignC.CLOSE, Messages.tr("Close and restore the scene"),
                        close, Optional::empty));
    }

    private static HBox tools(Node... nodes) {
        HBox tools = new HBox(nodes);
        tools.getStyleClass().add("tools");
        return tools;
    }

    private StackPane button(String id, String text, Ikon icon, String hint, Runnable action,
            Supplier<Optional<String>> reason) {
        Button button = new Button(text, FontIcon.of(icon));
        button.setId(id);
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(_ -> action.run());
        return withDisabledReason(button, hint, reason);
    }

    private StackPane withDisabledReason(Node control, String hint, Supplier<Optional<String>> reason) {
        StackPane wrapper = new StackPane(control);
        var disabledReason = new DisabledReason(wrapper, control, hint);
        reasonUpdates.add(() -> disabledReason.set(reason.get()));
        return wrapper;
    }

    private Optional<String> needsPath() {
        return animation.isRecording() ? Optional.of(Messages.tr("recording is in progress"))
                : reasonUnless(animation.recorded().isPresent(), Messages.tr("nothing is recorded or opened yet"));
    }

    private static Optional<String> reasonUnless(boolean isPossible, String reason) {
        return isPossible ? Optional.empty() : Optional.of(reason);
    }

    private void updateStatus() {
        reasonUpdates.forEach(Runnable::run);
        status.setText(animation.isRecording() ? Messages.tr("Move {0} in the preview, then press Stop.", animation.light())
                : animation.isPlaying() ? Messages.tr("Playing")
                : animation.recorded().map(r -> Messages.tr("{0} keyframes over {1} frames", r.keyCount(), r.frameCount()))
                        .orElse(Messages.tr("Press Record, then move {0} in the preview.", animation.light())));
    }

    private void show(@Nullable RecordedShot recorded) {
        if (recorded != null) {
            pictures.set(Math.min(recorded.frameCount(), MotionExport.MAX_PICTURES));
            isUpdating = true;
            scrub.setMax(Math.max(1, recorded.frameCount() - 1));
            isUpdating = false;
        }
        showFrame();
        updateStatus();
    }

    private void showFrame() {
        if (animation.isRecording()) {
            status.setText(Messages.tr("Recording: {0} frames", animation.frameProperty().get() + 1));
        } else {
            isUpdating = true;
            scrub.setValue(animation.frameProperty().get());
            isUpdating = false;
        }
    }

    private void save() {
        pathPrompt.fileToSave(Messages.tr("Save Motion Path"), sceneName + "." + EXTENSION, EXTENSION).ifPresent(file -> {
            status.setText(Messages.tr("Saving …"));
            animation.save(file, () -> status.setText(Messages.tr("Saved to {0}", Quote.path(file))),
                    failure -> status.setText(Messages.tr("Not saved: {0}", ErrorMessage.of(failure))));
        });
    }

    private void load() {
        pathPrompt.fileToOpen(Messages.tr("Open Motion Path"), EXTENSION).ifPresent(file -> {
            animation.load(file, failure -> status.setText(Messages.tr("Not opened: {0}", ErrorMessage.of(failure))));
        });
    }

    private void export() {
        pathPrompt.folder(Messages.tr("Export Images To")).ifPresent(folder -> {
            animation.stop();
            MotionExport motion = animation.export(pictures.get());
            var task = new ExportTask(motion.pictureCount(), (progress, written) -> motion.write(folder, sceneName, progress, written));
            export = task;
            bar.progressProperty().bind(task.progressProperty());
            bar.setVisible(true);
            reasonUpdates.forEach(Runnable::run);
            task.valueProperty().subscribe(written -> showProgress(task, written));
            task.stateProperty().addListener((_, _, now) -> finishExport(task, folder, now));
            task.start();
        });
    }

    /** An export may report its last images after it was canceled. */
    private void showProgress(ExportTask task, int written) {
        if (export == task) {
            status.setText(Messages.tr("Exporting: {0} of {1}", written, task.frames()));
        }
    }

    private void finishExport(ExportTask task, Path folder, Worker.State state) {
        switch (state) {
            case READY, SCHEDULED, RUNNING -> {
                return;
            }
            case SUCCEEDED -> status.setText(Messages.tr("Exported {0} images to {1}", task.frames(), folder));
            case CANCELLED -> status.setText(Messages.tr("Export canceled after {0} of {1} images", task.getValue(), task.frames()));
            case FAILED -> status.setText(Messages.tr("Export failed: {0}", task.getException().getMessage()));
        }
        export = null;
        bar.progressProperty().unbind();
        bar.setVisible(false);
        reasonUpdates.forEach(Runnable::run);
    }

    /** Cancels a running export; finished images are kept. */
    void stopExport() {
        if (export != null) {
            export.cancel(false);
        }
    }
}

package lightning.editor.window.animation;

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
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.motion.MotionExport;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.Obstacle;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;

/** What the animation window holds: record, stop, play and scrub, files, and the export of pictures. */
final class AnimationPane extends VBox {
    private static final String EXTENSION = "path";

    private final Motion motion;
    private final PathAsk ask;
    private final String sceneName;
    private final WholeNumber resolution = new WholeNumber("resolution", Texts.of("Resolution: preview frames from key to key"),
            "resolution", RecordedShot.MAX_EVERY, RecordedShot.DEFAULT_EVERY);
    private final WholeNumber pictures = new WholeNumber("pictures", Texts.of("Pictures to export"), Texts.of("the number of pictures"),
            MotionExport.MAX_PICTURES, 1);
    private final Slider scrub = new Slider(0, 1, 0);
    private final Label status = new Label();
    private final ProgressBar bar = new ProgressBar(0);
    private final List<Runnable> obstacles = new ArrayList<>();
    private ExportTask export;
    private boolean showing;

    /**
     * @param sceneName how the files that are saved are called, unless the artist says otherwise
     * @param close     closes the window
     * @param toKeys    makes keys of the way
     */
    AnimationPane(Motion motion, String sceneName, PathAsk ask, Runnable close, Node toKeys) {
        this.motion = motion;
        this.sceneName = sceneName;
        this.ask = ask;
        getStyleClass().add("animation");
        status.setId("animation-status");
        status.getStyleClass().add("status");
        status.setWrapText(true);
        bar.setMaxWidth(Double.MAX_VALUE);
        bar.setAccessibleText(Texts.of("export progress"));
        bar.setVisible(false);
        getChildren().addAll(transport(), scrub(), resolution.widget(), pictures.widget(), files(), bar, status,
                bottom(close, toKeys));
        obstacles.add(() -> pictures.widget().setObstacle(needsPath()));
        obstacles.add(() -> resolution.widget().setObstacle(unless(!motion.isRecording(), Texts.of("it is recording"))));
        motion.recordingProperty().subscribe(_ -> tell());
        motion.playingProperty().subscribe(_ -> tell());
        motion.frameProperty().subscribe(_ -> showFrame());
        motion.recordedProperty().subscribe(this::show);
    }

    private HBox transport() {
        return tools(
                button("record", Texts.of("Record"), MaterialDesignR.RECORD,
                        Texts.of("Records position and direction while you move the light"),
                        () -> motion.record(resolution.get()), () -> unless(!motion.isRecording(), Texts.of("it is recording"))),
                button("stop", Texts.of("Stop"), MaterialDesignS.STOP, Texts.of("Stops recording or playing"), motion::stop,
                        () -> unless(motion.isRecording() || motion.isPlaying(), Texts.of("nothing is recording or playing"))),
                button("play", Texts.of("Play"), MaterialDesignP.PLAY, Texts.of("Renders the picture again and again as the light moves"),
                        motion::play, () -> motion.isPlaying() ? Optional.of(Texts.of("it is playing")) : needsPath()));
    }

    private Node scrub() {
        scrub.setId("scrub");
        scrub.setAccessibleText(Texts.of("frame"));
        scrub.setBlockIncrement(1);
        scrub.valueProperty().addListener((_, _, now) -> {
            if (!showing) {
                motion.stop();
                motion.show((int) Math.rint(now.doubleValue()));
            }
        });
        return explained(scrub, Texts.of("The frame that is shown"), this::needsPath);
    }

    private HBox files() {
        return tools(
                button("save-animation", Texts.of("Save…"), MaterialDesignC.CONTENT_SAVE_OUTLINE,
                        Texts.of("Save Animation: the path as a text file"),
                        this::save, this::needsPath),
                button("load-animation", Texts.of("Load…"), MaterialDesignF.FOLDER_OPEN_OUTLINE,
                        Texts.of("Load Animation: a path from a file"),
                        this::load, Optional::empty),
                button("export", Texts.of("Export…"), MaterialDesignI.IMAGE_MULTIPLE_OUTLINE,
                        Texts.of("Writes numbered PNG pictures to a folder"),
                        this::export, () -> export != null ? Optional.of(Texts.of("an export is running")) : needsPath()),
                button("cancel-export", Texts.of("Cancel"), MaterialDesignC.CANCEL, Texts.of("Stops the export; finished pictures stay"),
                        () -> export.cancel(false), () -> unless(export != null, Texts.of("no export is running"))));
    }

    private HBox bottom(Runnable close, Node toKeys) {
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        return tools(toKeys, gap,
                button("close-animation", Texts.of("Close"), MaterialDesignC.CLOSE, Texts.of("Restores the scene as it was before"),
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
        return explained(button, hint, reason);
    }

    private StackPane explained(Node control, String hint, Supplier<Optional<String>> reason) {
        StackPane around = new StackPane(control);
        var obstacle = new Obstacle(around, control, hint);
        obstacles.add(() -> obstacle.set(reason.get()));
        return around;
    }

    private Optional<String> needsPath() {
        return motion.isRecording() ? Optional.of(Texts.of("it is recording"))
                : unless(motion.recorded().isPresent(), Texts.of("nothing is recorded or loaded yet"));
    }

    private static Optional<String> unless(boolean possible, String reason) {
        return possible ? Optional.empty() : Optional.of(reason);
    }

    private void tell() {
        obstacles.forEach(Runnable::run);
        status.setText(motion.isRecording() ? Texts.of("Move {0} in the preview, then press Stop.", motion.light())
                : motion.isPlaying() ? Texts.of("Playing")
                : motion.recorded().map(r -> Texts.of("{0} keys over {1} frames", r.keys(), r.frames()))
                        .orElse(Texts.of("Press Record, then move {0} in the preview.", motion.light())));
    }

    private void show(RecordedShot recorded) {
        if (recorded != null) {
            pictures.set(Math.min(recorded.frames(), MotionExport.MAX_PICTURES));
            showing = true;
            scrub.setMax(Math.max(1, recorded.frames() - 1));
            showing = false;
        }
        showFrame();
        tell();
    }

    private void showFrame() {
        if (motion.isRecording()) {
            status.setText(Texts.of("Recording: {0} frames", motion.frameProperty().get() + 1));
        } else {
            showing = true;
            scrub.setValue(motion.frameProperty().get());
            showing = false;
        }
    }

    private void save() {
        ask.fileToSave(Texts.of("Save Animation"), sceneName + "." + EXTENSION, EXTENSION).ifPresent(file -> {
            status.setText(Texts.of("Saving …"));
            motion.save(file, () -> status.setText(Texts.of("Saved to {0}", Quote.path(file))),
                    why -> status.setText(Texts.of("Not saved: {0}", Sentence.of(why))));
        });
    }

    private void load() {
        ask.fileToOpen(Texts.of("Load Animation"), EXTENSION).ifPresent(file -> {
            motion.load(file, why -> status.setText(Texts.of("Not loaded: {0}", Sentence.of(why))));
        });
    }

    private void export() {
        ask.folder(Texts.of("Export pictures to")).ifPresent(folder -> {
            motion.stop();
            ExportTask task = new ExportTask(motion.export(pictures.get()), folder, sceneName);
            export = task;
            bar.progressProperty().bind(task.progressProperty());
            bar.setVisible(true);
            obstacles.forEach(Runnable::run);
            task.valueProperty().subscribe(written -> exported(task, written));
            task.stateProperty().addListener((_, _, now) -> ended(task, now));
            task.begin();
        });
    }

    /** The last pictures of an export that was cancelled are told of after its end. */
    private void exported(ExportTask task, int written) {
        if (export == task) {
            status.setText(Texts.of("Exporting: {0} of {1}", written, task.pictures()));
        }
    }

    private void ended(ExportTask task, Worker.State now) {
        switch (now) {
            case READY, SCHEDULED, RUNNING -> {
                return;
            }
            case SUCCEEDED -> status.setText(Texts.of("Exported {0} pictures to {1}", task.pictures(), task.folder()));
            case CANCELLED -> status.setText(Texts.of("Export cancelled after {0} of {1} pictures", task.getValue(), task.pictures()));
            case FAILED -> status.setText(Texts.of("Export failed: {0}", task.getException().getMessage()));
        }
        export = null;
        bar.progressProperty().unbind();
        bar.setVisible(false);
        obstacles.forEach(Runnable::run);
    }

    /** Stops an export that runs; finished pictures stay. */
    void stopExport() {
        if (export != null) {
            export.cancel(false);
        }
    }
}

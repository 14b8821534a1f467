package lightning.editor.window.timeline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.document.StepRange;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.RemainingTime;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ExportTask;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.NumberSetting;
import lightning.format.jen.JenFile;
import lightning.render.image.ViewTransform;
import lightning.scene.shot.Shot;
import lightning.scene.value.SceneLimits;
import lightning.shot.movie.Ffmpeg;
import org.jspecify.annotations.Nullable;

/** Settings and progress of exporting a shot. */
final class ShotExportPane extends VBox {
    private final SceneEditor editor;
    private final FileThread files;
    private final ObservableValue<ViewTransform> viewProperty;
    private final PathPrompt pathPrompt;
    private final ChoiceBox<ShotFormat> format = new ChoiceBox<>();
    private final NumberField first;
    private final NumberField last;
    private final Label about = new Label();
    private final Button export = new Button(Messages.tr("Export…"));
    private final DisabledReason exportReason;
    private final Button cancel = new Button(Messages.tr("Cancel"));
    private final ProgressBar bar = new ProgressBar(0);
    private final Label status = new Label();
    private final RemainingTime remaining = new RemainingTime();
    private int firstFrame;
    private int lastFrame;
    private boolean hasFfmpeg;
    private @Nullable ExportTask task;

    ShotExportPane(SceneEditor editor, FileThread files, ObservableValue<ViewTransform> viewProperty, PathPrompt pathPrompt) {
        this.editor = editor;
        this.files = files;
        this.viewProperty = viewProperty;
        this.pathPrompt = pathPrompt;
        setId("shot-export");
        getStyleClass().add("shot-export");
        Shot shot = editor.document().shotFrame().orElseThrow().shot();
        firstFrame = shot.first();
        lastFrame = shot.last();
        format.setId("shot-kind");
        format.setAccessibleText(Messages.tr("file format"));
        format.getItems().setAll(ShotFormat.values());
        format.setValue(ShotFormat.PNG);
        first = field("first", Messages.key("first frame"), v -> firstFrame = v);
        last = field("last", Messages.key("last frame"), v -> lastFrame = v);
        first.show(firstFrame);
        last.show(lastFrame);
        about.setId("shot-about");
        about.getStyleClass().add("pane-note");
        about.setWrapText(true);
        export.setId("shot-begin");
        export.getStyleClass().add("accent");
        export.setOnAction(_ -> chooseTarget());
        var exportBox = new StackPane(export);
        exportReason = new DisabledReason(exportBox, export, Messages.tr("Choose where to save, then render all frames"));
        cancel.setId("shot-cancel");
        cancel.setDisable(true);
        cancel.setOnAction(_ -> cancelExport());
        bar.setMaxWidth(Double.MAX_VALUE);
        bar.setVisible(false);
        bar.setAccessibleText(Messages.tr("export progress"));
        status.setId("shot-status");
        status.setWrapText(true);
        status.setMinHeight(USE_PREF_SIZE);
        getChildren().addAll(row(new Label(Messages.tr("Files")), format),
                row(new Label(Messages.tr("Frames")), first, new Label(Messages.tr("to")), last),
                about, row(exportBox, cancel), bar, status);
        files.runConcurrently(Ffmpeg::find, found -> {
            hasFfmpeg = found.isPresent();
            update();
        }, _ -> {});
        format.valueProperty().subscribe(_ -> update());
        viewProperty.subscribe(_ -> update());
    }

    private static HBox row(Node... nodes) {
        var row = new HBox(nodes);
        row.getStyleClass().add("tools");
        return row;
    }

    private interface Setter {
        void set(int frame);
    }

    private NumberField field(String id, String title, Setter setter) {
        var field = new NumberField(title, NumberSetting.of(title, new StepRange(1, 0, Shot.MAX_FRAME), (v, _) -> {
            if (v != Math.rint(v) || v < 0 || v > Shot.MAX_FRAME) {
                return Optional.of(Messages.tr("{0}: expected a whole number, found {1}", Messages.tr(title), SceneLimits.format(v)));
            }
            setter.set((int) v);
            show();
            return Optional.empty();
        }));
        field.setId("shot-" + id);
        return field;
    }

    private void show() {
        first.show(firstFrame);
        last.show(lastFrame);
        update();
    }

    private void update() {
        ViewTransform view = viewProperty.getValue().forOutput();
        boolean film = format.getValue().movie().isPresent();
        String viewText = format.getValue() == ShotFormat.EXR ? Messages.tr("Saves linear values without a view transform.")
                : Messages.tr("Uses the view transform: {0}.", view.description());
        about.setText(film ? viewText + " " + Messages.tr("Video needs an even size: an odd width or height grows by one pixel.")
                : viewText + " " + Messages.tr("Existing files are overwritten."));
        exportReason.set(task != null ? Optional.of(Messages.tr("an export is running"))
                : lastFrame < firstFrame ? Optional.of(Messages.tr("the first frame must not be after the last one"))
                : film && !hasFfmpeg ? Optional.of(Ffmpeg.missingMessage()) : Optional.empty());
        if (task == null && film && !hasFfmpeg) {
            status.setText(ErrorMessage.of(new IOException(Ffmpeg.missingMessage())));
        }
    }

    private void chooseTarget() {
        String name = JenFile.stem(editor.document().name());
        ShotFormat chosen = format.getValue();
        if (chosen.movie().isEmpty()) {
            pathPrompt.folder(Messages.tr("Export Images To")).ifPresent(folder -> startExport(folder, name));
        } else {
            pathPrompt.fileToSave(Messages.tr("Export Shot"), name + chosen.extension(), chosen.extension().substring(1))
                    .ifPresent(file -> {
                        if (file.getFileName().toString().endsWith(chosen.extension())) {
                            startExport(file, name);
                        } else {
                            // The file dialog asked about overwriting only for the name without this extension.
                            Path named = file.resolveSibling(file.getFileName() + chosen.extension());
                            files.runConcurrently(() -> Files.exists(named), exists -> {
                                if (exists) {
                                    status.setText(Messages.tr("{0} already exists; choose it by its full name",
                                            Quote.path(named.getFileName())));
                                } else {
                                    startExport(named, name);
                                }
                            }, _ -> {});
                        }
                    });
        }
    }

    private void startExport(Path target, String name) {
        var export = new ShotExport(editor.document().content(), firstFrame, lastFrame, format.getValue(),
                viewProperty.getValue().forOutput(), target, name, editor.document().inputs());
        task = new ExportTask(export.frames(), export::write);
        bar.progressProperty().bind(task.progressProperty());
        bar.setVisible(true);
        cancel.setDisable(false);
        ExportTask running = task;
        running.progressProperty().addListener((_, _, share) -> showProgress(running, share.doubleValue()));
        running.stateProperty().addListener((_, _, now) -> finish(running, export, now));
        running.start();
        update();
    }

    private void showProgress(ExportTask running, double share) {
        if (running == task) {
            status.setText(remaining.describe(Messages.tr("Exporting"), share, System.nanoTime()) + " · "
                    + Messages.tr("{0} of {1} frames", running.getValue(), running.frames()));
        }
    }

    private void finish(ExportTask running, ShotExport export, Worker.State state) {
        switch (state) {
            case READY, SCHEDULED, RUNNING -> {
                return;
            }
            case SUCCEEDED -> status.setText(Messages.tr("Exported {0} frames to {1}", export.frames(), Quote.path(export.target())));
            case CANCELLED -> status.setText(export.format().movie().isPresent() ? Messages.tr("Canceled; no video saved")
                    : Messages.tr("Canceled; {0} of {1} images saved", running.getValue(), export.frames()));
            case FAILED -> status.setText(Messages.tr("Not exported: {0}", ErrorMessage.of(running.getException())));
        }
        task = null;
        bar.progressProperty().unbind();
        bar.setVisible(false);
        cancel.setDisable(true);
        update();
    }

    /** Cancels a running export; finished images are kept. */
    void cancelExport() {
        if (task != null) {
            task.cancel(false);
        }
    }
}

package lightning.editor.window.timeline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.FileThread;
import lightning.editor.document.Steps;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.Remaining;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.Obstacle;
import lightning.format.jen.JenFile;
import lightning.render.image.ViewTransform;
import lightning.scene.Limits;
import lightning.scene.shot.Shot;
import lightning.shot.movie.Ffmpeg;

/** Which frames of the shot become what files, and how far that is. */
final class ShotExportPane extends VBox {
    private final SceneEditor editor;
    private final FileThread files;
    private final ObjectProperty<ViewTransform> viewProperty;
    private final PathAsk ask;
    private final ChoiceBox<ShotKind> kind = new ChoiceBox<>();
    private final NumberField first;
    private final NumberField last;
    private final Label about = new Label();
    private final Button export = new Button(Texts.of("Export…"));
    private final Obstacle obstacle;
    private final Button cancel = new Button(Texts.of("Cancel"));
    private final ProgressBar bar = new ProgressBar(0);
    private final Label status = new Label();
    private final Remaining remaining = new Remaining();
    private int from;
    private int to;
    private boolean ffmpeg;
    private ShotExportTask task;

    ShotExportPane(SceneEditor editor, FileThread files, ObjectProperty<ViewTransform> viewProperty, PathAsk ask) {
        this.editor = editor;
        this.files = files;
        this.viewProperty = viewProperty;
        this.ask = ask;
        setId("shot-export");
        getStyleClass().add("shot-export");
        Shot shot = editor.document().moment().orElseThrow().shot();
        from = shot.first();
        to = shot.last();
        kind.setId("shot-kind");
        kind.setAccessibleText(Texts.of("kind of files"));
        kind.getItems().setAll(ShotKind.values());
        kind.setValue(ShotKind.PNG);
        first = field("first", Texts.key("first frame"), v -> from = v);
        last = field("last", Texts.key("last frame"), v -> to = v);
        first.show(from);
        last.show(to);
        about.setId("shot-about");
        about.getStyleClass().add("pane-note");
        about.setWrapText(true);
        export.setId("shot-begin");
        export.getStyleClass().add("accent");
        export.setOnAction(_ -> begin());
        var around = new StackPane(export);
        obstacle = new Obstacle(around, export, Texts.of("Asks where, and renders all frames"));
        cancel.setId("shot-cancel");
        cancel.setDisable(true);
        cancel.setOnAction(_ -> stop());
        bar.setMaxWidth(Double.MAX_VALUE);
        bar.setVisible(false);
        bar.setAccessibleText(Texts.of("export progress"));
        status.setId("shot-status");
        status.setWrapText(true);
        status.setMinHeight(USE_PREF_SIZE);
        getChildren().addAll(row(new Label(Texts.of("Files")), kind),
                row(new Label(Texts.of("Frames")), first, new Label(Texts.of("to")), last),
                about, row(around, cancel), bar, status);
        files.beside(Ffmpeg::installed, found -> {
            ffmpeg = found.isPresent();
            tell();
        }, _ -> {});
        kind.valueProperty().subscribe(_ -> tell());
        viewProperty.subscribe(_ -> tell());
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
        var field = new NumberField(title, Gauge.of(title, new Steps(1, 0, Shot.MAX_FRAME), (v, _) -> {
            if (v != Math.rint(v) || v < 0 || v > Shot.MAX_FRAME) {
                return Optional.of(Texts.of("{0} must be a whole number, was {1}", Texts.of(title), Limits.text(v)));
            }
            setter.set((int) v);
            show();
            return Optional.empty();
        }));
        field.setId("shot-" + id);
        return field;
    }

    private void show() {
        first.show(from);
        last.show(to);
        tell();
    }

    private void tell() {
        ViewTransform view = viewProperty.get().ofPicture();
        boolean film = kind.getValue().movie().isPresent();
        String shown = kind.getValue() == ShotKind.EXR ? Texts.of("Every linear value in full.")
                : Texts.of("As the picture is shown: {0}.", view.text());
        about.setText(film ? shown + " " + Texts.of("A film has an even size; an odd one gets one more column or row.")
                : shown + " " + Texts.of("Pictures of the same names are replaced."));
        obstacle.set(task != null ? Optional.of(Texts.of("an export is running"))
                : to < from ? Optional.of(Texts.of("the first frame is behind the last one"))
                : film && !ffmpeg ? Optional.of(Ffmpeg.missing()) : Optional.empty());
        if (task == null && film && !ffmpeg) {
            status.setText(Sentence.of(new IOException(Ffmpeg.missing())));
        }
    }

    private void begin() {
        String name = JenFile.stem(editor.document().name());
        ShotKind wanted = kind.getValue();
        if (wanted.movie().isEmpty()) {
            ask.folder(Texts.of("Export pictures to")).ifPresent(folder -> begin(folder, name));
        } else {
            ask.fileToSave(Texts.of("Export Shot"), name + wanted.ending(), wanted.ending().substring(1)).ifPresent(file -> {
                if (file.getFileName().toString().endsWith(wanted.ending())) {
                    begin(file, name);
                } else {
                    // The system asked about the name as it was typed only.
                    Path named = file.resolveSibling(file.getFileName() + wanted.ending());
                    files.beside(() -> Files.exists(named), there -> {
                        if (there) {
                            status.setText(Texts.of("{0} is there already; choose it by its whole name", Quote.path(named.getFileName())));
                        } else {
                            begin(named, name);
                        }
                    }, _ -> {});
                }
            });
        }
    }

    private void begin(Path where, String name) {
        task = new ShotExportTask(new ShotExport(editor.document().content(), from, to, kind.getValue(),
                viewProperty.get().ofPicture(), where, name));
        bar.progressProperty().bind(task.progressProperty());
        bar.setVisible(true);
        cancel.setDisable(false);
        ShotExportTask begun = task;
        begun.progressProperty().addListener((_, _, share) -> tell(begun, share.doubleValue()));
        begun.stateProperty().addListener((_, _, now) -> ended(begun, now));
        begun.begin();
        tell();
    }

    private void tell(ShotExportTask begun, double share) {
        if (begun == task) {
            status.setText(remaining.tell(Texts.of("Exporting"), share, System.nanoTime()) + " · "
                    + Texts.of("{0} of {1} frames", begun.getValue(), begun.export().frames()));
        }
    }

    private void ended(ShotExportTask begun, Worker.State now) {
        ShotExport export = begun.export();
        switch (now) {
            case READY, SCHEDULED, RUNNING -> {
                return;
            }
            case SUCCEEDED -> status.setText(Texts.of("Exported {0} frames to {1}", export.frames(), Quote.path(export.to())));
            case CANCELLED -> status.setText(export.kind().movie().isPresent() ? Texts.of("Cancelled; no film was written")
                    : Texts.of("Cancelled; {0} of {1} pictures are written", begun.getValue(), export.frames()));
            case FAILED -> status.setText(Texts.of("Not exported: {0}", Sentence.of(begun.getException())));
        }
        task = null;
        bar.progressProperty().unbind();
        bar.setVisible(false);
        cancel.setDisable(true);
        tell();
    }

    /** Stops an export that runs; finished pictures stay. */
    void stop() {
        if (task != null) {
            task.cancel(false);
        }
    }
}

package lightning.editor.window.link;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.Executor;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.file.AtomicFile;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.document.LinkTable;
import lightning.document.LinkTableCsv;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;
import lightning.format.jen.JenFile;
import lightning.scene.Scene;

/** Light links: a matrix of lights and objects, with illumination on or off and a gain for each pair. */
public final class LinkPane extends VBox {
    private final SceneEditor editor;
    private final FileThread files;
    private final Executor windowExecutor;
    private final Set<String> closedGroups = new HashSet<>();
    private final LinkMatrix matrix = new LinkMatrix();
    private final TextField search = new TextField();
    private final Label note = new Label();

    public LinkPane(SceneEditor editor, FileThread files) {
        this.editor = editor;
        this.files = files;
        windowExecutor = files.windowExecutor();
        setId("light-links");
        getStyleClass().add("light-links");
        var links = new LinkEditor(editor, closedGroups, this::show);
        search.setId("link-search");
        search.setPromptText(Messages.tr("Search"));
        search.setAccessibleText(Messages.tr("search objects by name"));
        search.textProperty().subscribe(_ -> show());
        note.setId("link-note");
        note.getStyleClass().add("pane-note");
        var message = new Label();
        message.setId("link-message");
        message.getStyleClass().add("mixer-message");
        message.textProperty().bind(editor.message().textProperty());
        message.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(message, Priority.ALWAYS);
        var export = new Button(Messages.tr("Export Table…"));
        export.setId("link-export");
        export.setMinWidth(Region.USE_PREF_SIZE);
        export.setTooltip(new Tooltip(Messages.tr("Save all links and gains as comma-separated values")));
        export.setOnAction(_ -> PathPrompt.ofSystem(getScene().getWindow(), ParentFolder.of(editor.document().file()))
                .fileToSave(Messages.tr("Export Table"), JenFile.stem(editor.document().name()) + "-links.csv", "csv")
                .ifPresent(this::export));
        var tools = new HBox(search, note, message, export);
        tools.getStyleClass().add("mixer-tools");
        var status = new Label();
        status.setId("link-status");
        status.textProperty().bind(links.statusProperty());
        var help = new Label(Messages.tr("Click links · drag changes the gain · type a percentage · Delete resets"));
        help.getStyleClass().add("pane-note");
        help.setWrapText(true);
        status.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(status, Priority.ALWAYS);
        var foot = new HBox(status, help);
        foot.getStyleClass().add("mixer-tools");
        var above = new Pane();
        above.setPickOnBounds(false);
        var body = new StackPane(matrix, above);
        VBox.setVgrow(body, Priority.ALWAYS);
        getChildren().addAll(tools, body, foot);
        LinkInput.install(matrix, links, above);
        VisibilityListener.attach(this, this::subscribe);
    }

    private Subscription subscribe() {
        windowExecutor.execute(() -> {
            matrix.requestFocus();
            matrix.showSelectedLight();
        });
        return Subscription.combine(editor.sceneProperty().subscribe(_ -> show()),
                editor.selection().lightProperty().subscribe(_ -> show()),
                ForcedLiveUpdate.renderWhileFocused(this, editor, windowExecutor));
    }

    /** Writes the table of all links. */
    void export(Path file) {
        Scene scene = editor.scene();
        files.runInOrder(() -> AtomicFile.of(file).write(LinkTableCsv.of(scene)),
                _ -> editor.message().show(Messages.tr("Exported {0}", Quote.path(file.getFileName()))),
                failure -> editor.message().show(ErrorMessage.of(failure)));
    }

    private void show() {
        LinkTable table = LinkTable.of(editor.scene(), closedGroups, search.getText());
        matrix.show(table, editor.selection().lightName());
        note.setText(table.lights().isEmpty() ? Messages.tr("No lights")
                : table.rows().isEmpty() ? Messages.tr("No objects")
                : table.isCut() ? Messages.tr("The first {0} objects; search for others", LinkTable.MAX_ROWS)
                : Messages.tr("{0} lights, {1} objects", table.lights().size(), table.rows().size()));
    }
}

package lightning.editor.window.link;

import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.Executor;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.editor.document.LinkTable;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;

/** Light links: a matrix of lights and objects, with illumination on or off and a gain for each pair. */
public final class LinkPane extends VBox {
    private final SceneEditor editor;
    private final Executor windowExecutor;
    private final Set<String> closedGroups = new HashSet<>();
    private final LinkMatrix matrix = new LinkMatrix();
    private final TextField search = new TextField();
    private final Label note = new Label();

    /** @param windowExecutor runs tasks in order on the window's thread */
    public LinkPane(SceneEditor editor, Executor windowExecutor) {
        this.editor = editor;
        this.windowExecutor = windowExecutor;
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
        var tools = new HBox(search, note, message);
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

    private void show() {
        LinkTable table = LinkTable.of(editor.scene(), closedGroups, search.getText());
        matrix.show(table, editor.selection().lightName());
        note.setText(table.lights().isEmpty() ? Messages.tr("No lights")
                : table.rows().isEmpty() ? Messages.tr("No objects")
                : table.isCut() ? Messages.tr("The first {0} objects; search for others", LinkTable.MAX_ROWS)
                : Messages.tr("{0} lights, {1} objects", table.lights().size(), table.rows().size()));
    }
}

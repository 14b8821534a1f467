package lightning.editor.window;

import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.document.loop.RenderState;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.TracedPicture;

/** Progress of a long render or summary of the last update, which opens the render log on click, and the current status message. */
final class StatusBar extends HBox {
    /** Minimum time of a render whose progress is shown, in nanoseconds. Shorter ones would make the text flash. */
    private static final long LONG_NS = 250_000_000;

    private final SceneEditor editor;
    private final TracedPicture picture;
    private final Button status = new Button();
    private final Tooltip details = new Tooltip();
    private final Label message = new Label();

    StatusBar(SceneEditor editor, TracedPicture picture, CommandRegistry commands) {
        this.editor = editor;
        this.picture = picture;
        getStyleClass().add("status-line");
        status.setId("status");
        message.setId("message");
        message.getStyleClass().add("status-message");
        message.setMinWidth(Region.USE_PREF_SIZE);
        details.setWrapText(true);
        details.setMaxWidth(600);
        status.setTooltip(details);
        status.setMnemonicParsing(false);
        status.getStyleClass().add("status-button");
        status.setAccessibleText(Messages.tr("Last update"));
        status.setOnAction(_ -> commands.run(Command.UPDATES_PANEL));
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        getChildren().addAll(status, gap, new WarningBar(editor), message);
        editor.message().textProperty().subscribe(text -> {
            message.setText(text);
            message.setManaged(!text.isEmpty());
        });
        picture.renderStateProperty().subscribe(_ -> update());
        editor.editorStateProperty().map(s -> s.sceneInProgress().isPresent() ? editor.document().name() : "").subscribe(_ -> update());
    }

    private void update() {
        RenderState state = picture.renderStateProperty().get();
        status.setText(text(state));
        status.setAccessibleText(status.getText().isEmpty() ? Messages.tr("Last update") : status.getText());
        String click = Messages.tr("\nClick to open the render log.");
        details.setText((state.frame() == null ? status.getText() : StatusText.of(state.frame(), state.saving())) + click);
    }

    private String text(RenderState state) {
        boolean isRendering = editor.editorStateProperty().get().sceneInProgress().isPresent();
        if (isRendering && state.total() > 0 && state.activity().nanoseconds() >= LONG_NS) {
            return StatusText.progress(state);
        }
        if (state.problem() != null) {
            return ErrorMessage.of(state.problem());
        }
        if (isRendering && state.plan() != null && state.frame() == null) {
            return Messages.tr("Tracing {0} …", editor.document().name());
        }
        if (state.canceled()) {
            return Messages.tr("Canceled");
        }
        if (state.verification() != null) {
            return StatusText.of(state.verification(), state.frame());
        }
        return state.frame() == null ? "" : StatusText.shortText(state);
    }
}

package lightning.editor.window;

import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.loop.RenderState;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.TracedPicture;

/** What the picture is and how long it took, in a few words that open all that is known of it; and what the artist should read next. */
final class StatusLine extends HBox {
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final Button status = new Button();
    private final Tooltip whole = new Tooltip();
    private final Label message = new Label();

    StatusLine(SceneEditor editor, TracedPicture picture, Commands commands) {
        this.editor = editor;
        this.picture = picture;
        getStyleClass().add("status-line");
        status.setId("status");
        message.setId("message");
        message.getStyleClass().add("status-message");
        message.setMinWidth(Region.USE_PREF_SIZE);
        whole.setWrapText(true);
        whole.setMaxWidth(600);
        status.setTooltip(whole);
        status.setMnemonicParsing(false);
        status.getStyleClass().add("status-button");
        status.setAccessibleText(Texts.of("What the last update did"));
        status.setOnAction(_ -> commands.run(Command.UPDATES_PANEL));
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        getChildren().addAll(status, gap, message);
        editor.message().textProperty().subscribe(text -> {
            message.setText(text);
            message.setManaged(!text.isEmpty());
        });
        picture.renderingProperty().subscribe(_ -> update());
        editor.situationProperty().map(s -> s.inWork().isPresent() ? editor.document().name() : "").subscribe(_ -> update());
    }

    private void update() {
        RenderState state = picture.renderingProperty().get();
        status.setText(text(state));
        status.setAccessibleText(status.getText().isEmpty() ? Texts.of("What the last update did") : status.getText());
        String click = Texts.of("\nA click shows what the last updates did.");
        whole.setText((state.frame() == null ? status.getText() : StatusText.of(state.frame(), state.saving())) + click);
    }

    private String text(RenderState state) {
        if (state.problem() != null) {
            return Sentence.of(state.problem());
        }
        if (editor.situationProperty().get().inWork().isPresent() && state.plan() != null && state.frame() == null) {
            return Texts.of("Tracing {0} …", editor.document().name());
        }
        if (state.cancelled()) {
            return Texts.of("Cancelled");
        }
        if (state.verification() != null) {
            return StatusText.of(state.verification(), state.frame());
        }
        return state.frame() == null ? "" : StatusText.brief(state.frame());
    }
}

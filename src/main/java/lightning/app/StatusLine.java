package lightning.app;

import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.app.model.EditorModel;
import lightning.app.model.Sentence;
import lightning.app.model.StatusText;
import lightning.edit.loop.RenderState;

/** What the last update did and cost, and what the artist should read next. */
final class StatusLine extends HBox {
    private final EditorModel model;
    private final Label status = new Label();
    private final Label message = new Label();

    StatusLine(EditorModel model) {
        this.model = model;
        getStyleClass().add("status-line");
        status.setId("status");
        message.setId("message");
        message.getStyleClass().add("status-message");
        message.setMinWidth(Region.USE_PREF_SIZE);
        var whole = new Tooltip();
        whole.setWrapText(true);
        whole.setMaxWidth(600);
        whole.textProperty().bind(status.textProperty());
        status.setTooltip(whole);
        HBox.setHgrow(status, Priority.ALWAYS);
        status.setMaxWidth(Double.MAX_VALUE);
        getChildren().addAll(status, message);
        model.messageProperty().subscribe(text -> {
            message.setText(text);
            message.setManaged(!text.isEmpty());
        });
        model.renderingProperty().subscribe(_ -> update());
        model.situationProperty().map(s -> s.inWork().isPresent() ? model.document().name() : "").subscribe(_ -> update());
    }

    private void update() {
        status.setText(text(model.renderingProperty().get()));
    }

    private String text(RenderState state) {
        if (state.problem() != null) {
            return Sentence.of(state.problem());
        }
        if (model.situationProperty().get().inWork().isPresent() && state.plan() != null && state.frame() == null) {
            return "Tracing " + model.document().name() + " …";
        }
        if (state.cancelled()) {
            return "Cancelled";
        }
        if (state.verification() != null) {
            return StatusText.of(state.verification(), state.frame());
        }
        return state.frame() == null ? "" : StatusText.of(state.frame(), state.saving());
    }
}

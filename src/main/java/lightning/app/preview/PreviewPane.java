package lightning.app.preview;

import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.StackPane;
import lightning.app.command.CommandButton;
import lightning.app.command.SizeMenu;
import lightning.app.model.EditorModel;
import lightning.app.widget.PaneHeader;
import lightning.edit.PreviewCamera;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** The interactive preview: every light in real time, and the place where lights are taken by hand. */
public final class PreviewPane extends BorderPane implements AutoCloseable {
    private final EditorModel model;
    private final PreviewCanvas canvas;

    public PreviewPane(EditorModel model) {
        this.model = model;
        setId("preview");
        getStyleClass().add("canvas-pane");
        canvas = new PreviewCanvas(model);
        var waiting = new Label("Drawing …");
        waiting.getStyleClass().add("canvas-note");
        waiting.visibleProperty().bind(canvas.emptyProperty());
        waiting.setMouseTransparent(true);
        var stage = new StackPane(canvas, waiting);
        stage.getStyleClass().add("canvas");
        setTop(header());
        setCenter(stage);
        var hint = new Label("Left: rotate · Middle or Alt: along the view · Right: in the plane · Shift: camera");
        hint.getStyleClass().add("pane-footer");
        hint.setMaxWidth(Double.MAX_VALUE);
        hint.setWrapText(true);
        setBottom(hint);
    }

    public PreviewCanvas canvas() {
        return canvas;
    }

    private Node header() {
        var sizes = new MenuButton(canvas.sizeProperty().get().title());
        sizes.setId("preview-size");
        sizes.getStyleClass().add("flat");
        sizes.setTooltip(new Tooltip("Size of the preview's canvas"));
        sizes.getItems().setAll(SizeMenu.ofPreview(canvas.sizeProperty()));
        canvas.sizeProperty().subscribe(v -> sizes.setText(v.title()));
        var all = new Button("All");
        all.setId("view-all");
        all.setAccessibleText("Show all lights");
        all.setTooltip(new Tooltip("Go back until all lights are in view (A)"));
        all.getStyleClass().add("view-button");
        all.setOnAction(_ -> canvas.frameLights());
        return new PaneHeader("Preview", sizes, all,
                view("view-x", "X", "Along the x axis (X)", () -> PreviewCamera.alongX(model.scene())),
                view("view-y", "−Y", "From above, along the negative y axis (Y)", () -> PreviewCamera.alongMinusY(model.scene())),
                view("view-z", "−Z", "Reset: the scene's own camera (Z)", () -> PreviewCamera.of(model.scene())),
                gizmos(), eye());
    }

    /** Down, and seen to be, while something is missing. */
    private ToggleButton gizmos() {
        var hide = new ToggleButton("", new FontIcon(MaterialDesignC.CONE_OFF));
        hide.setId("gizmos");
        hide.setAccessibleText("Hide the lights' gizmos");
        hide.setTooltip(new Tooltip("Hide the lights' gizmos (G)\nWhile they are hidden, the mouse takes no light."));
        hide.getStyleClass().add("view-button");
        var shown = model.previewLook().gizmosProperty();
        shown.subscribe(on -> hide.setSelected(!on));
        hide.setOnAction(_ -> shown.set(!hide.isSelected()));
        return hide;
    }

    private CommandButton eye() {
        var eye = CommandButton.lookThrough(model);
        eye.button().getStyleClass().add("view-button");
        return eye;
    }

    private Button view(String id, String title, String help, java.util.function.Supplier<PreviewCamera> camera) {
        var button = new Button(title);
        button.setId(id);
        button.setAccessibleText(help);
        button.setTooltip(new Tooltip(help));
        button.getStyleClass().add("view-button");
        button.setOnAction(_ -> model.previewCameraProperty().set(camera.get()));
        return button;
    }

    @Override
    public void close() {
        canvas.close();
    }
}

package lightning.editor.window.preview;

import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.PreviewCamera;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PaneHeader;

/** Interactive preview of all lights in real time, in which lights are moved with the mouse. */
public final class PreviewPane extends BorderPane implements AutoCloseable {
    /** Minimum height of a pane with a hint on the mouse, pixels. */
    private static final double MIN_HINT_HEIGHT = 330;

    private final PreviewSettings settings;
    private final CommandRegistry commands;
    private final PreviewCanvas canvas;

    public PreviewPane(EditorModel model) {
        settings = model.previewSettings();
        commands = model.commands();
        SceneEditor editor = model.editor();
        setId("preview");
        getStyleClass().add("canvas-pane");
        canvas = new PreviewCanvas(model);
        commands.setAction(Command.VIEW_X, () -> setCamera(PreviewCamera.alongX(editor.scene())));
        commands.setAction(Command.VIEW_Y, () -> setCamera(PreviewCamera.alongMinusY(editor.scene())));
        commands.setAction(Command.VIEW_Z, () -> setCamera(PreviewCamera.of(editor.scene())));
        commands.setAction(Command.VIEW_ALL, canvas::frameLights);
        var waiting = new Label(Messages.tr("Drawing …"));
        waiting.getStyleClass().add("canvas-note");
        waiting.visibleProperty().bind(canvas.emptyProperty());
        waiting.setMouseTransparent(true);
        var stage = new StackPane(canvas, waiting);
        stage.getStyleClass().add("canvas");
        setTop(header());
        setCenter(stage);
        var hint =
                new Label(Messages.tr("Left drag: rotate · Ctrl: orbit · Middle or Alt: dolly · Right: move · Shift: camera"));
        hint.getStyleClass().add("pane-footer");
        hint.setMaxWidth(Double.MAX_VALUE);
        hint.setWrapText(true);
        // In a low pane the picture needs the room more.
        hint.visibleProperty().bind(heightProperty().greaterThan(MIN_HINT_HEIGHT));
        hint.managedProperty().bind(hint.visibleProperty());
        setBottom(hint);
    }

    public PreviewCanvas canvas() {
        return canvas;
    }

    private Node header() {
        var sizes = new MenuButton(Messages.tr(canvas.sizeProperty().get().title()));
        sizes.setId("preview-size");
        sizes.getStyleClass().add("flat");
        sizes.setTooltip(new Tooltip(Messages.tr("Preview Resolution")));
        sizes.getItems().setAll(SizeMenu.previewSizeItems(commands, canvas.sizeProperty()));
        canvas.sizeProperty().subscribe(v -> sizes.setText(Messages.tr(v.title())));
        CommandButton frameAll = CommandButton.viewButton(commands, Command.VIEW_ALL, Messages.tr("Frame All"));
        CommandButton side = CommandButton.viewButton(commands, Command.VIEW_X, Messages.tr("Side"));
        CommandButton top = CommandButton.viewButton(commands, Command.VIEW_Y, Messages.tr("Top"));
        CommandButton camera = CommandButton.viewButton(commands, Command.VIEW_Z, Messages.tr("Camera"));
        return new PaneHeader(Messages.tr("Preview"), sizes, frameAll, side, top, camera,
                CommandButton.viewButton(commands, Command.HIDE_GIZMOS),
                CommandButton.viewButton(commands, Command.LOOK_THROUGH_LIGHT)).withOptional(sizes, frameAll, top, side, camera);
    }

    private void setCamera(PreviewCamera camera) {
        settings.cameraProperty().set(camera);
    }

    @Override
    public void close() {
        canvas.close();
    }
}

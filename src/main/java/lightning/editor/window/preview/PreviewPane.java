package lightning.editor.window.preview;

import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.document.CameraEdits;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.Command;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.CameraNavigation;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PaneHeader;
import org.kordamp.ikonli.javafx.FontIcon;

/** Interactive preview of all lights in real time, in which lights are moved with the mouse. */
public final class PreviewPane extends BorderPane implements AutoCloseable {
    private static final PseudoClass COMPACT = PseudoClass.getPseudoClass("compact");
    /** Minimum height of a pane with a hint on the mouse, pixels. */
    private static final double MIN_HINT_HEIGHT = 330;

    private final PreviewSettings settings;
    private final CommandRegistry commands;
    private final PreviewCanvas canvas;
    private final Node header;
    private final Node footer;

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
        commands.setAction(Command.USE_VIEW,
                () -> editor.editAndRenderOrReport(scene -> CameraEdits.use(scene, settings.cameraProperty().get()), null));
        var waiting = new Label(Messages.tr("Drawing …"));
        waiting.getStyleClass().add("canvas-note");
        waiting.visibleProperty().bind(canvas.emptyProperty());
        waiting.setMouseTransparent(true);
        var stage = new StackPane(canvas, waiting, caption(editor));
        stage.getStyleClass().add("canvas");
        header = header();
        footer = footer();
        header.managedProperty().bind(header.visibleProperty());
        footer.managedProperty().bind(footer.visibleProperty());
        // In a low pane the picture needs the room more.
        footer.visibleProperty().bind(heightProperty().greaterThan(MIN_HINT_HEIGHT).and(header.visibleProperty()));
        setTop(header);
        setCenter(stage);
        setBottom(footer);
    }

    /** Shows or hides header and footer; without them the pane is an inset of another one. */
    public void setCompact(boolean isCompact) {
        header.setVisible(!isCompact);
        pseudoClassStateChanged(COMPACT, isCompact);
    }

    public PreviewCanvas canvas() {
        return canvas;
    }

    /** Returns a label that says what the preview shows. */
    private Node caption(SceneEditor editor) {
        var caption = new Label();
        caption.setId("preview-caption");
        caption.getStyleClass().add("preview-caption");
        caption.setMouseTransparent(true);
        Runnable update = () -> caption.setText(canvas.caption());
        editor.editorStateProperty().subscribe(update);
        settings.cameraProperty().subscribe(update);
        settings.shadowsProperty().subscribe(update);
        StackPane.setAlignment(caption, Pos.BOTTOM_CENTER);
        return caption;
    }

    /** Returns the mouse actions and the choice of those that move the camera. */
    private Node footer() {
        var hint = new Label();
        hint.textProperty().bind(settings.navigationProperty().map(CameraNavigation::hint));
        hint.setWrapText(true);
        hint.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(hint, Priority.ALWAYS);
        var choice = new MenuButton("", new FontIcon(Command.NAVIGATION.icon()));
        choice.setId("navigation");
        choice.getStyleClass().addAll("button-icon", "flat", "small");
        choice.setAccessibleText(Command.NAVIGATION.title());
        choice.setTooltip(new Tooltip(Command.NAVIGATION.title() + "\n" + Command.NAVIGATION.help() + "."));
        choice.setMinWidth(Region.USE_PREF_SIZE);
        choice.getItems().setAll(PreviewMenuItems.navigationChoices(settings, CommandMenuItems.forMenu(commands, "preview-")));
        var footer = new HBox(hint, choice);
        footer.setAlignment(Pos.CENTER_LEFT);
        footer.getStyleClass().add("pane-footer");
        return footer;
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

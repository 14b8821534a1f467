package lightning.editor.window;

import javafx.beans.property.Property;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Separator;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.Spinner;
import javafx.scene.control.ToolBar;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.text.Font;
import javafx.scene.text.Text;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.traced.IndirectMenu;
import lightning.editor.window.traced.ReflectionMenu;
import lightning.editor.window.traced.SamplingMenu;
import lightning.scene.SceneElement;
import lightning.scene.value.SceneLimits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;

/** Tool bar of the editor (paper §3.3 to §3.7), with buttons grouped by purpose. */
final class EditorToolBar extends ToolBar {
    /** Width that a choice box takes in addition to its text, pixels. */
    private static final double ARROW_WIDTH = 40;
    /** Font size of the style sheet, pixels. */
    private static final double FONT_SIZE = 12;
    /** Gap between a control and its label, pixels. */
    private static final double NAME_GAP = 6;

    private final SceneEditor editor;
    private final CommandRegistry commands;

    EditorToolBar(EditorModel model) {
        editor = model.editor();
        commands = model.commands();
        setId("toolbar");
        add(Command.LOAD_FILE, Command.RELOAD, Command.SAVE_SCENE, Command.SAVE_IMAGE);
        getItems().add(separator());
        add(Command.UNDO, Command.REDO);
        getItems().add(separator());
        var go = CommandButton.titledButton(commands, Command.GO);
        go.button().getStyleClass().add("accent");
        getItems().addAll(go, CommandButton.titledButton(commands, Command.LIVE));
        add(Command.UPDATE_REFLECTIONS, Command.CANCEL, Command.VERIFY);
        getItems().addAll(separator(), precision(model.accuracyModeProperty()), size(model.layout()),
                labeled(Messages.tr("Bounces"), depth()), separator());
        add(Command.MAKE_ANIMATION, Command.ACCURACY_PANEL, Command.EFFECTS_PANEL);
    }

    private void add(Command... commandsToAdd) {
        for (Command command : commandsToAdd) {
            getItems().add(CommandButton.iconButton(commands, command));
        }
    }

    private static Node separator() {
        return new Separator(Orientation.VERTICAL);
    }

    /** Groups a control with its label, so that both move into the overflow menu together. */
    private static HBox labeled(String text, Control control) {
        var label = new Label(text);
        label.getStyleClass().add("pane-note");
        label.setMinWidth(Region.USE_PREF_SIZE);
        var box = new HBox(NAME_GAP, label, control);
        box.setAlignment(Pos.CENTER_LEFT);
        return box;
    }

    private static ChoiceBox<AccuracyMode> precision(Property<AccuracyMode> precision) {
        var choice = new ChoiceBox<AccuracyMode>();
        choice.setId("precision");
        choice.getItems().setAll(AccuracyMode.values());
        choice.valueProperty().bindBidirectional(precision);
        choice.setPrefWidth(maxTitleWidth(choice) + ARROW_WIDTH);
        choice.setMinWidth(Region.USE_PREF_SIZE);
        choice.setAccessibleText(Messages.tr("Accuracy"));
        var tooltip = new Tooltip();
        choice.setTooltip(tooltip);
        choice.valueProperty().subscribe(p -> tooltip.setText(Messages.tr("Accuracy: {0}\n{1}.", p, p.explanation())));
        return choice;
    }

    /** Returns the width of the longest title of a choice, pixels. The box itself would take the width of its menu. */
    private static double maxTitleWidth(ChoiceBox<?> choice) {
        return choice.getItems().stream().mapToDouble(item -> {
            var text = new Text(item.toString());
            text.setFont(Font.font(FONT_SIZE));
            return text.getLayoutBounds().getWidth();
        }).max().orElseThrow();
    }

    private MenuButton size(WindowLayout layout) {
        var sizes = new MenuButton("", new FontIcon(MaterialDesignR.RESIZE));
        sizes.setId("traced-sizes");
        sizes.setAccessibleText(Messages.tr("Resolution, anti-aliasing and indirect light"));
        sizes.setTooltip(
                new Tooltip(Messages.tr("Resolution, anti-aliasing and indirect light\nA new resolution renders the image in full.")));
        CommandMenuItems items = CommandMenuItems.forMenu(commands);
        sizes.getItems().setAll(SizeMenu.pictureSizeItems(editor, items, layout));
        sizes.getItems().addAll(new SeparatorMenuItem(), SamplingMenu.of(editor, items), IndirectMenu.of(editor, items),
                ReflectionMenu.of(editor, items));
        editor.sceneProperty().subscribe(s -> sizes.setText(s.picture().width() + " × " + s.picture().height() + SamplingMenu.text(s)));
        return sizes;
    }

    private Spinner<Integer> depth() {
        var depth = new Spinner<Integer>(0, SceneLimits.MAX_DEPTH, 0);
        depth.setId("depth");
        depth.setAccessibleText(Messages.tr("Reflection bounces"));
        depth.setTooltip(
                new Tooltip(Messages.tr("Reflection bounces (0 to {0})", SceneLimits.MAX_DEPTH)));
        editor.sceneProperty().subscribe(s -> depth.getValueFactory().setValue(s.picture().depth()));
        depth.valueProperty().subscribe(v -> {
            if (v != editor.scene().picture().depth()) {
                editor.editOrReport(scene -> EditOutcome.edit(scene, SceneElement.PICTURE, picture -> picture.withDepth(v)));
            }
        });
        return depth;
    }
}

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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Dial;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.Precision;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.traced.SamplingMenu;
import lightning.scene.Limits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;

/** The buttons of the canvas window (paper §3.3 to §3.7), grouped by what they are for. */
final class EditorToolBar extends ToolBar {
    /** What a choice takes beside its text, pixels. */
    private static final double ARROW = 40;
    /** As the style sheet has it, pixels. */
    private static final double FONT = 12;
    /** Between a control and its name, pixels. */
    private static final double NAME_GAP = 6;

    private final SceneEditor editor;
    private final Commands commands;

    EditorToolBar(SceneEditor editor, Commands commands, Property<Precision> precision) {
        this.editor = editor;
        this.commands = commands;
        setId("toolbar");
        add(Command.LOAD_FILE, Command.RELOAD, Command.SAVE_SCENE, Command.SAVE_IMAGE);
        getItems().add(gap());
        add(Command.UNDO, Command.REDO);
        getItems().add(gap());
        var go = CommandButton.titled(commands, Command.GO);
        go.button().getStyleClass().add("accent");
        getItems().addAll(go, CommandButton.titled(commands, Command.LIVE));
        add(Command.UPDATE_REFLECTIONS, Command.CANCEL, Command.VERIFY);
        getItems().addAll(gap(), precision(precision), size(), labelled(Texts.of("Depth"), depth()), gap());
        add(Command.MAKE_ANIMATION, Command.ACCURACY_PANEL, Command.EFFECTS_PANEL);
    }

    private void add(Command... added) {
        for (Command command : added) {
            getItems().add(CommandButton.icon(commands, command));
        }
    }

    private static Node gap() {
        return new Separator(Orientation.VERTICAL);
    }

    /** A control and its name, which go into the overflow together. */
    private static HBox labelled(String text, Control control) {
        var label = new Label(text);
        label.getStyleClass().add("pane-note");
        label.setMinWidth(Region.USE_PREF_SIZE);
        var both = new HBox(NAME_GAP, label, control);
        both.setAlignment(Pos.CENTER_LEFT);
        return both;
    }

    private static ChoiceBox<Precision> precision(Property<Precision> precision) {
        var choice = new ChoiceBox<Precision>();
        choice.setId("precision");
        choice.getItems().setAll(Precision.values());
        choice.valueProperty().bindBidirectional(precision);
        choice.setPrefWidth(widest(choice) + ARROW);
        choice.setMinWidth(Region.USE_PREF_SIZE);
        choice.setAccessibleText(Texts.of("Accuracy"));
        var tooltip = new Tooltip();
        choice.setTooltip(tooltip);
        choice.valueProperty().subscribe(p -> tooltip.setText(Texts.of("Accuracy: {0}\n{1}.", p, p.explanation())));
        return choice;
    }

    /** The longest title of a choice, pixels; the box itself would take as much as its menu. */
    private static double widest(ChoiceBox<?> choice) {
        return choice.getItems().stream().mapToDouble(item -> {
            var text = new Text(item.toString());
            text.setFont(Font.font(FONT));
            return text.getLayoutBounds().getWidth();
        }).max().orElseThrow();
    }

    private MenuButton size() {
        var sizes = new MenuButton("", new FontIcon(MaterialDesignR.RESIZE));
        sizes.setId("traced-sizes");
        sizes.setAccessibleText(Texts.of("Size and anti-aliasing of the traced picture"));
        sizes.setTooltip(new Tooltip(Texts.of("Size and anti-aliasing of the traced picture\nAnother size traces it anew; "
                + "other anti-aliasing is an edit, and Go computes what is missing.")));
        CommandItems items = CommandItems.of(commands);
        sizes.getItems().setAll(SizeMenu.ofPicture(editor, items));
        sizes.getItems().addAll(new SeparatorMenuItem(), SamplingMenu.of(editor, items));
        editor.sceneProperty().subscribe(s -> sizes.setText(s.picture().width() + " × " + s.picture().height() + SamplingMenu.text(s)));
        return sizes;
    }

    private Spinner<Integer> depth() {
        var depth = new Spinner<Integer>(0, Limits.MAX_DEPTH, 0);
        depth.setId("depth");
        depth.setAccessibleText(Texts.of("Recursion depth of mirrors"));
        depth.setTooltip(new Tooltip(Texts.of("Recursion depth\nHow many mirror bounces are followed, 0 to {0}.", Limits.MAX_DEPTH)));
        editor.sceneProperty().subscribe(s -> depth.getValueFactory().setValue(s.picture().depth()));
        depth.valueProperty().subscribe(v -> {
            if (v != editor.scene().picture().depth()) {
                editor.editOrReport(scene -> Dial.DEPTH.set(scene, "", v));
            }
        });
        return depth;
    }
}

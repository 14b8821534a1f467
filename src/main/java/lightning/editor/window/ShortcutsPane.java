package lightning.editor.window;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.KeyBindingButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.KeyBindings;
import lightning.editor.window.widget.TimeSlicedTask;

/** Table of mouse actions and keyboard shortcuts. The shortcuts of commands can be changed in it. */
final class ShortcutsPane extends GridPane {
    /**
     * Row of the table.
     *
     * @param mouse mouse action; empty if there is none
     * @param keys keyboard shortcut; empty if there is none
     */
    private record Row(String action, String mouse, String keys) {}

    private static final List<Row> LIGHTS = List.of(
            new Row(Messages.key("Select a light"), Messages.key("click"), Messages.key("[  and  ]")),
            new Row(Messages.key("Rotate it"), Messages.key("left drag"), Messages.key("arrows")),
            new Row(Messages.key("Orbit it around its target"), Messages.key("Ctrl + left drag"), ""),
            new Row(Messages.key("Move it in the view plane"), Messages.key("right drag"), Messages.key("Ctrl + arrows")),
            new Row(Messages.key("Move it along the view axis (up: away)"), Messages.key("middle drag, or Alt + drag"),
                    Messages.key("Page Up, Page Down")));
    private static final List<Row> CAMERA = List.of(
            new Row(Messages.key("Zoom"), Messages.key("Shift + drag up or down"), Messages.key("Shift + up, down")),
            new Row(Messages.key("Pan"), Messages.key("Shift + drag left or right"), Messages.key("Shift + left, right")),
            new Row(Messages.key("Rotate the scene"), Messages.key("Shift + drag from near the edge"),
                    Messages.key("Shift + Ctrl + arrows")),
            new Row(Messages.key("Orbit, pan, zoom with Maya navigation"), Messages.key("Alt + left, middle, right drag"), ""),
            new Row(Messages.key("Orbit, pan, zoom with Blender navigation"), Messages.key("middle drag, with Shift, with Ctrl"), ""),
            new Row(Messages.key("Side view, top view, scene camera"), Messages.key("Side, Top, Camera"), "X, Y, Z"),
            new Row(Messages.key("Frame all lights"), Messages.key("Frame All"), "A"),
            new Row(Messages.key("Look through the selected light"), Messages.key("eye button"), "L"),
            new Row(Messages.key("Hide or show light handles"), Messages.key("cone button"), "G"));
    private static final List<Row> PICTURE = List.of(
            new Row(Messages.key("Inspect a pixel"), Messages.key("hover"), ""),
            new Row(Messages.key("Select the object, or the light that shines most there"), Messages.key("click, double click"), ""),
            new Row(Messages.key("Open the menu of a pixel: its lights, placements, object"), Messages.key("right click"),
                    Messages.key("Menu, or Shift + F10")),
            new Row(Messages.key("Open an object's menu in the preview"), Messages.key("right click"), ""),
            new Row(Messages.key("Zoom"), Messages.key("wheel"), ""),
            new Row(Messages.key("Pan the image"), Messages.key("middle drag, or Space and drag"), ""),
            new Row(Messages.key("Rotate, orbit, or move the selected light or object"), Messages.key("as in the preview"), ""),
            new Row(Messages.key("Place a light with a tool of the Light menu"), Messages.key("click, or drag"), ""),
            new Row(Messages.key("Change the distance of a placed light"), Messages.key("drag the ring"), ""),
            new Row(Messages.key("Snap to round positions, angles, and distances"), Messages.key("Shift in a drag"), ""),
            new Row(Messages.key("Cancel a drag"), "", Messages.key("Esc")));
    private static final List<Row> LIST = List.of(
            new Row(Messages.key("Rename the selected light"), Messages.key("double click"), "F2"),
            new Row(Messages.key("Toggle it on or off"), Messages.key("bulb button"), Messages.key("Space")),
            new Row(Messages.key("Solo"), "S", "S"),
            new Row(Messages.key("Delete it"), "", Messages.key("Delete")));
    private static final List<Row> SHAPES = List.of(
            new Row(Messages.key("Select an object or its group"), Messages.key("click, or right click"), ""),
            new Row(Messages.key("Move, rotate, or scale it"), Messages.key("left drag an arrow, a ring, or the square"), ""),
            new Row(Messages.key("Hide or show it"), Messages.key("eye button"), "H"),
            new Row(Messages.key("Duplicate it"), "", Messages.key("Ctrl + D")),
            new Row(Messages.key("Rename it (in the list)"), Messages.key("double click"), "F2"),
            new Row(Messages.key("Delete it"), "", Messages.key("Delete")));
    private static final List<Row> NUMBERS = List.of(
            new Row(Messages.key("One step up or down"), Messages.key("click the upper or lower arrow"), Messages.key("up, down")),
            new Row(Messages.key("Large steps (× 10)"), Messages.key("with Ctrl"), Messages.key("Page Up, Page Down")),
            new Row(Messages.key("Small steps (× 0.1)"), Messages.key("with Shift"), Messages.key("Shift + up, down")),
            new Row(Messages.key("Restore the previous value"), "", Messages.key("Esc")));

    /** Width of the message about a pressed key, pixels. */
    private static final double MESSAGE_WIDTH = 300;

    ShortcutsPane(CommandRegistry commands) {
        setId("keys");
        // Takes the initial focus; otherwise the window would open scrolled to the first shortcut that can be changed.
        setFocusTraversable(true);
        setAccessibleText(Messages.tr("Mouse and keyboard shortcuts"));
        getStyleClass().add("keys");
        var text = new ColumnConstraints();
        text.setHgrow(Priority.ALWAYS);
        getColumnConstraints().setAll(text, new ColumnConstraints(), new ColumnConstraints());
        section(Messages.tr("Lights in the preview"), LIGHTS);
        section(Messages.tr("Preview camera"), CAMERA);
        section(Messages.tr("Rendered image"), PICTURE);
        section(Messages.tr("Light list"), LIST);
        section(Messages.tr("Objects (in the list and in the preview)"), SHAPES);
        section(Messages.tr("Numbers"), NUMBERS);
        addRow(getRowCount(), label(Messages.tr("Commands"), "keys-title"), label(Messages.tr("Click a shortcut to change it"), "caption"),
                resetAll(commands.keyBindings()));
        // These rows are below the visible part. Adding all of them together would block the window.
        TimeSlicedTask.whileVisible(this,
                Stream.of(Command.values()).filter(commands::hasAction).<Runnable>map(c -> () -> add(c, commands.keyBindings())).toList()
                        .iterator());
    }

    private void add(Command command, KeyBindings keys) {
        var title = label(command.plainTitle(), "keys-what");
        var message = label("", "keys-how");
        message.setWrapText(true);
        message.setMaxWidth(MESSAGE_WIDTH);
        var button = new KeyBindingButton(keys, command, message);
        addRow(getRowCount(), title, message, button);
        List.of(title, message, button).forEach(TimeSlicedTask::applyStyle);
    }

    private static Button resetAll(KeyBindings keys) {
        var reset = new Button(Messages.tr("Reset All Shortcuts"));
        reset.setId("reset-keys");
        reset.getStyleClass().add("small");
        reset.setOnAction(_ -> keys.reset());
        keys.changesProperty().subscribe(_ -> reset.setDisable(Stream.of(Command.values()).noneMatch(keys::isChanged)));
        return reset;
    }

    private void section(String title, List<Row> rows) {
        addRow(getRowCount(), label(title, "keys-title"), label(Messages.tr("Mouse"), "caption"), label(Messages.tr("Keys"), "caption"));
        for (Row row : rows) {
            addRow(getRowCount(), label(Messages.tr(row.action()), "keys-what"), label(Messages.tr(row.mouse()), "keys-how"),
                    label(Messages.tr(row.keys()), "keys-how"));
        }
    }

    private static Label label(String text, String styleClass) {
        var label = new Label(text);
        label.getStyleClass().add(styleClass);
        label.setMinWidth(Region.USE_PREF_SIZE);
        return label;
    }
}

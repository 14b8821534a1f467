package lightning.editor.window;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.command.KeyButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.Keys;
import lightning.editor.window.widget.Slices;

/** What mouse and keyboard do, as a table; the keys of commands can be changed in it. */
final class KeysPane extends GridPane {
    /** @param mouse empty where the mouse has nothing of its own; likewise {@code keys} */
    private record Row(String what, String mouse, String keys) {}

    private static final List<Row> LIGHTS = List.of(
            new Row(Texts.key("Select a light"), Texts.key("click"), Texts.key("[  and  ]")),
            new Row(Texts.key("Rotate it"), Texts.key("left drag"), Texts.key("arrows")),
            new Row(Texts.key("Carry it about what it aims at"), Texts.key("Ctrl + left drag"), ""),
            new Row(Texts.key("Move it in the viewing plane"), Texts.key("right drag"), Texts.key("Ctrl + arrows")),
            new Row(Texts.key("Move it along the view; up is away"), Texts.key("middle drag, or Alt + drag"),
                    Texts.key("Page Up, Page Down")));
    private static final List<Row> CAMERA = List.of(
            new Row(Texts.key("Zoom"), Texts.key("Shift + drag that begins upright"), Texts.key("Shift + up, down")),
            new Row(Texts.key("Pan"), Texts.key("Shift + drag that begins sideways"), Texts.key("Shift + left, right")),
            new Row(Texts.key("Turn the scene"), Texts.key("Shift + drag from near the edge"), Texts.key("Shift + Ctrl + arrows")),
            new Row(Texts.key("Along the x axis, from above, the scene's camera"), "X, −Y, −Z", "X, Y, Z"),
            new Row(Texts.key("All lights in view"), Texts.key("All"), "A"),
            new Row(Texts.key("Through the selected light, and back"), Texts.key("the eye"), "L"),
            new Row(Texts.key("Hide the gizmos, and show them again"), Texts.key("the crossed cone"), "G"));
    private static final List<Row> PICTURE = List.of(
            new Row(Texts.key("What a pixel is made of"), Texts.key("hover"), ""),
            new Row(Texts.key("Select the light that matters most there"), Texts.key("click"), ""),
            new Row(Texts.key("A menu with the shape's material, here or in the preview"), Texts.key("right click"), ""),
            new Row(Texts.key("Zoom"), Texts.key("wheel"), ""),
            new Row(Texts.key("Move the picture"), Texts.key("middle drag, or Space and drag"), ""),
            new Row(Texts.key("Turn, carry, move the selected light or shape"), Texts.key("as in the preview"), ""),
            new Row(Texts.key("What a light does, with a tool of the menu Light"), Texts.key("click, or drag"), ""),
            new Row(Texts.key("Take a light that was placed nearer or farther"), Texts.key("drag of its ring"), ""),
            new Row(Texts.key("Snap to round places, angles, distances"), Texts.key("Shift in a drag"), ""),
            new Row(Texts.key("Give a drag up"), "", Texts.key("Esc")));
    private static final List<Row> LIST = List.of(
            new Row(Texts.key("Rename the selected light"), Texts.key("double click"), "F2"),
            new Row(Texts.key("Switch it on or off"), Texts.key("the bulb"), Texts.key("Space")),
            new Row(Texts.key("Let it shine alone"), "S", "S"),
            new Row(Texts.key("Delete it"), "", Texts.key("Delete")));
    private static final List<Row> SHAPES = List.of(
            new Row(Texts.key("Select a shape, or its group"), Texts.key("click, or right click"), ""),
            new Row(Texts.key("Move, turn, scale it"), Texts.key("left drag of an arrow, a ring, the square"), ""),
            new Row(Texts.key("Hide it, and show it again"), Texts.key("the eye"), "H"),
            new Row(Texts.key("Duplicate it"), "", Texts.key("Ctrl + D")),
            new Row(Texts.key("Rename it, in the list"), Texts.key("double click"), "F2"),
            new Row(Texts.key("Delete it"), "", Texts.key("Delete")));
    private static final List<Row> NUMBERS = List.of(
            new Row(Texts.key("One step more or less"), Texts.key("click the arrow's upper or lower half"), Texts.key("up, down")),
            new Row(Texts.key("Ten steps"), Texts.key("the same with Ctrl"), Texts.key("Page Up, Page Down")),
            new Row(Texts.key("A tenth of a step"), Texts.key("the same with Shift"), Texts.key("Shift + up, down")),
            new Row(Texts.key("Bring the old value back"), "", Texts.key("Escape")));

    /** What is told of a key that is pressed, pixels wide. */
    private static final double TOLD = 300;

    KeysPane(Commands commands) {
        setId("keys");
        // It has the keyboard first: else the window would open scrolled to the first key that can be changed.
        setFocusTraversable(true);
        setAccessibleText(Texts.of("Mouse and keyboard"));
        getStyleClass().add("keys");
        var text = new ColumnConstraints();
        text.setHgrow(Priority.ALWAYS);
        getColumnConstraints().setAll(text, new ColumnConstraints(), new ColumnConstraints());
        section(Texts.of("Lights, in the preview"), LIGHTS);
        section(Texts.of("The preview's camera"), CAMERA);
        section(Texts.of("The traced picture"), PICTURE);
        section(Texts.of("The list of lights"), LIST);
        section(Texts.of("Shapes, in their list and in the preview"), SHAPES);
        section(Texts.of("Numbers"), NUMBERS);
        addRow(getRowCount(), label(Texts.of("Commands"), "keys-title"), label(Texts.of("Click a key to change it"), "caption"),
                resetAll(commands.keys()));
        // They are below what is seen first, and so many that all together would hold up the window.
        Slices.whileSeen(this,
                Stream.of(Command.values()).filter(commands::isDone).<Runnable>map(c -> () -> add(c, commands.keys())).toList().iterator());
    }

    private void add(Command command, Keys keys) {
        var what = label(command.plainTitle(), "keys-what");
        var told = label("", "keys-how");
        told.setWrapText(true);
        told.setMaxWidth(TOLD);
        var key = new KeyButton(keys, command, told);
        addRow(getRowCount(), what, told, key);
        List.of(what, told, key).forEach(Slices::style);
    }

    private static Button resetAll(Keys keys) {
        var reset = new Button(Texts.of("Reset All Keys"));
        reset.setId("reset-keys");
        reset.getStyleClass().add("small");
        reset.setOnAction(_ -> keys.reset());
        keys.changesProperty().subscribe(_ -> reset.setDisable(Stream.of(Command.values()).noneMatch(keys::isChanged)));
        return reset;
    }

    private void section(String title, List<Row> rows) {
        addRow(getRowCount(), label(title, "keys-title"), label(Texts.of("Mouse"), "caption"), label(Texts.of("Keys"), "caption"));
        for (Row row : rows) {
            addRow(getRowCount(), label(Texts.of(row.what()), "keys-what"), label(Texts.of(row.mouse()), "keys-how"),
                    label(Texts.of(row.keys()), "keys-how"));
        }
    }

    private static Label label(String text, String styleClass) {
        var label = new Label(text);
        label.getStyleClass().add(styleClass);
        label.setMinWidth(Region.USE_PREF_SIZE);
        return label;
    }
}

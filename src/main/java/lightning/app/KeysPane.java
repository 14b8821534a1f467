package lightning.app;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.app.command.KeyButton;
import lightning.app.model.EditorModel;
import lightning.edit.Command;

/** What mouse and keyboard do, as a table; the keys of commands can be changed in it. */
final class KeysPane extends GridPane {
    /** @param mouse empty where the mouse has nothing of its own; likewise {@code keys} */
    private record Row(String what, String mouse, String keys) {}

    private static final List<Row> LIGHTS = List.of(
            new Row("Select a light", "click", "[  and  ]"),
            new Row("Rotate it", "left drag", "arrows"),
            new Row("Carry it about what it aims at", "Ctrl + left drag", ""),
            new Row("Move it in the viewing plane", "right drag", "Ctrl + arrows"),
            new Row("Move it along the view; up is away", "middle drag, or Alt + drag", "Page Up, Page Down"));
    private static final List<Row> CAMERA = List.of(
            new Row("Zoom", "Shift + drag that begins upright", "Shift + up, down"),
            new Row("Pan", "Shift + drag that begins sideways", "Shift + left, right"),
            new Row("Turn the scene", "Shift + drag from near the edge", "Shift + Ctrl + arrows"),
            new Row("Along the x axis, from above, the scene's camera", "X, −Y, −Z", "X, Y, Z"),
            new Row("All lights in view", "All", "A"),
            new Row("Through the selected light, and back", "the eye", "L"),
            new Row("Hide the gizmos, and show them again", "the crossed cone", "G"));
    private static final List<Row> PICTURE = List.of(
            new Row("What a pixel is made of", "hover", ""),
            new Row("Select the light that matters most there", "click", ""),
            new Row("A menu with the shape's material, here or in the preview", "right click", ""),
            new Row("Zoom", "wheel", ""),
            new Row("Move the picture", "middle drag, or Space and drag", ""),
            new Row("Turn, carry, move the selected light or shape", "as in the preview", ""),
            new Row("What a light does, with a tool of the menu Light", "click, or drag", ""),
            new Row("Take a light that was placed nearer or farther", "drag of its ring", ""),
            new Row("Snap to round places, angles, distances", "Shift in a drag", ""),
            new Row("Give a drag up", "", "Esc"));
    private static final List<Row> LIST = List.of(
            new Row("Rename the selected light", "double click", "F2"),
            new Row("Switch it on or off", "the bulb", "Space"),
            new Row("Let it shine alone", "S", "S"),
            new Row("Delete it", "", "Delete"));
    private static final List<Row> SHAPES = List.of(
            new Row("Select a shape, or its group", "click, or right click", ""),
            new Row("Move, turn, scale it", "left drag of an arrow, a ring, the square", ""),
            new Row("Hide it, and show it again", "the eye", "H"),
            new Row("Duplicate it", "", "Ctrl + D"),
            new Row("Rename it, in the list", "double click", "F2"),
            new Row("Delete it", "", "Delete"));
    private static final List<Row> NUMBERS = List.of(
            new Row("One step more or less", "click the arrow's upper or lower half", "up, down"),
            new Row("Ten steps", "the same with Ctrl", "Page Up, Page Down"),
            new Row("A tenth of a step", "the same with Shift", "Shift + up, down"),
            new Row("Bring the old value back", "", "Escape"));

    /** What is told of a key that is pressed, pixels wide. */
    private static final double TOLD = 300;

    KeysPane(EditorModel model) {
        setId("keys");
        // It has the keyboard first: else the window would open scrolled to the first key that can be changed.
        setFocusTraversable(true);
        setAccessibleText("Mouse and keyboard");
        getStyleClass().add("keys");
        var text = new ColumnConstraints();
        text.setHgrow(Priority.ALWAYS);
        getColumnConstraints().setAll(text, new ColumnConstraints(), new ColumnConstraints());
        section("Lights, in the preview", LIGHTS);
        section("The preview's camera", CAMERA);
        section("The traced picture", PICTURE);
        section("The list of lights", LIST);
        section("Shapes, in their list and in the preview", SHAPES);
        section("Numbers", NUMBERS);
        addRow(getRowCount(), label("Commands", "keys-title"), label("Click a key to change it", "caption"), resetAll(model));
        Stream.of(Command.values()).filter(model::isDone).forEach(c -> {
            var what = label(c.plainTitle(), "keys-what");
            var told = label("", "keys-how");
            told.setWrapText(true);
            told.setMaxWidth(TOLD);
            addRow(getRowCount(), what, told, new KeyButton(model.keys(), c, told));
        });
    }

    private static Button resetAll(EditorModel model) {
        var reset = new Button("Reset All Keys");
        reset.setId("reset-keys");
        reset.getStyleClass().add("small");
        reset.setOnAction(_ -> model.keys().reset());
        model.keys().changesProperty().subscribe(_ -> reset.setDisable(Stream.of(Command.values()).noneMatch(model.keys()::isChanged)));
        return reset;
    }

    private void section(String title, List<Row> rows) {
        addRow(getRowCount(), label(title, "keys-title"), label("Mouse", "caption"), label("Keys", "caption"));
        for (Row row : rows) {
            addRow(getRowCount(), label(row.what(), "keys-what"), label(row.mouse(), "keys-how"), label(row.keys(), "keys-how"));
        }
    }

    private static Label label(String text, String styleClass) {
        var label = new Label(text);
        label.getStyleClass().add(styleClass);
        label.setMinWidth(Region.USE_PREF_SIZE);
        return label;
    }
}

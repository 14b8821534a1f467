package lightning.editor.window.link;

import java.util.Map;
import javafx.geometry.Bounds;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import lightning.base.text.Messages;
import lightning.document.LinkTable;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/**
 * Mouse and keyboard of the matrix. A click links or unlinks, a drag to the side changes the gain, digits open a field for it. Space toggles,
 * Delete resets the gain.
 */
final class LinkInput {
    /** Tolerance for small movements during a click, pixels. */
    private static final double CLICK_PIXELS = 3;
    private static final double GAIN_PER_PIXEL = 0.01;
    private static final double FINE = 0.1;
    private static final double KEY_STEP = 0.05;
    private static final double DIGITS = 1000;
    private static final Map<KeyCode, int[]> MOVES = Map.of(KeyCode.UP, new int[] {-1, 0}, KeyCode.DOWN, new int[] {1, 0}, KeyCode.LEFT,
            new int[] {0, -1}, KeyCode.RIGHT, new int[] {0, 1});

    private final LinkMatrix matrix;
    private final LinkEditor editor;
    private final TextField field = new TextField();
    private @Nullable Drag drag;

    /** Press of the mouse on a cell. */
    private static final class Drag {
        private final Light light;
        private final LinkTable.Row row;
        private double x;
        private double gain;
        private boolean hasMoved;

        Drag(Light light, LinkTable.Row row, double x) {
            this.light = light;
            this.row = row;
            this.x = x;
            LinkTable.Link link = LinkTable.link(light, row);
            gain = link.state() == LinkTable.State.OFF ? 0 : link.gain();
        }
    }

    private LinkInput(LinkMatrix matrix, LinkEditor editor) {
        this.matrix = matrix;
        this.editor = editor;
    }

    /** @param above pane above the matrix that shows the field for a gain */
    static void install(LinkMatrix matrix, LinkEditor editor, Pane above) {
        var input = new LinkInput(matrix, editor);
        matrix.addEventHandler(MouseEvent.MOUSE_PRESSED, input::press);
        matrix.addEventHandler(MouseEvent.MOUSE_DRAGGED, input::dragGain);
        matrix.addEventHandler(MouseEvent.MOUSE_RELEASED, input::release);
        matrix.addEventHandler(MouseEvent.MOUSE_MOVED, input::point);
        matrix.addEventHandler(MouseEvent.MOUSE_EXITED, _ -> matrix.setPointer(-1, -1));
        matrix.addEventHandler(KeyEvent.KEY_PRESSED, input::handleKey);
        matrix.addEventHandler(KeyEvent.KEY_TYPED, input::handleCharacter);
        input.installField(above);
    }

    private void installField(Pane above) {
        field.setId("link-gain");
        field.setAccessibleText(Messages.tr("gain in percent"));
        field.setManaged(false);
        field.setVisible(false);
        above.getChildren().add(field);
        field.setOnAction(_ -> {
            commitField();
            matrix.requestFocus();
        });
        field.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                field.setVisible(false);
                matrix.requestFocus();
                event.consume();
            }
        });
        field.focusedProperty().subscribe((_, focused) -> {
            if (!focused) {
                commitField();
            }
        });
    }

    /** Sets the gain in the field, if it is open, and closes it. */
    private void commitField() {
        if (!field.isVisible()) {
            return;
        }
        field.setVisible(false);
        if (!matrix.isEmpty()) {
            LinkEditor.parsePercent(field.getText(),
                    gain -> editor.setGain(matrix.currentLight(), matrix.currentRow(), gain, null, false));
            describe();
        }
    }

    private void openField(String text) {
        LinkCell cell = matrix.currentCell();
        if (cell == null) {
            return;
        }
        Bounds at = cell.getBoundsInParent();
        field.setText(text);
        field.resizeRelocate(at.getMinX() - 8, at.getMinY() - 2, at.getWidth() + 16, at.getHeight() + 4);
        field.setVisible(true);
        field.requestFocus();
        field.selectRange(text.length(), text.length());
    }

    private void press(MouseEvent event) {
        matrix.requestFocus();
        int row = matrix.rowAt(event.getY());
        int column = matrix.columnAt(event.getX());
        if (event.getButton() != MouseButton.PRIMARY || matrix.isEmpty()) {
            return;
        }
        if (row >= 0 && column >= 0) {
            matrix.setCurrent(row, column);
            drag = new Drag(matrix.currentLight(), matrix.currentRow(), event.getX());
        } else if (column >= 0 && event.getY() < matrix.headerHeight()) {
            editor.selectLight(matrix.table().lights().get(column));
        } else if (row >= 0 && event.getX() < LinkMatrix.NAME_WIDTH) {
            LinkTable.Row object = matrix.table().rows().get(row);
            if (object.isGroup() && event.getX() < LinkMatrix.foldEnd(object)) {
                editor.toggleGroup(object);
            } else {
                editor.selectObject(object);
            }
        }
        event.consume();
    }

    private void dragGain(MouseEvent event) {
        if (drag == null || !drag.hasMoved && Math.abs(event.getX() - drag.x) < CLICK_PIXELS) {
            return;
        }
        drag.hasMoved = true;
        drag.gain = Math.max(0, drag.gain + (event.getX() - drag.x) * GAIN_PER_PIXEL * (event.isShiftDown() ? FINE : 1));
        drag.x = event.getX();
        editor.setGain(drag.light, drag.row, Math.rint(drag.gain * DIGITS) / DIGITS, drag, true);
        describe();
        event.consume();
    }

    private void release(MouseEvent event) {
        if (drag == null) {
            return;
        }
        Drag done = drag;
        drag = null;
        if (done.hasMoved) {
            editor.setGain(done.light, done.row, Math.rint(done.gain * DIGITS) / DIGITS, done, false);
        } else {
            editor.toggle(done.light, done.row);
        }
        describe();
        event.consume();
    }

    private void point(MouseEvent event) {
        int row = matrix.rowAt(event.getY());
        int column = matrix.columnAt(event.getX());
        matrix.setPointer(row, column);
        if (row >= 0 && column >= 0) {
            editor.describe(matrix.table().lights().get(column), matrix.table().rows().get(row));
        }
    }

    private void describe() {
        editor.describe(matrix.currentLight(), matrix.currentRow());
    }

    private void handleKey(KeyEvent event) {
        if (matrix.isEmpty() || event.isShortcutDown() || event.isAltDown()) {
            return;
        }
        Light light = matrix.currentLight();
        LinkTable.Row row = matrix.currentRow();
        int[] move = MOVES.get(event.getCode());
        if (move != null) {
            matrix.moveCurrent(move[0], move[1]);
        } else {
            switch (event.getCode()) {
                case PAGE_UP -> matrix.moveCurrent(-matrix.visibleRows(), 0);
                case PAGE_DOWN -> matrix.moveCurrent(matrix.visibleRows(), 0);
                case HOME -> matrix.setCurrent(0, 0);
                case END -> matrix.setCurrent(matrix.table().rows().size() - 1, matrix.table().lights().size() - 1);
                case SPACE -> editor.toggle(light, row);
                case DELETE, BACK_SPACE -> editor.resetGain(light, row);
                case ENTER -> openField(SceneLimits.format(Math.rint(LinkTable.link(light, row).gain() * 1e6) / 1e4));
                case ADD, PLUS -> step(light, row, KEY_STEP);
                case SUBTRACT, MINUS -> step(light, row, -KEY_STEP);
                default -> {
                    return;
                }
            }
        }
        describe();
        event.consume();
    }

    private void step(Light light, LinkTable.Row row, double by) {
        editor.setGain(light, row, Math.rint((LinkTable.link(light, row).gain() + by) * DIGITS) / DIGITS, null, false);
    }

    private void handleCharacter(KeyEvent event) {
        String typed = event.getCharacter();
        if (!matrix.isEmpty() && typed.length() == 1 && Character.isDigit(typed.charAt(0)) && !event.isShortcutDown()) {
            openField(typed);
            event.consume();
        }
    }
}

package lightning.editor.window.link;

import java.util.ArrayList;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.AccessibleRole;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollBar;
import javafx.scene.control.Tooltip;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.document.LinkTable;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Matrix of lights and objects whose headers stay in place. Only visible cells have nodes, which scrolling reuses; it moves by whole rows and
 * columns.
 */
final class LinkMatrix extends Region {
    static final double ROW_HEIGHT = 24;
    static final double NAME_WIDTH = 190;
    private static final double TILTED_HEADER = 110;
    private static final double MIN_COLUMN = 46;
    private static final double MAX_COLUMN = 120;
    /** Columns of at least this width have horizontal titles. */
    private static final double HORIZONTAL_TITLE = 90;
    private static final double INDENT = 14;
    private static final double BAR = 14;
    private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");

    private final Pane content = new Pane() {
        @Override
        protected void layoutChildren() {
            place();
        }
    };
    private final ScrollBar vertical = new ScrollBar();
    private final ScrollBar horizontal = new ScrollBar();
    private final List<Label> titles = new ArrayList<>();
    private final List<Label> names = new ArrayList<>();
    private final List<List<LinkCell>> cells = new ArrayList<>();
    private LinkTable table = new LinkTable(List.of(), List.of(), false);
    private String selectedLight = "";
    private int currentRow;
    private int currentColumn;
    private int pointerRow = -1;
    private int pointerColumn = -1;

    LinkMatrix() {
        setId("link-matrix");
        getStyleClass().add("link-matrix");
        setAccessibleRole(AccessibleRole.TABLE_VIEW);
        setAccessibleText(Messages.tr("links of lights and objects"));
        setFocusTraversable(true);
        setMinSize(NAME_WIDTH + 2 * MIN_COLUMN, 4 * ROW_HEIGHT);
        vertical.setOrientation(Orientation.VERTICAL);
        for (ScrollBar bar : List.of(vertical, horizontal)) {
            bar.setFocusTraversable(false);
            bar.setUnitIncrement(1);
            bar.valueProperty().addListener(_ -> refresh());
        }
        getChildren().addAll(content, vertical, horizontal);
        addEventHandler(ScrollEvent.SCROLL, this::scroll);
        focusedProperty().addListener(_ -> refresh());
    }

    void show(LinkTable newTable, String light) {
        table = newTable;
        selectedLight = light;
        currentRow = Math.clamp(currentRow, 0, Math.max(0, table.rows().size() - 1));
        currentColumn = Math.clamp(currentColumn, 0, Math.max(0, table.lights().size() - 1));
        requestLayout();
        refresh();
    }

    LinkTable table() {
        return table;
    }

    boolean isEmpty() {
        return table.rows().isEmpty() || table.lights().isEmpty();
    }

    LinkTable.Row currentRow() {
        return table.rows().get(currentRow);
    }

    Light currentLight() {
        return table.lights().get(currentColumn);
    }

    /** Moves the keyboard's cell by rows and columns, and scrolls to it. */
    void moveCurrent(int rows, int columns) {
        setCurrent(Math.clamp(currentRow + rows, 0, table.rows().size() - 1),
                Math.clamp(currentColumn + columns, 0, table.lights().size() - 1));
    }

    /** Moves the keyboard's cell to the selected light's column, and scrolls to it. */
    void showSelectedLight() {
        for (int column = 0; column < table.lights().size(); column++) {
            if (table.lights().get(column).name().equals(selectedLight)) {
                setCurrent(currentRow, column);
            }
        }
    }

    void setCurrent(int row, int column) {
        currentRow = row;
        currentColumn = column;
        scrollTo(vertical, row, visibleRows());
        scrollTo(horizontal, column, visibleColumns());
        refresh();
    }

    private static void scrollTo(ScrollBar bar, int index, int visible) {
        bar.setValue(Math.clamp(bar.getValue(), Math.max(0, index - visible + 1), index));
    }

    /** Highlights the row and the column of the pointer; −1 for none. */
    void setPointer(int row, int column) {
        if (row != pointerRow || column != pointerColumn) {
            pointerRow = row;
            pointerColumn = column;
            refresh();
        }
    }

    private void scroll(ScrollEvent event) {
        boolean sideways = event.isShiftDown() || Math.abs(event.getDeltaX()) > Math.abs(event.getDeltaY());
        ScrollBar bar = sideways ? horizontal : vertical;
        double delta = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
        bar.setValue(Math.clamp(bar.getValue() - Math.signum(delta) * (sideways ? 1 : 3), 0, bar.getMax()));
        event.consume();
    }

    private double columnWidth() {
        double room = getWidth() - NAME_WIDTH - BAR;
        return Math.clamp(Math.floor(room / Math.max(1, table.lights().size())), MIN_COLUMN, MAX_COLUMN);
    }

    private boolean hasHorizontalTitles() {
        return columnWidth() >= HORIZONTAL_TITLE;
    }

    double headerHeight() {
        return hasHorizontalTitles() ? ROW_HEIGHT + 4 : TILTED_HEADER;
    }

    int visibleRows() {
        return (int) Math.max(1, Math.floor((getHeight() - headerHeight() - BAR) / ROW_HEIGHT));
    }

    private int visibleColumns() {
        return (int) Math.max(1, Math.floor((getWidth() - NAME_WIDTH - BAR) / columnWidth()));
    }

    /** Returns the row at a position; −1 in the header and below the last row. */
    int rowAt(double y) {
        int row = (int) Math.floor((y - headerHeight()) / ROW_HEIGHT);
        return y < headerHeight() || row >= visibleRows() || first(vertical) + row >= table.rows().size() ? -1 : first(vertical) + row;
    }

    /** Returns the column at a position; −1 in the names and after the last column. */
    int columnAt(double x) {
        int column = (int) Math.floor((x - NAME_WIDTH) / columnWidth());
        return x < NAME_WIDTH || column >= visibleColumns() || first(horizontal) + column >= table.lights().size() ? -1
                : first(horizontal) + column;
    }

    /** Returns the position after the fold mark of a row's name. */
    static double foldEnd(LinkTable.Row row) {
        return INDENT * row.depth() + 20;
    }

    private static int first(ScrollBar bar) {
        return (int) Math.round(bar.getValue());
    }

    /** Returns the visible cell of the keyboard; null if there is none. */
    @Nullable
    LinkCell currentCell() {
        int row = currentRow - first(vertical);
        int column = currentColumn - first(horizontal);
        return row < 0 || column < 0 || row >= cells.size() || column >= cells.get(row).size() ? null : cells.get(row).get(column);
    }

    @Override
    protected void layoutChildren() {
        double width = getWidth() - BAR;
        double height = getHeight() - BAR;
        content.resizeRelocate(0, 0, width, height);
        vertical.resizeRelocate(width, headerHeight(), BAR, Math.max(0, height - headerHeight()));
        horizontal.resizeRelocate(NAME_WIDTH, height, Math.max(0, width - NAME_WIDTH), BAR);
        setRange(vertical, table.rows().size(), visibleRows());
        setRange(horizontal, table.lights().size(), visibleColumns());
        createCells(Math.min(visibleRows(), table.rows().size()), Math.min(visibleColumns(), table.lights().size()));
        refresh();
    }

    private static void setRange(ScrollBar bar, int count, int visible) {
        int max = Math.max(0, count - visible);
        bar.setMax(max);
        bar.setVisibleAmount(count == 0 ? 0 : (double) max * visible / count);
        bar.setBlockIncrement(visible);
        bar.setVisible(max > 0);
        bar.setValue(Math.min(bar.getValue(), max));
    }

    private void createCells(int rows, int columns) {
        if (cells.size() != rows || rows > 0 && cells.getFirst().size() != columns || titles.size() != columns) {
            titles.clear();
            names.clear();
            cells.clear();
            for (int c = 0; c < columns; c++) {
                titles.add(label("link-title"));
            }
            for (int r = 0; r < rows; r++) {
                names.add(label("link-name"));
                List<LinkCell> line = new ArrayList<>();
                for (int c = 0; c < columns; c++) {
                    line.add(new LinkCell());
                }
                cells.add(line);
            }
            content.getChildren().setAll(titles);
            content.getChildren().addAll(names);
            cells.forEach(content.getChildren()::addAll);
        }
        place();
    }

    private static Label label(String style) {
        var label = new Label();
        label.getStyleClass().add(style);
        label.setMnemonicParsing(false);
        label.setTooltip(new Tooltip());
        return label;
    }

    private void place() {
        double width = columnWidth();
        double header = headerHeight();
        for (int c = 0; c < titles.size(); c++) {
            double x = NAME_WIDTH + c * width;
            boolean flat = hasHorizontalTitles();
            // A turned label is laid out around its center.
            titles.get(c).setRotate(flat ? 0 : -90);
            titles.get(c).resizeRelocate(flat ? x : x + (width - header) / 2, flat ? 0 : (header - width) / 2, flat ? width : header,
                    flat ? header : width);
        }
        for (int r = 0; r < names.size(); r++) {
            names.get(r).resizeRelocate(0, header + r * ROW_HEIGHT, NAME_WIDTH, ROW_HEIGHT);
            for (int c = 0; c < titles.size(); c++) {
                cells.get(r).get(c).resizeRelocate(NAME_WIDTH + c * width, header + r * ROW_HEIGHT, width, ROW_HEIGHT);
            }
        }
    }

    /** Shows the table in the visible cells. */
    private void refresh() {
        int top = first(vertical);
        int left = first(horizontal);
        for (int c = 0; c < titles.size() && left + c < table.lights().size(); c++) {
            Light light = table.lights().get(left + c);
            setText(titles.get(c), light.name(), light.name().equals(selectedLight) || left + c == pointerColumn);
        }
        for (int r = 0; r < names.size() && top + r < table.rows().size(); r++) {
            LinkTable.Row row = table.rows().get(top + r);
            names.get(r).setPadding(new javafx.geometry.Insets(0, 4, 0, 6 + INDENT * row.depth()));
            setText(names.get(r), (row.isGroup() ? row.isOpen() ? "▾ " : "▸ " : "   ") + row.name(), top + r == pointerRow);
            for (int c = 0; c < titles.size() && left + c < table.lights().size(); c++) {
                boolean isCurrent = isFocused() && top + r == currentRow && left + c == currentColumn;
                cells.get(r).get(c).show(LinkTable.link(table.lights().get(left + c), row), isCurrent,
                        top + r == pointerRow || left + c == pointerColumn);
            }
        }
    }

    private static void setText(Label label, String text, boolean isChosen) {
        label.pseudoClassStateChanged(CHOSEN, isChosen);
        if (!label.getText().equals(text)) {
            label.setText(text);
            label.getTooltip().setText(text.strip());
        }
    }
}

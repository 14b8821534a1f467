package lightning.editor.window.command;

import java.util.List;
import javafx.application.Platform;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.scene.text.Text;
import lightning.base.text.Messages;
import lightning.document.TextDifference;
import org.jspecify.annotations.Nullable;

/** Side-by-side view of two texts with marked and colored differences. */
final class TextDifferenceView extends VBox {
    private static final double WIDTH = 960;
    private static final double HEIGHT = 240;
    private static final double GAP = 12;
    /** Rows shown before the first difference. */
    private static final int CONTEXT_ROWS = 2;
    /** Width of the list's scroll bar and of the padding of its cells, pixels. */
    private static final double CELL_INSETS = 34;
    private static final int MIN_CHARACTERS = 20;
    private static final String SAME = "  ";
    private static final String DIFFERENT = "▸ ";
    private static final String GUTTER = "  ";

    TextDifferenceView(List<TextDifference.Row> rows) {
        getStyleClass().add("differences");
        var list = new ListView<TextDifference.Row>();
        list.setId("differences");
        list.setAccessibleText(Messages.tr("Line-by-line comparison"));
        list.getItems().setAll(rows);
        list.setCellFactory(_ -> new RowCell());
        list.setPrefSize(WIDTH, HEIGHT);
        VBox.setVgrow(list, Priority.ALWAYS);
        var titles = new HBox(GAP, setHalfWidth(new Label(Messages.tr("The open scene"))),
                setHalfWidth(new Label(Messages.tr("The file on disk"))));
        getChildren().addAll(titles, list);
        int first = 0;
        while (first < rows.size() && rows.get(first).isSame()) {
            first++;
        }
        int top = Math.max(0, first - CONTEXT_ROWS);
        // Before it has a height, a list scrolls to another row.
        list.heightProperty().addListener((_, before, _) -> {
            if (before.doubleValue() == 0) {
                Platform.runLater(() -> list.scrollTo(top));
            }
        });
        // Wider cells show more of their lines.
        list.widthProperty().addListener(_ -> list.refresh());
    }

    private static Label setHalfWidth(Label label) {
        label.setPrefWidth(WIDTH / 2);
        label.setMinWidth(0);
        label.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(label, Priority.ALWAYS);
        return label;
    }

    private static final class RowCell extends ListCell<TextDifference.Row> {
        private final Label mine = setHalfWidth(new Label());
        private final Label theirs = setHalfWidth(new Label());
        private final HBox columns = new HBox(GAP, mine, theirs);

        RowCell() {
            setPrefWidth(0);
        }

        @Override
        protected void updateItem(TextDifference.@Nullable Row row, boolean empty) {
            super.updateItem(row, empty);
            setGraphic(empty || row == null ? null : columns);
            if (row != null && !empty) {
                int digits = String.valueOf(Math.max(row.mineLine(), row.theirsLine())).length();
                TextDifference.Row shown = row.shortened(Math.max(MIN_CHARACTERS, characters() - SAME.length() - digits - GUTTER.length()));
                show(mine, shown.mineLine(), shown.mine(), row.isSame());
                show(theirs, shown.theirsLine(), shown.theirs(), row.isSame());
            }
        }

        /** Returns how many characters fit into a label. */
        private int characters() {
            var digit = new Text("0");
            digit.setFont(mine.getFont());
            double listWidth = getListView().getWidth();
            double width = (listWidth > 0 ? listWidth : WIDTH) - CELL_INSETS - GAP;
            return (int) (width / 2 / digit.getLayoutBounds().getWidth());
        }

        private static void show(Label label, int number, String line, boolean same) {
            label.setText(number == 0 ? "" : (same ? SAME : DIFFERENT) + number + GUTTER + line);
            label.getStyleClass().removeAll("difference");
            if (!same) {
                label.getStyleClass().add("difference");
            }
        }
    }
}

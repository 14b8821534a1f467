package lightning.editor.window.command;

import java.util.List;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.document.TextDifference;
import org.jspecify.annotations.Nullable;

/** Side-by-side view of two texts with marked and colored differences. */
final class TextDifferenceView extends VBox {
    private static final double WIDTH = 780;
    private static final double HEIGHT = 240;
    private static final double GAP = 12;
    /** Rows shown before the first difference. */
    private static final int CONTEXT_ROWS = 2;
    /** Maximum displayed line length. Labels of millions of characters would block the window. */
    private static final int MAX_CHARACTERS = 300;

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
        list.scrollTo(Math.max(0, first - CONTEXT_ROWS));
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
                show(mine, row.mineLine(), row.mine(), row.isSame());
                show(theirs, row.theirsLine(), row.theirs(), row.isSame());
            }
        }

        private static void show(Label label, int number, String line, boolean same) {
            String shortLine = line.length() > MAX_CHARACTERS ? line.substring(0, MAX_CHARACTERS) + " …" : line;
            label.setText(number == 0 ? "" : (same ? "   " : "▸ ") + number + "  " + shortLine);
            label.getStyleClass().removeAll("difference");
            if (!same) {
                label.getStyleClass().add("difference");
            }
        }
    }
}

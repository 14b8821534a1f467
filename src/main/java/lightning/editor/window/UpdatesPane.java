package lightning.editor.window;

import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.collections.ListChangeListener;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.UpdateLog;
import lightning.editor.window.model.UpdateLog.Entry;

/** Render log: plan, shading points, rays, time and accuracy of the last updates, newest first. */
final class UpdatesPane extends VBox {
    private static final DateTimeFormatter TIME_FORMAT = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

    private static final double MIN_TEXT_WIDTH = 120;

    private final TableView<Entry> table = new TableView<>();
    private final Label details = new Label();

    UpdatesPane(UpdateLog log) {
        setId("updates");
        getStyleClass().add("history");
        table.setId("updates-table");
        table.setAccessibleText(Messages.tr("updates"));
        table.getStyleClass().add("dense");
        table.setPlaceholder(new Label(Messages.tr("No image yet")));
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_ALL_COLUMNS);
        // In a narrow window the description is truncated; the line below the table shows all of it.
        addTextColumn(Messages.tr("At"), 80, e -> TIME_FORMAT.format(e.shownAt()));
        addTextColumn(Messages.tr("Change"), 270, e -> e.update().plan().description());
        table.getColumns().getLast().setMinWidth(MIN_TEXT_WIDTH);
        addNumberColumn(Messages.tr("Points"), 92, e -> StatusText.number(e.update().rowsTouched()));
        addNumberColumn(Messages.tr("Shadow rays"), 162, e -> StatusText.number(e.update().rays().shadow()));
        addNumberColumn(Messages.tr("All rays"), 126, e -> StatusText.number(e.update().rays().total()));
        addNumberColumn(Messages.tr("Time"), 86, e -> StatusText.time(e.update().milliseconds()));
        addNumberColumn(Messages.tr("Saved"), 92, e -> e.saving().map(s -> StatusText.savingText(s.percent() / 100)).orElse("–"));
        addTextColumn(Messages.tr("Image"), 92, e -> e.isFinished() ? e.accuracyText() : Messages.tr("not anti-aliased yet"));
        table.setItems(log.entries());
        details.setId("updates-whole");
        details.getStyleClass().add("about-lines");
        details.setWrapText(true);
        details.setMinHeight(USE_PREF_SIZE);
        details.setMaxWidth(Double.MAX_VALUE);
        table.getSelectionModel().selectedItemProperty().subscribe(e -> details.setText(e == null ? "" : e.text()));
        table.getSelectionModel().selectFirst();
        table.getItems().addListener(this::followNewest);
        setVgrow(table, Priority.ALWAYS);
        getChildren().addAll(table, details);
    }

    /** Selects a new entry if the newest one was selected, so that the details are of the current image. */
    private void followNewest(ListChangeListener.Change<? extends Entry> change) {
        while (change.next()) {
            // The selection keeps its entry, so it is already shifted by those added.
            int previousNewest = change.wasReplaced() ? 0 : change.getAddedSize();
            boolean wasEmpty = change.getList().size() == change.getAddedSize();
            if (change.wasAdded() && (wasEmpty || table.getSelectionModel().getSelectedIndex() == previousNewest)) {
                table.getSelectionModel().clearAndSelect(0);
            }
        }
    }

    private void addTextColumn(String title, double width, Function<Entry, String> value) {
        var column = new TableColumn<Entry, String>(title);
        column.setPrefWidth(width);
        column.setMinWidth(width);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(value.apply(cell.getValue())));
        table.getColumns().add(column);
    }

    private void addNumberColumn(String title, double width, Function<Entry, String> value) {
        addTextColumn(title, width, value);
        table.getColumns().getLast().getStyleClass().add("number-column");
    }
}

package lightning.editor.window;

import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.UpdateLog;
import lightning.editor.window.model.UpdateLog.Entry;

/** What the last updates did: plan, rows, rays, time, and what the picture is; the latest at the top. */
final class UpdatesPane extends VBox {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

    private static final double LEAST_WORDS = 120;

    private final TableView<Entry> table = new TableView<>();
    private final Label whole = new Label();

    UpdatesPane(UpdateLog log) {
        setId("updates");
        getStyleClass().add("history");
        table.setId("updates-table");
        table.setAccessibleText(Texts.of("updates"));
        table.getStyleClass().add("dense");
        table.setPlaceholder(new Label(Texts.of("No picture yet")));
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_ALL_COLUMNS);
        // In a narrow window what was done gives way: the line below tells all of it.
        text(Texts.of("At"), 80, e -> CLOCK.format(e.at()));
        text(Texts.of("What was done"), 270, e -> e.update().plan().text());
        table.getColumns().getLast().setMinWidth(LEAST_WORDS);
        number(Texts.of("Rows"), 92, e -> StatusText.number(e.update().rowsTouched()));
        number(Texts.of("Shadow rays"), 162, e -> StatusText.number(e.update().rays().shadow()));
        number(Texts.of("All rays"), 126, e -> StatusText.number(e.update().rays().all()));
        number(Texts.of("Time"), 86, e -> StatusText.time(e.update().milliseconds()));
        number(Texts.of("Saved"), 92, e -> e.saving().map(s -> StatusText.saving(s.percent() / 100)).orElse("–"));
        text(Texts.of("Picture"), 92, e -> e.finished() ? e.promise() : Texts.of("without finer samples yet"));
        table.setItems(log.entries());
        whole.setId("updates-whole");
        whole.getStyleClass().add("about-lines");
        whole.setWrapText(true);
        whole.setMinHeight(USE_PREF_SIZE);
        whole.setMaxWidth(Double.MAX_VALUE);
        table.getSelectionModel().selectedItemProperty().subscribe(e -> whole.setText(e == null ? "" : e.text()));
        table.getSelectionModel().selectFirst();
        setVgrow(table, Priority.ALWAYS);
        getChildren().addAll(table, whole);
    }

    private void text(String title, double width, Function<Entry, String> of) {
        var column = new TableColumn<Entry, String>(title);
        column.setPrefWidth(width);
        column.setMinWidth(width);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(of.apply(cell.getValue())));
        table.getColumns().add(column);
    }

    private void number(String title, double width, Function<Entry, String> of) {
        text(title, width, of);
        table.getColumns().getLast().getStyleClass().add("number-column");
    }
}

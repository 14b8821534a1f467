package lightning.app;

import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.app.model.EditorModel;
import lightning.app.model.StatusText;
import lightning.app.model.UpdateLog.Entry;
import lightning.text.Texts;

/** What the last updates did: plan, rows, rays, time, and what the picture is; the latest at the top. */
final class UpdatesPane extends VBox {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

    private final TableView<Entry> table = new TableView<>();
    private final Label whole = new Label();

    UpdatesPane(EditorModel model) {
        setId("updates");
        getStyleClass().add("history");
        table.setId("updates-table");
        table.setAccessibleText(Texts.of("updates"));
        table.getStyleClass().add("dense");
        table.setPlaceholder(new Label(Texts.of("No picture yet")));
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_ALL_COLUMNS);
        text(Texts.of("At"), 92, e -> CLOCK.format(e.at()));
        text(Texts.of("What was done"), 230, e -> e.update().plan().text());
        number(Texts.of("Rows"), 110, e -> StatusText.number(e.update().rowsTouched()));
        number(Texts.of("Shadow rays"), 160, e -> StatusText.number(e.update().rays().shadow()));
        number(Texts.of("All rays"), 120, e -> StatusText.number(e.update().rays().all()));
        number(Texts.of("Time"), 100, e -> StatusText.time(e.update().milliseconds()));
        number(Texts.of("Saved"), 100, e -> e.saving().map(s -> StatusText.saving(s.percent() / 100)).orElse("–"));
        text(Texts.of("Picture"), 110, e -> e.finished() ? e.promise() : Texts.of("without finer samples yet"));
        table.setItems(model.updates().entries());
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

package lightning.editor.window.measure;

import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import lightning.base.text.Texts;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.Rung;

/** The grades of accuracy, a row each: time, saving and errors. */
final class LadderTable extends TableView<Rung> {
    private static final double NUMBER = 116;
    private static final double PART = 170;
    private static final double GRADE = 170;
    private static final double ROW = 30;

    private Ladder ladder;

    LadderTable() {
        setId("ladder");
        setAccessibleText(Texts.of("Grades of accuracy"));
        getStyleClass().add("dense");
        setPlaceholder(new Label(Texts.of("Measure shows what each grade costs for the last edit, and how far it is off.")));
        setColumnResizePolicy(CONSTRAINED_RESIZE_POLICY_FLEX_LAST_COLUMN);
        setFixedCellSize(ROW);
        add(Texts.of("Grade"), GRADE, r -> (r.grade().ordinal() + 1) + "  " + r.grade().label());
        add(Texts.of("Time"), NUMBER, RungText::time);
        add(Texts.of("Of a full trace"), PART, r -> RungText.saving(ladder, r));
        add(Texts.of("Largest error"), NUMBER, r -> RungText.largest(r.error()));
        add(Texts.of("Values off"), NUMBER, r -> RungText.values(r.error()));
        add("PSNR", NUMBER, r -> RungText.psnr(r.error()));
        add("SSIM", NUMBER, r -> RungText.ssim(r.error()));
    }

    private void add(String title, double width, Function<Rung, String> text) {
        var column = new TableColumn<Rung, String>(title);
        column.setPrefWidth(width);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        getColumns().add(column);
    }

    void show(Ladder measured) {
        ladder = measured;
        getItems().setAll(measured.rungs());
    }
}

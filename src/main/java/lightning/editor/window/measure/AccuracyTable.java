package lightning.editor.window.measure;

import static java.util.Objects.requireNonNull;

import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import lightning.base.text.Messages;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.SweepPoint;
import org.jspecify.annotations.Nullable;

/** Table of accuracy settings with time, saving and errors. */
final class AccuracyTable extends TableView<SweepPoint> {
    private static final double NUMBER_WIDTH = 116;
    private static final double SHARE_WIDTH = 170;
    private static final double SETTING_WIDTH = 170;
    private static final double ROW_HEIGHT = 30;

    private @Nullable AccuracySweep sweep;

    AccuracyTable() {
        setId("ladder");
        setAccessibleText(Messages.tr("Accuracy settings"));
        getStyleClass().add("dense");
        setPlaceholder(new Label(Messages.tr("Click Measure to compare the time and error of each setting for the last edit.")));
        setColumnResizePolicy(CONSTRAINED_RESIZE_POLICY_FLEX_LAST_COLUMN);
        setFixedCellSize(ROW_HEIGHT);
        addColumn(Messages.tr("Setting"), SETTING_WIDTH, r -> (r.setting().ordinal() + 1) + "  " + r.setting().label());
        addColumn(Messages.tr("Time"), NUMBER_WIDTH, AccuracyText::time);
        addColumn(Messages.tr("Compared to full trace"), SHARE_WIDTH, r -> AccuracyText.saving(requireNonNull(sweep), r));
        addColumn(Messages.tr("Largest error"), NUMBER_WIDTH, r -> AccuracyText.largest(r.error()));
        addColumn(Messages.tr("Differing"), NUMBER_WIDTH, r -> AccuracyText.values(r.error()));
        addColumn("PSNR", NUMBER_WIDTH, r -> AccuracyText.psnr(r.error()));
        addColumn("SSIM", NUMBER_WIDTH, r -> AccuracyText.ssim(r.error()));
    }

    private void addColumn(String title, double width, Function<SweepPoint, String> text) {
        var column = new TableColumn<SweepPoint, String>(title);
        column.setPrefWidth(width);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        getColumns().add(column);
    }

    void show(AccuracySweep newSweep) {
        sweep = newSweep;
        getItems().setAll(newSweep.points());
    }
}

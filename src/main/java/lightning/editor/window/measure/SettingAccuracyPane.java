package lightning.editor.window.measure;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.measure.SettingSweep;
import lightning.render.measure.SweptEffect;
import lightning.render.measure.SweptSetting;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;

/**
 * Pane that compares settings of an effect on the current scene: time and difference of each, measured on request. A setting is chosen in the
 * table or in the plot beside it.
 */
public final class SettingAccuracyPane extends BorderPane {
    private static final double ROW_HEIGHT = 30;
    /** Width of the table at which no title is cut off, pixels. */
    private static final double TABLE_WIDTH = 582;

    private final SceneEditor editor;
    private final Label note = new Label();
    private final MeasureBar bar = new MeasureBar("-setting",
            Messages.tr("Render the scene with each setting in the background"));
    private final ComboBox<String> effects = new ComboBox<>();
    private final TableView<SettingSweep.Point> table = new TableView<>();
    private final SettingPlot chart = new SettingPlot(table.getSelectionModel());
    private final Button use = new Button(Messages.tr("Use This Setting"));
    private final StackPane useBox = new StackPane(use);
    private final DisabledReason useReason =
            new DisabledReason(useBox, use, Messages.tr("Give the scene the setting of the selected row"));

    public SettingAccuracyPane(SceneEditor editor, ObservableValue<AccuracyMode> accuracyMode) {
        this.editor = editor;
        setId("setting-accuracy");
        getStyleClass().add("accuracy");
        note.setId("setting-accuracy-note");
        note.setWrapText(true);
        note.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(note, Priority.ALWAYS);
        effects.setId("swept-effect");
        effects.setAccessibleText(Messages.tr("Effect"));
        effects.setMinWidth(Region.USE_PREF_SIZE);
        Arrays.stream(SweptEffect.values()).map(SettingText::title).forEach(effects.getItems()::add);
        effects.getSelectionModel().selectFirst();
        effects.getSelectionModel().selectedIndexProperty().subscribe(_ -> clear());
        bar.setMinWidth(Region.USE_PREF_SIZE);
        bar.setOnMeasure(() -> measure(accuracyMode.getValue()));
        var head = new HBox(effects, note, bar);
        head.setAlignment(Pos.CENTER_LEFT);
        head.getStyleClass().add("accuracy-head");
        setTop(head);
        HBox.setHgrow(chart, Priority.ALWAYS);
        HBox.setHgrow(table(), Priority.ALWAYS);
        chart.setVisible(false);
        chart.managedProperty().bind(chart.visibleProperty());
        // Side by side: a low window shows all rows and the chart.
        setCenter(new HBox(chart, table));
        use.setId("use-setting");
        use.setMinWidth(Region.USE_PREF_SIZE);
        use.setOnAction(_ -> useSelected());
        var explanation = new Label(
                Messages.tr(
                        "Times add to a first pass without anti-aliasing. Differences are those of the brightness from the densest setting."));
        explanation.getStyleClass().add("pane-note");
        explanation.setWrapText(true);
        explanation.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(explanation, Priority.ALWAYS);
        var bottom = new HBox(explanation, useBox);
        bottom.setAlignment(Pos.CENTER_LEFT);
        bottom.getStyleClass().add("accuracy-head");
        setBottom(bottom);
        VisibilityListener.attach(this, () -> editor.sceneProperty().subscribe(_ -> updateReason()));
        table.getSelectionModel().selectedItemProperty().subscribe(point -> useReason
                .set(point == null ? Optional.of(Messages.tr("no row is selected")) : Optional.empty()));
    }

    private SweptEffect effect() {
        return SweptEffect.values()[effects.getSelectionModel().getSelectedIndex()];
    }

    private void clear() {
        table.getItems().clear();
        chart.setVisible(false);
        note.setText(Messages.tr("Click Measure to compare the time and accuracy of this effect for this scene."));
        updateReason();
    }

    private void updateReason() {
        bar.setDisabledReason(effect().missingReason(editor.scene()));
    }

    private TableView<SettingSweep.Point> table() {
        table.setId("setting-table");
        table.setAccessibleText(Messages.tr("Settings of the effect"));
        table.getStyleClass().add("dense");
        table.setPlaceholder(new Label(Messages.tr("Not measured yet")));
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_FLEX_LAST_COLUMN);
        table.setFixedCellSize(ROW_HEIGHT);
        table.setMinWidth(TABLE_WIDTH);
        addColumn(Messages.tr("Setting"), 180, p -> SettingText.text(p.setting()));
        addColumn(Messages.tr("Time"), 76, p -> p.fits() ? StatusText.time(p.milliseconds()) : Messages.tr("too large for memory"));
        addColumn(Messages.tr("Mean difference"), 164, p -> p.fits() ? percent(p.meanDifference()) : "");
        addColumn(Messages.tr("95 % of pixels below"), 158, p -> p.fits() ? percent(p.difference95()) : "");
        return table;
    }

    private static String percent(double share) {
        return String.format(Messages.locale(), "%.1f %%", 100 * share);
    }

    /** @param minWidth pixels */
    private void addColumn(String title, double minWidth, Function<SettingSweep.Point, String> text) {
        var column = new TableColumn<SettingSweep.Point, String>(title);
        column.setMinWidth(minWidth);
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        table.getColumns().add(column);
    }

    private void measure(AccuracyMode mode) {
        Scene scene = editor.scene();
        note.setText(Messages.tr("Measuring …"));
        SweptEffect effect = effect();
        bar.start("lightning-setting-accuracy", progress -> SettingSweep.measure(effect, scene, mode.options(), progress), sweep -> {
            if (effect != effect()) {
                clear();
                return;
            }
            table.getItems().setAll(sweep.points());
            chart.show(sweep);
            chart.setVisible(true);
            Scene used = scene.picture().indirect().isPresent() || effect != SweptEffect.INDIRECT ? scene
                    : scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
            sweep.points().stream().filter(p -> p.setting().applyTo(scene).equals(used)).findFirst()
                    .ifPresent(table.getSelectionModel()::select);
            note.setText(Messages.tr("{0} × {1} pixels · first pass without this effect {2}", scene.picture().width(),
                    scene.picture().height(), StatusText.time(sweep.baseMilliseconds())));
        }, note::setText);
    }

    private void useSelected() {
        SweptSetting chosen = table.getSelectionModel().getSelectedItem().setting();
        editor.editOrReport(scene -> EditOutcome.of(() -> chosen.applyTo(scene)));
    }
}

package lightning.editor.window.measure;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.editor.EditorState;
import lightning.editor.LastEdit;
import lightning.editor.Workbench;
import lightning.editor.window.widget.PictureView;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.AccuracySweepMeter;
import lightning.render.measure.SweepPoint;
import org.jspecify.annotations.Nullable;

/** Pane that compares accuracy settings: time and error of each for the last edit, measured on request. */
public final class AccuracyPane extends BorderPane {
    private static final int REPETITIONS = 5;
    private static final double TIMEOUT_MS = 10_000;

    private final Workbench workbench;
    private final ObservableValue<EditorState> editorState;
    private final ObservableValue<ViewTransform> view;
    private final Label editLabel = new Label();
    private final Label note = new Label();
    private final MeasureBar bar = new MeasureBar("",
            Messages.tr("Measure the last edit at each accuracy setting in the background"));
    private final ToggleButton difference = new ToggleButton(Messages.tr("Difference"));
    private final AccuracyTable table = new AccuracyTable();
    private final AccuracyPlot chart = new AccuracyPlot();
    private final PictureView picture = new PictureView();
    private @Nullable AccuracySweep sweep;
    /** Last measured edit, and the text of its result. */
    private Optional<LastEdit> measuredEdit = Optional.empty();
    private String outcome = "";

    /** @param view  conversion from linear light to display pixels */
    public AccuracyPane(Workbench workbench, ObservableValue<EditorState> editorState, ObservableValue<ViewTransform> view) {
        this.workbench = workbench;
        this.editorState = editorState;
        this.view = view;
        bar.setOnMeasure(this::startMeasuring);
        setId("accuracy");
        getStyleClass().add("accuracy");
        setTop(header());
        var pictureBox = new VBox(difference, pictureStage());
        pictureBox.getStyleClass().add("accuracy-picture");
        VBox.setVgrow(pictureBox.getChildren().getLast(), Priority.ALWAYS);
        var resultBox = new HBox(chart, pictureBox);
        resultBox.getStyleClass().add("accuracy-below");
        resultBox.visibleProperty().bind(table.getSelectionModel().selectedItemProperty().isNotNull());
        HBox.setHgrow(chart, Priority.ALWAYS);
        HBox.setHgrow(pictureBox, Priority.ALWAYS);
        note.setId("grade-note");
        note.getStyleClass().add("pane-note");
        note.setWrapText(true);
        table.setPrefHeight(260);
        table.setMinHeight(260);
        var content = new VBox(table, note, resultBox);
        content.getStyleClass().add("accuracy-content");
        VBox.setVgrow(resultBox, Priority.ALWAYS);
        setCenter(content);
        difference.setId("grade-difference");
        difference.setSelected(true);
        difference.setAccessibleText(Messages.tr("Show the difference from the full trace"));
        difference.selectedProperty().subscribe(_ -> updatePicture());
        table.getSelectionModel().selectedItemProperty().subscribe(_ -> updatePicture());
        VisibilityListener.attach(this, () -> Subscription.combine(editorState.subscribe(_ -> update()),
                view.subscribe(_ -> updatePicture())));
    }

    private Node header() {
        editLabel.setId("accuracy-edit");
        editLabel.setMaxWidth(Double.MAX_VALUE);
        editLabel.setWrapText(true);
        HBox.setHgrow(editLabel, Priority.ALWAYS);
        var head = new HBox(editLabel, bar);
        head.setAlignment(Pos.CENTER_LEFT);
        head.getStyleClass().add("accuracy-head");
        return head;
    }

    private Node pictureStage() {
        picture.setId("grade-picture");
        var stage = new StackPane(picture);
        stage.getStyleClass().add("canvas");
        return stage;
    }

    private Optional<LastEdit> lastEdit() {
        return workbench.lastEdit();
    }

    private void update() {
        Optional<LastEdit> last = lastEdit();
        bar.setDisabledReason(
                last.isEmpty() ? Optional.of(Messages.tr("no light has been edited yet"))
                        : Optional.empty());
        editLabel.setText(bar.isBusy() ? Messages.tr("Measuring …") : title(last));
    }

    private String title(Optional<LastEdit> last) {
        if (last.isPresent() && last.equals(measuredEdit)) {
            return outcome;
        }
        String description =
                last.map(e -> e.isPending() ? Messages.tr("Edits not rendered yet") : Messages.tr("Edits of the last render"))
                        .orElse(Messages.tr("Edit a light first."));
        return sweep == null ? description : Messages.tr("{0}. The table still shows: {1}", description, text(sweep));
    }

    private static String text(AccuracySweep sweep) {
        return Messages.tr("{0} · {1} × {2} pixels", requireNonNull(sweep.point(AccuracySetting.EXACT).update()).plan().description(),
                sweep.after().picture().width(),
                sweep.after().picture().height());
    }

    private void startMeasuring() {
        measuredEdit = lastEdit();
        LastEdit edit = measuredEdit.orElseThrow();
        bar.start("lightning-accuracy", progress -> measure(edit, progress), this::showResult, this::showOutcome);
        update();
    }

    private static AccuracySweep measure(LastEdit edit, Progress progress) {
        try (var meter = AccuracySweepMeter.untilSteady(WorkerPool.processorCount(), REPETITIONS, TIMEOUT_MS)) {
            return meter.measure(edit.before(), edit.after(), progress);
        }
    }

    private void showResult(AccuracySweep newSweep) {
        sweep = newSweep;
        table.show(newSweep);
        chart.show(newSweep);
        table.getSelectionModel().select(newSweep.point(AccuracySetting.EXACT));
        showOutcome(text(newSweep) + (newSweep.isWarm() ? "" : Messages.tr(". Timing too noisy to report savings")));
    }

    private void showOutcome(String text) {
        outcome = text;
        update();
    }

    private void updatePicture() {
        SweepPoint point = table.getSelectionModel().getSelectedItem();
        if (point == null || sweep == null) {
            return;
        }
        note.setText(point.setting().label() + ": " + point.setting().description());
        Film full = sweep.point(AccuracySetting.FULL_TRACE).film();
        Film film = difference.isSelected() ? DifferenceImage.of(point.film(), full) : point.film();
        ViewTransform display = difference.isSelected() ? ViewTransform.DEFAULT : view.getValue();
        picture.setPixels(film.width(), film.height(), display.toPixels(film));
    }
}

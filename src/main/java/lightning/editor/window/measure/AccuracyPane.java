package lightning.editor.window.measure;

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
import lightning.base.text.Texts;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.LadderMeter;
import lightning.bench.accuracy.Rung;
import lightning.editor.document.LastEdit;
import lightning.editor.document.Situation;
import lightning.editor.document.Workbench;
import lightning.editor.window.widget.PictureView;
import lightning.editor.window.widget.WhileSeen;
import lightning.render.image.DifferencePicture;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** What accuracy costs: each grade's time and error for the edit made last, measured when the artist asks for it. */
public final class AccuracyPane extends BorderPane {
    private static final int REPETITIONS = 5;
    private static final double PATIENCE_MS = 10_000;

    private final Workbench workbench;
    private final ObservableValue<Situation> situation;
    private final ObservableValue<ViewTransform> view;
    private final Label edit = new Label();
    private final Label note = new Label();
    private final MeasureBar bar = new MeasureBar("",
            Texts.of("Make the edit at each grade in the background, again and again, and compare"));
    private final ToggleButton difference = new ToggleButton(Texts.of("Difference"));
    private final LadderTable table = new LadderTable();
    private final LadderPlot chart = new LadderPlot();
    private final PictureView picture = new PictureView();
    private Ladder ladder;
    /** The edit that was measured last, and what came of it. */
    private Optional<LastEdit> told = Optional.empty();
    private String outcome = "";

    /** @param view how linear light becomes display pixels */
    public AccuracyPane(Workbench workbench, ObservableValue<Situation> situation, ObservableValue<ViewTransform> view) {
        this.workbench = workbench;
        this.situation = situation;
        this.view = view;
        bar.setOnMeasure(this::begin);
        setId("accuracy");
        getStyleClass().add("accuracy");
        setTop(head());
        var shown = new VBox(difference, stage());
        shown.getStyleClass().add("accuracy-picture");
        VBox.setVgrow(shown.getChildren().getLast(), Priority.ALWAYS);
        var below = new HBox(chart, shown);
        below.getStyleClass().add("accuracy-below");
        below.visibleProperty().bind(table.getSelectionModel().selectedItemProperty().isNotNull());
        HBox.setHgrow(chart, Priority.ALWAYS);
        HBox.setHgrow(shown, Priority.ALWAYS);
        note.setId("grade-note");
        note.getStyleClass().add("pane-note");
        note.setWrapText(true);
        table.setPrefHeight(260);
        table.setMinHeight(260);
        var all = new VBox(table, note, below);
        all.getStyleClass().add("accuracy-content");
        VBox.setVgrow(below, Priority.ALWAYS);
        setCenter(all);
        difference.setId("grade-difference");
        difference.setSelected(true);
        difference.setAccessibleText(Texts.of("Show the difference from the full trace"));
        difference.selectedProperty().subscribe(_ -> paint());
        table.getSelectionModel().selectedItemProperty().subscribe(_ -> paint());
        WhileSeen.follow(this, () -> Subscription.combine(situation.subscribe(_ -> update()),
                view.subscribe(_ -> paint())));
    }

    private Node head() {
        edit.setId("accuracy-edit");
        edit.setMaxWidth(Double.MAX_VALUE);
        edit.setWrapText(true);
        HBox.setHgrow(edit, Priority.ALWAYS);
        var head = new HBox(edit, bar);
        head.setAlignment(Pos.CENTER_LEFT);
        head.getStyleClass().add("accuracy-head");
        return head;
    }

    private Node stage() {
        picture.setId("grade-picture");
        var stage = new StackPane(picture);
        stage.getStyleClass().add("canvas");
        return stage;
    }

    private Optional<LastEdit> last() {
        return situation.getValue().animating() ? Optional.empty() : workbench.lastEdit();
    }

    private void update() {
        Optional<LastEdit> last = last();
        bar.setObstacle(
                last.isEmpty() ? Optional.of(Texts.of("there is no edit of a light yet that the picture could show")) : Optional.empty());
        edit.setText(bar.isBusy() ? Texts.of("Measuring …") : title(last));
    }

    private String title(Optional<LastEdit> last) {
        if (last.isPresent() && last.equals(told)) {
            return outcome;
        }
        String what = last.map(e -> e.pending() ? Texts.of("The edits that are not rendered yet") : Texts.of("The edits of the last Go"))
                .orElse(Texts.of("Edit a light first."));
        return ladder == null ? what : Texts.of("{0}. The table is still of: {1}", what, text(ladder));
    }

    private static String text(Ladder measured) {
        return Texts.of("{0} · {1} × {2} pixels", measured.rung(Grade.EXACT).update().plan().text(), measured.after().picture().width(),
                measured.after().picture().height());
    }

    private void begin() {
        told = last();
        LastEdit measured = told.orElseThrow();
        bar.begin("lightning-ladder", progress -> ladder(measured, progress), this::finished, this::ended);
        update();
    }

    private static Ladder ladder(LastEdit measured, Progress progress) {
        try (var meter = LadderMeter.patient(Workers.available(), REPETITIONS, PATIENCE_MS)) {
            return meter.measure(measured.before(), measured.after(), progress);
        }
    }

    private void finished(Ladder measured) {
        ladder = measured;
        table.show(measured);
        chart.show(measured);
        table.getSelectionModel().select(measured.rung(Grade.EXACT));
        ended(text(measured) + (measured.warm() ? "" : Texts.of(". The times did not come to rest, so no savings are told")));
    }

    private void ended(String text) {
        outcome = text;
        update();
    }

    private void paint() {
        Rung rung = table.getSelectionModel().getSelectedItem();
        if (rung == null || ladder == null) {
            return;
        }
        note.setText(rung.grade().label() + ": " + rung.grade().note());
        Film full = ladder.rung(Grade.FULL_TRACE).film();
        Film film = difference.isSelected() ? DifferencePicture.of(rung.film(), full) : rung.film();
        ViewTransform through = difference.isSelected() ? ViewTransform.DEFAULT : view.getValue();
        picture.setPixels(film.width(), film.height(), through.toPixels(film));
    }
}

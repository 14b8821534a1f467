package lightning.app;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ObjectProperty;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.accuracy.EffectCost;
import lightning.accuracy.EffectCosts;
import lightning.app.widget.Obstacle;
import lightning.edit.LastEdit;
import lightning.effects.Effect;
import lightning.effects.Effects;
import lightning.effects.ViewEffects;
import lightning.relight.Options;
import lightning.scene.Scene;

/** The effects that the scene calls for, and who calls for each; one click hides one from the view. */
final class EffectsPane extends VBox {
    private static final int REPETITIONS = 5;

    private final EditorModel model;
    private final ObjectProperty<ViewEffects> view;
    private final Map<Effect, Row> rows = new EnumMap<>(Effect.class);
    private final Label summary = new Label();
    private final VBox used = new VBox();
    private final Label absent = new Label();
    private final Obstacle nothingHidden;
    private final Button measure = new Button("Measure");
    private final Button cancel = new Button("Cancel");
    private final StackPane measureBox = new StackPane(measure);
    private final StackPane cancelBox = new StackPane(cancel);
    private final Obstacle measuring = new Obstacle(measureBox, measure,
            "Render with and without each effect in the background, again and again, and compare");
    private final Obstacle cancelling = new Obstacle(cancelBox, cancel, "Stop measuring");
    private final ProgressBar bar = new ProgressBar(0);
    private MeasureTask<EffectCosts> task;
    private Scene told;
    private String summaryText = "";
    private String absentText = "";

    /** One effect in use. */
    private static final class Row extends HBox {
        private final CheckBox shown = new CheckBox();
        private final Label why = new Label();
        private final Label cost = new Label();

        Row(Effect effect) {
            shown.setText(title(effect));
            shown.setId("effect-" + effect.name().toLowerCase(Locale.ROOT).replace('_', '-'));
            shown.setMinWidth(Region.USE_PREF_SIZE);
            why.getStyleClass().add("pane-note");
            why.setMaxWidth(Double.MAX_VALUE);
            HBox.setHgrow(why, Priority.ALWAYS);
            cost.setMinWidth(Region.USE_PREF_SIZE);
            getStyleClass().add("effect-row");
            getChildren().addAll(shown, why, cost);
        }

        private static String title(Effect effect) {
            return Character.toUpperCase(effect.title().charAt(0)) + effect.title().substring(1);
        }
    }

    EffectsPane(EditorModel model) {
        this.model = model;
        view = model.look().effectsProperty();
        setId("effects");
        getStyleClass().add("effects");
        for (Effect effect : Effect.values()) {
            Row row = new Row(effect);
            row.shown.selectedProperty().addListener((_, _, on) -> view.set(view.get().with(effect, on)));
            rows.put(effect, row);
        }
        summary.setId("effects-summary");
        summary.setWrapText(true);
        absent.setId("effects-absent");
        absent.getStyleClass().add("pane-note");
        absent.setWrapText(true);
        used.getStyleClass().add("effect-rows");
        var scroll = new ScrollPane(new VBox(used, absent));
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        VBox.setVgrow(scroll, Priority.ALWAYS);
        var all = new Button("Show All");
        all.setId("show-all-effects");
        all.setMinWidth(Region.USE_PREF_SIZE);
        all.setOnAction(_ -> view.set(ViewEffects.ALL));
        var allBox = new StackPane(all);
        nothingHidden = new Obstacle(allBox, all, "Show the picture with everything that the scene calls for");
        measure.setId("measure-effects");
        measure.setMinWidth(Region.USE_PREF_SIZE);
        measure.setOnAction(_ -> begin());
        cancel.setId("cancel-effects");
        cancel.setMinWidth(Region.USE_PREF_SIZE);
        cancel.setOnAction(_ -> stop());
        bar.setAccessibleText("Progress of measuring");
        busy(false);
        var bottom = new HBox(hint(), bar, measureBox, cancelBox, allBox);
        bottom.getStyleClass().add("effects-bottom");
        getChildren().addAll(summary, scroll, bottom);
        view.subscribe(this::show);
        model.sceneProperty().subscribe(this::tell);
    }

    private static Node hint() {
        var hint = new Label("A hidden effect is hidden from the view alone: Save Image and Verify take the picture itself.");
        hint.getStyleClass().add("pane-note");
        hint.setWrapText(true);
        HBox.setHgrow(hint, Priority.ALWAYS);
        hint.setMaxWidth(Double.MAX_VALUE);
        return hint;
    }

    private void show(ViewEffects effects) {
        rows.forEach((effect, row) -> row.shown.setSelected(effects.shows(effect)));
        nothingHidden.set(effects.showsAll() ? Optional.of("nothing is hidden") : Optional.empty());
    }

    /** The last edit tells what an update costs; without one, an update has nothing to do. */
    private void begin() {
        Scene scene = model.scene();
        var edit = model.isAnimating() ? Optional.<LastEdit>empty() : model.workbench().lastEdit();
        Scene before = edit.map(LastEdit::before).orElse(scene);
        Scene after = edit.map(LastEdit::after).orElse(scene);
        task = new MeasureTask<>(progress -> EffectCosts.of(before, after, Options.DEFAULT, REPETITIONS, progress));
        task.setOnSucceeded(_ -> {
            if (scene.equals(told)) {
                finished(task.getValue());
            } else {
                ended("The scene was edited meanwhile; measure again");
            }
        });
        task.setOnFailed(e -> ended(Sentence.of(e.getSource().getException())));
        task.setOnCancelled(_ -> ended("Cancelled"));
        bar.progressProperty().bind(task.progressProperty());
        busy(true);
        task.begin();
    }

    private void busy(boolean on) {
        measuring.set(on ? Optional.of("it is being measured") : Optional.empty());
        cancelling.set(on ? Optional.empty() : Optional.of("nothing is being measured"));
        bar.setVisible(on);
        bar.setManaged(on);
    }

    private void finished(EffectCosts costs) {
        StringBuilder saved = new StringBuilder();
        for (EffectCost cost : costs.effects()) {
            rows.get(cost.effect()).cost.setText(cost.inUse() ? EffectText.of(cost) : "");
            if (!cost.inUse() && cost.measured()) {
                saved.append("\n").append(cost.effect().title()).append(" would take ").append(EffectText.of(cost));
            }
        }
        absent.setText(absentText + saved);
        ended(String.format(Locale.ROOT, "First pass %.1f ms, update (%s) %.1f ms", costs.first().median(), costs.plan(), costs.update().median()));
    }

    private void ended(String outcome) {
        bar.progressProperty().unbind();
        summary.setText(summaryText + ". " + outcome);
        busy(false);
    }

    /** Gives up what is being measured. */
    void stop() {
        if (task != null) {
            // Without an interrupt, which would break the workers' waiting.
            task.cancel(false);
        }
    }

    private void tell(Scene scene) {
        if (scene.equals(told)) {
            return;
        }
        told = scene;
        Effects effects = Effects.of(scene);
        Set<Effect> without = effects.absent();
        var inUse = rows.entrySet().stream().filter(e -> effects.has(e.getKey())).map(Map.Entry::getValue).toList();
        if (!used.getChildren().equals(inUse)) {
            used.getChildren().setAll(inUse);
        }
        rows.forEach((effect, row) -> {
            row.why.setText(effects.why(effect));
            row.cost.setText("");
        });
        summaryText = model.document().name() + " calls for " + inUse.size() + " of " + rows.size() + " effects";
        absentText = without.isEmpty() ? "" : "Not in the scene, and no work and memory spent on them: "
                + String.join(", ", without.stream().map(Effect::title).toList()) + ".";
        summary.setText(summaryText);
        absent.setText(absentText);
    }
}

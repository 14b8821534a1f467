package lightning.editor.window.measure;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.editor.LastEdit;
import lightning.editor.Workbench;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.RenderOptions;
import lightning.render.measure.EffectCosts;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.SceneEffects;
import lightning.scene.effects.ViewEffects;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;

/**
 * Pane of the rendering effects that a scene uses. Lists the elements that use each effect, measures costs on request, and hides effects in
 * the view.
 */
public final class EffectsPane extends VBox {
    private static final int REPETITIONS = 5;

    private final SceneEditor editor;
    private final Workbench workbench;
    private final ObservableValue<AccuracyMode> accuracyMode;
    private final ObjectProperty<ViewEffects> view;
    private final Map<RenderEffect, EffectRow> rows = new LinkedHashMap<>();
    private final Label summary = new Label();
    private final Label outcome = new Label();
    private final MeasureBar bar = new MeasureBar("-effects",
            Messages.tr("Measure the scene and its last edit with and without each effect in the background"));
    private final VBox usedBox = new VBox();
    private final Label absentLabel = new Label();
    private final VBox unusedBox = new VBox();
    private final DisabledReason showAllReason;
    private @Nullable EffectCosts costs;
    private @Nullable Scene costsScene;
    private String costsText = "";
    private @Nullable Scene shownScene;
    /** Listed unused effects and costs. */
    private @Nullable Set<RenderEffect> listedEffects;
    private @Nullable EffectCosts listedCosts;

    /** @param view  effects shown in the traced picture */
    public EffectsPane(SceneEditor editor, Workbench workbench, ObservableValue<AccuracyMode> accuracyMode,
            ObjectProperty<ViewEffects> view) {
        this.editor = editor;
        this.workbench = workbench;
        this.accuracyMode = accuracyMode;
        this.view = view;
        setId("effects");
        getStyleClass().add("effects");
        for (RenderEffect effect : RenderEffect.ALL) {
            var row = new EffectRow(effect);
            row.visibleBox().selectedProperty().addListener((_, _, on) -> view.set(view.get().with(effect, on)));
            rows.put(effect, row);
        }
        summary.setId("effects-summary");
        outcome.setId("effects-outcome");
        outcome.getStyleClass().add("pane-note");
        outcome.setWrapText(true);
        outcome.setText(Messages.tr("Click Measure to see the time and memory of each effect, and what unused effects save."));
        var heading = new VBox(summary, outcome);
        HBox.setHgrow(heading, Priority.ALWAYS);
        bar.setMinWidth(Region.USE_PREF_SIZE);
        bar.setOnMeasure(this::measure);
        var head = new HBox(heading, bar);
        head.getStyleClass().add("effects-bottom");
        absentLabel.setId("effects-absent");
        absentLabel.getStyleClass().add("pane-note");
        absentLabel.setWrapText(true);
        usedBox.getStyleClass().add("effect-rows");
        unusedBox.getStyleClass().add("effect-rows");
        var scroll = new ScrollPane(new VBox(usedBox, absentLabel, unusedBox));
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        VBox.setVgrow(scroll, Priority.ALWAYS);
        var showAll = new Button(Messages.tr("Show All"));
        showAll.setId("show-all-effects");
        showAll.setMinWidth(Region.USE_PREF_SIZE);
        showAll.setOnAction(_ -> view.set(ViewEffects.ALL));
        var allBox = new StackPane(showAll);
        showAllReason = new DisabledReason(allBox, showAll, Messages.tr("Show all effects of the scene"));
        var bottom = new HBox(hint(), allBox);
        bottom.getStyleClass().add("effects-bottom");
        getChildren().addAll(head, scroll, bottom);
        VisibilityListener.attach(this,
                () -> Subscription.combine(view.subscribe(this::show), editor.sceneProperty().subscribe(this::showScene)));
    }

    private static Node hint() {
        var hint = new Label(Messages.tr("Hiding an effect changes only the view. Save Image and Verify use the full image."));
        hint.getStyleClass().add("pane-note");
        hint.setWrapText(true);
        HBox.setHgrow(hint, Priority.ALWAYS);
        hint.setMaxWidth(Double.MAX_VALUE);
        return hint;
    }

    private void show(ViewEffects effects) {
        rows.forEach((effect, row) -> row.visibleBox().setSelected(effects.shows(effect)));
        showAllReason.set(effects.showsAll() ? Optional.of(Messages.tr("nothing is hidden")) : Optional.empty());
    }

    private void showScene(Scene scene) {
        if (!scene.equals(shownScene)) {
            shownScene = scene;
            bar.setDisabledReason(scene.lights().isEmpty() ? Optional.of(Messages.tr("the scene has no light to edit")) : Optional.empty());
            updateRows(scene);
            if (costs != null && !bar.isBusy()) {
                showOutcome();
            }
        }
    }

    private void showOutcome() {
        outcome.setText((editor.scene().equals(costsScene) ? "" : Messages.tr("Before the last edits: ")) + costsText);
    }

    private void updateRows(Scene scene) {
        SceneEffects effects = SceneEffects.of(scene);
        rows.forEach((effect, row) -> {
            row.setInUse(effects.has(effect));
            row.setCallers(effects.reason(effect));
        });
        summary.setText(Messages.tr("{0} uses {1} of {2} effects", editor.document().name(), effects.users().size(), rows.size()));
        // Unchanged rows stay in place, so that they keep the focus while a light is dragged.
        if (!effects.unused().equals(listedEffects) || costs != listedCosts) {
            listedEffects = effects.unused();
            listedCosts = costs;
            arrangeRows(effects);
        }
    }

    private void arrangeRows(SceneEffects effects) {
        List<Node> usedRows = new ArrayList<>(effects.users().keySet().stream().map(rows::get).toList());
        List<Node> unusedRows = new ArrayList<>(effects.unused().stream().map(rows::get).toList());
        absentLabel.setText(
                unusedRows.isEmpty() || costs != null ? "" : Messages.tr("Not used (no cost): {0}.",
                        String.join(", ", effects.unused().stream().map(e -> Messages.tr(e.title())).toList())));
        if (costs == null) {
            unusedRows.clear();
        } else {
            if (!unusedRows.isEmpty()) {
                unusedRows.addFirst(EffectRow.header(Messages.tr("Not used, saves"), ""));
            }
            usedRows.addFirst(EffectRow.header(Messages.tr("Used"), Messages.tr("Used by")));
        }
        // A node must have one parent only.
        usedBox.getChildren().clear();
        unusedBox.getChildren().setAll(unusedRows);
        usedBox.getChildren().setAll(usedRows);
    }

    /**
     * Returns the edit to measure: the last one if it changed no effect, else moving the first light, else any edit that the scene allows.
     */
    private Optional<LastEdit> editToMeasure() {
        return workbench.lastEdit()
                .filter(e -> SceneEffects.of(e.before()).unused().equals(SceneEffects.of(editor.scene()).unused()))
                .or(() -> PaperCases.moveCase(editor.scene()).or(() -> PaperCases.of(editor.scene()).stream().findFirst())
                        .map(c -> new LastEdit(c.before(), c.after(), true)));
    }

    private void measure() {
        Scene scene = editor.scene();
        editToMeasure().ifPresent(edit -> {
            RenderOptions options = accuracyMode.getValue().options();
            bar.start("lightning-effects",
                    progress -> EffectCosts.of(edit.before(), edit.after(), options, REPETITIONS, progress),
                    result -> showCosts(result, scene), outcome::setText);
            outcome.setText(Messages.tr("Measuring …"));
        });
    }

    private void showCosts(EffectCosts newCosts, Scene scene) {
        costs = newCosts;
        costsScene = scene;
        costsText =
                Messages.tr("Full render {0} · update {1} ({2}) · {3}. ≈: within noise",
                        StatusText.milliseconds(newCosts.first().median()),
                        StatusText.milliseconds(newCosts.update().median()), newCosts.plan(), EffectRow.bytes(newCosts.bytes()));
        showOutcome();
        newCosts.effects().forEach(cost -> requireNonNull(rows.get(cost.effect())).show(cost));
        updateRows(editor.scene());
    }
}

package lightning.editor.window.measure;

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
import lightning.base.text.Texts;
import lightning.bench.accuracy.EffectCosts;
import lightning.bench.accuracy.PaperCases;
import lightning.editor.document.LastEdit;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.Precision;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.WhileSeen;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import lightning.scene.effects.Effects;
import lightning.scene.effects.ViewEffects;

/**
 * The effects that the scene calls for, who calls for each, and what each costs, measured when the artist asks for it; one
 * click hides one from the view.
 */
public final class EffectsPane extends VBox {
    private static final int REPETITIONS = 5;

    private final SceneEditor editor;
    private final Workbench workbench;
    private final ObservableValue<Precision> precision;
    private final ObjectProperty<ViewEffects> view;
    private final Map<Effect, EffectRow> rows = new LinkedHashMap<>();
    private final Label summary = new Label();
    private final Label outcome = new Label();
    private final MeasureBar bar = new MeasureBar("-effects",
            Texts.of("Render the scene and its last edit with and without each effect in the background, in turns"));
    private final VBox used = new VBox();
    private final Label absent = new Label();
    private final VBox unused = new VBox();
    private final Obstacle nothingHidden;
    private EffectCosts costs;
    private Scene costsOf;
    private String costsText = "";
    private Scene told;
    /** The effects that are listed as absent, and the costs beside them. */
    private Set<Effect> listed;
    private EffectCosts listedCosts;

    /** @param view which effects the traced picture shows */
    public EffectsPane(SceneEditor editor, Workbench workbench, ObservableValue<Precision> precision, ObjectProperty<ViewEffects> view) {
        this.editor = editor;
        this.workbench = workbench;
        this.precision = precision;
        this.view = view;
        setId("effects");
        getStyleClass().add("effects");
        for (Effect effect : Effect.ALL) {
            var row = new EffectRow(effect);
            row.shown().selectedProperty().addListener((_, _, on) -> view.set(view.get().with(effect, on)));
            rows.put(effect, row);
        }
        summary.setId("effects-summary");
        outcome.setId("effects-outcome");
        outcome.getStyleClass().add("pane-note");
        outcome.setWrapText(true);
        outcome.setText(Texts.of("Measure tells what each effect costs in time and memory, and what the absence of the others saves."));
        var heading = new VBox(summary, outcome);
        HBox.setHgrow(heading, Priority.ALWAYS);
        bar.setMinWidth(Region.USE_PREF_SIZE);
        bar.setOnMeasure(this::measure);
        var head = new HBox(heading, bar);
        head.getStyleClass().add("effects-bottom");
        absent.setId("effects-absent");
        absent.getStyleClass().add("pane-note");
        absent.setWrapText(true);
        used.getStyleClass().add("effect-rows");
        unused.getStyleClass().add("effect-rows");
        var scroll = new ScrollPane(new VBox(used, absent, unused));
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        VBox.setVgrow(scroll, Priority.ALWAYS);
        var all = new Button(Texts.of("Show All"));
        all.setId("show-all-effects");
        all.setMinWidth(Region.USE_PREF_SIZE);
        all.setOnAction(_ -> view.set(ViewEffects.ALL));
        var allBox = new StackPane(all);
        nothingHidden = new Obstacle(allBox, all, Texts.of("Show the picture with everything that the scene calls for"));
        var bottom = new HBox(hint(), allBox);
        bottom.getStyleClass().add("effects-bottom");
        getChildren().addAll(head, scroll, bottom);
        WhileSeen.follow(this, () -> Subscription.combine(view.subscribe(this::show), editor.sceneProperty().subscribe(this::tell)));
    }

    private static Node hint() {
        var hint = new Label(Texts.of("A hidden effect is hidden from the view alone: Save Image and Verify take the picture itself."));
        hint.getStyleClass().add("pane-note");
        hint.setWrapText(true);
        HBox.setHgrow(hint, Priority.ALWAYS);
        hint.setMaxWidth(Double.MAX_VALUE);
        return hint;
    }

    private void show(ViewEffects effects) {
        rows.forEach((effect, row) -> row.shown().setSelected(effects.shows(effect)));
        nothingHidden.set(effects.showsAll() ? Optional.of(Texts.of("nothing is hidden")) : Optional.empty());
    }

    private void tell(Scene scene) {
        if (!scene.equals(told)) {
            told = scene;
            bar.setObstacle(scene.lights().isEmpty() ? Optional.of(Texts.of("the scene has no light to edit")) : Optional.empty());
            list(scene);
            if (costs != null && !bar.isBusy()) {
                tellOutcome();
            }
        }
    }

    private void tellOutcome() {
        outcome.setText((editor.scene().equals(costsOf) ? "" : Texts.of("Before the last edits: ")) + costsText);
    }

    private void list(Scene scene) {
        Effects effects = Effects.of(scene);
        rows.forEach((effect, row) -> {
            row.setUse(effects.has(effect));
            row.setCallers(effects.why(effect));
        });
        summary.setText(Texts.of("{0} calls for {1} of {2} effects", editor.document().name(), effects.callers().size(), rows.size()));
        // While a light is dragged, the rows stay where they are, and the keyboard with them.
        if (!effects.absent().equals(listed) || costs != listedCosts) {
            listed = effects.absent();
            listedCosts = costs;
            arrange(effects);
        }
    }

    private void arrange(Effects effects) {
        List<Node> inUse = new ArrayList<>(effects.callers().keySet().stream().map(rows::get).toList());
        List<Node> others = new ArrayList<>(effects.absent().stream().map(rows::get).toList());
        absent.setText(others.isEmpty() || costs != null ? "" : Texts.of("Not in the scene, and no work and memory spent on them: {0}.",
                String.join(", ", effects.absent().stream().map(e -> Texts.of(e.title())).toList())));
        if (costs == null) {
            others.clear();
        } else {
            if (!others.isEmpty()) {
                others.addFirst(EffectRow.head(Texts.of("Not in the scene, saves"), ""));
            }
            inUse.addFirst(EffectRow.head(Texts.of("In the scene"), Texts.of("Called for by")));
        }
        // A row must not be in two places at a time.
        used.getChildren().clear();
        unused.getChildren().setAll(others);
        used.getChildren().setAll(inUse);
    }

    /**
     * The edit to measure: the last one, unless it brought or took an effect; or else the first light moved, or else whatever
     * edit the scene allows.
     */
    private Optional<LastEdit> edit() {
        return (editor.isAnimating() ? Optional.<LastEdit>empty() : workbench.lastEdit())
                .filter(e -> Effects.of(e.before()).absent().equals(Effects.of(editor.scene()).absent()))
                .or(() -> PaperCases.moved(editor.scene()).or(() -> PaperCases.of(editor.scene()).stream().findFirst())
                        .map(c -> new LastEdit(c.before(), c.after(), true)));
    }

    private void measure() {
        Scene scene = editor.scene();
        edit().ifPresent(measured -> {
            Options options = precision.getValue().options();
            bar.begin("lightning-effects",
                    progress -> EffectCosts.of(measured.before(), measured.after(), options, REPETITIONS, progress),
                    result -> finished(result, scene), outcome::setText);
            outcome.setText(Texts.of("Measuring …"));
        });
    }

    private void finished(EffectCosts measured, Scene scene) {
        costs = measured;
        costsOf = scene;
        costsText =
                Texts.of("First pass {0} · update {1} ({2}) · {3}. ≈: within the noise", StatusText.milliseconds(measured.first().median()),
                        StatusText.milliseconds(measured.update().median()), measured.plan(), EffectRow.bytes(measured.bytes()));
        tellOutcome();
        measured.effects().forEach(cost -> rows.get(cost.effect()).show(cost));
        list(editor.scene());
    }
}

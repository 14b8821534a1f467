package lightning.editor.window.measure;

import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.bench.accuracy.EffectCost;
import lightning.scene.effects.Effect;

/** One effect: whether it is shown, what it costs where that was measured, and who calls for it. */
final class EffectRow extends HBox {
    /** What stands where nothing could be measured. */
    private static final String NONE = "–";
    private static final double UNIT = 1000;

    private final CheckBox shown = new CheckBox();
    private final Label absent = new Label();
    private final Label first = number();
    private final Label update = number();
    private final Label bytes = number();
    private final Label why = new Label();

    EffectRow(Effect effect) {
        String said = Texts.of(effect.title());
        String title = Character.toUpperCase(said.charAt(0)) + said.substring(1);
        String id = effect.id();
        shown.setText(title);
        shown.setId("effect-" + id);
        shown.setMinWidth(Region.USE_PREF_SIZE);
        absent.setText(title);
        absent.getStyleClass().add("effect-title");
        first.setId("first-" + id);
        update.setId("update-" + id);
        bytes.setId("bytes-" + id);
        why.getStyleClass().add("pane-note");
        why.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(why, Priority.ALWAYS);
        getStyleClass().add("effect-row");
        setUse(true);
    }

    private EffectRow(String title, String first, String update, String bytes, String why) {
        absent.setText(title);
        absent.getStyleClass().add("effect-title");
        this.first.setText(first);
        this.update.setText(update);
        this.bytes.setText(bytes);
        this.why.setText(why);
        getStyleClass().addAll("effect-row", "effect-head");
        getChildren().setAll(absent, this.first, this.update, this.bytes, this.why);
        numbers().forEach(n -> n.setVisible(true));
    }

    /** The heads of the columns. */
    static EffectRow head(String title, String why) {
        return new EffectRow(title, Texts.of("First pass"), Texts.of("Update"), Texts.of("Memory"), why);
    }

    private static Label number() {
        var label = new Label();
        label.getStyleClass().add("effect-number");
        label.setAlignment(Pos.CENTER_RIGHT);
        label.managedProperty().bind(label.visibleProperty());
        label.setVisible(false);
        return label;
    }

    private List<Label> numbers() {
        return List.of(first, update, bytes);
    }

    CheckBox shown() {
        return shown;
    }

    /** Only an effect in use can be hidden. */
    void setUse(boolean inUse) {
        getChildren().setAll(inUse ? shown : absent, first, update, bytes, why);
    }

    void setCallers(String text) {
        why.setText(text);
    }

    /** Shows what it costs, or what its absence saves. */
    void show(EffectCost cost) {
        numbers().forEach(n -> n.setVisible(true));
        first.setText(cost.measured() ? milliseconds(cost.firstMs(), cost.firstNoise()) : NONE);
        update.setText(cost.measured() ? milliseconds(cost.updateMs(), cost.updateNoise()) : NONE);
        bytes.setText(cost.measured() ? bytes(cost.bytes()) : NONE);
    }

    /** @param noise a difference of so much or less may be none, milliseconds */
    static String milliseconds(double v, double noise) {
        String text = String.format(Texts.locale(), Math.abs(v) < UNIT / 100 ? "%.2f ms" : "%.0f ms", v + 0.0);
        return (Math.abs(v) <= noise ? "≈ " : "") + (text.startsWith("-0.00") ? text.substring(1) : text).replace('-', '−');
    }

    static String bytes(long v) {
        double size = Math.abs((double) v);
        String text = size < UNIT ? v + " B" : size < UNIT * UNIT ? String.format(Texts.locale(), "%.1f kB", v / UNIT)
                : String.format(Texts.locale(), "%.1f MB", v / UNIT / UNIT);
        return text.replace('-', '−');
    }
}

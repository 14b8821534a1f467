package lightning.editor.window.measure;

import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.render.measure.EffectCost;
import lightning.scene.effects.RenderEffect;

/** Row of an effect: visibility, measured cost, and the scene elements that use it. */
final class EffectRow extends HBox {
    /** Placeholder for a value that could not be measured. */
    private static final String NONE = "–";
    private static final double UNIT = 1000;

    private final CheckBox visibleBox = new CheckBox();
    private final Label unusedTitle = new Label();
    private final Label first = number();
    private final Label update = number();
    private final Label bytes = number();
    private final Label callers = new Label();

    EffectRow(RenderEffect effect) {
        String name = Messages.tr(effect.title());
        String title = Character.toUpperCase(name.charAt(0)) + name.substring(1);
        String id = effect.id();
        visibleBox.setText(title);
        visibleBox.setId("effect-" + id);
        visibleBox.setMinWidth(Region.USE_PREF_SIZE);
        unusedTitle.setText(title);
        unusedTitle.getStyleClass().add("effect-title");
        first.setId("first-" + id);
        update.setId("update-" + id);
        bytes.setId("bytes-" + id);
        callers.getStyleClass().add("pane-note");
        callers.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(callers, Priority.ALWAYS);
        getStyleClass().add("effect-row");
        setInUse(true);
    }

    private EffectRow(String title, String first, String update, String bytes, String callers) {
        unusedTitle.setText(title);
        unusedTitle.getStyleClass().add("effect-title");
        this.first.setText(first);
        this.update.setText(update);
        this.bytes.setText(bytes);
        this.callers.setText(callers);
        getStyleClass().addAll("effect-row", "effect-head");
        getChildren().setAll(unusedTitle, this.first, this.update, this.bytes, this.callers);
        numbers().forEach(n -> n.setVisible(true));
    }

    /** Creates the header row. */
    static EffectRow header(String title, String callers) {
        return new EffectRow(title, Messages.tr("Full render"), Messages.tr("Update"), Messages.tr("Memory"), callers);
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

    CheckBox visibleBox() {
        return visibleBox;
    }

    /** Shows a check box for an effect in use, else a label. Only effects in use can be hidden. */
    void setInUse(boolean inUse) {
        getChildren().setAll(inUse ? visibleBox : unusedTitle, first, update, bytes, callers);
    }

    void setCallers(String text) {
        callers.setText(text);
    }

    /** Shows the cost of the effect, or the saving of an unused one. */
    void show(EffectCost cost) {
        numbers().forEach(n -> n.setVisible(true));
        first.setText(cost.measured() ? milliseconds(cost.firstMs(), cost.firstNoise()) : NONE);
        update.setText(cost.measured() ? milliseconds(cost.updateMs(), cost.updateNoise()) : NONE);
        bytes.setText(cost.measured() ? bytes(cost.bytes()) : NONE);
    }

    /** @param noise  absolute values up to this are within noise, milliseconds */
    static String milliseconds(double v, double noise) {
        String text = String.format(Messages.locale(), Math.abs(v) < UNIT / 100 ? "%.2f ms" : "%.0f ms", v + 0.0);
        return (Math.abs(v) <= noise ? "≈ " : "") + (text.startsWith("-0.00") ? text.substring(1) : text).replace('-', '−');
    }

    static String bytes(long v) {
        double size = Math.abs((double) v);
        String text = size < UNIT ? v + " B" : size < UNIT * UNIT ? String.format(Messages.locale(), "%.1f kB", v / UNIT)
                : String.format(Messages.locale(), "%.1f MB", v / UNIT / UNIT);
        return text.replace('-', '−');
    }
}

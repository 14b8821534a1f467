package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;
import lightning.base.text.Texts;
import lightning.editor.document.BankEdits;
import lightning.editor.document.Hsv;
import lightning.editor.document.Situation;
import lightning.editor.document.Steps;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Light;
import lightning.scene.Quantity;

/** Which bank the selected light belongs to, and that bank's master and gel. */
final class BankSection extends VBox {
    private static final String NO_BANK = Texts.key("the light is in no bank");

    private final SceneEditor editor;
    private final ArrowWidget master;
    private final ColorSliders gel;

    /**
     * @param bank says which bank the light belongs to
     * @param seen as in {@link PropertyPane}
     */
    BankSection(SceneEditor editor, NameBox bank, ObservableValue<Situation> seen) {
        this.editor = editor;
        getStyleClass().add("section-content");
        master = new ArrowWidget(Texts.of("Master"), "master", gauge("master", Bank.INTENSITY, (Double v, Double x) -> x));
        master.setId("master");
        gel = ColorSliders.ofSurface("gel", Texts.of("A factor of the colours of all its lights"), 1, new Gel());
        gel.setId("gel");
        getChildren().addAll(bank, master, Sections.caption(Texts.of("Gel")), gel);
        seen.subscribe(this::show);
    }

    private void show(Situation now) {
        Optional<Bank> of = now.selected().flatMap(l -> now.scene().rig().bank(l.bank()));
        Optional<String> obstacle = of.isPresent() ? Optional.empty() : Optional.of(Texts.of(NO_BANK));
        master.setObstacle(obstacle);
        gel.setObstacle(obstacle);
        of.ifPresentOrElse(b -> master.show(b.intensity()), master::showNothing);
        of.ifPresentOrElse(b -> gel.show(b.color()), gel::showNothing);
    }

    /** Forgets what was typed. */
    void revert() {
        master.revert();
        gel.revert();
    }

    private <V> Gauge gauge(String title, Attribute<Bank, V> attribute, BiFunction<V, Double, V> with) {
        Quantity<V> quantity = (Quantity<V>) attribute.kind();
        return Gauge.of(title, new Steps(quantity.step(), quantity.min(), quantity.max()),
                (value, gesture) -> edit(attribute, v -> with.apply(v, value), gesture));
    }

    private <V> Optional<String> edit(Attribute<Bank, V> attribute, UnaryOperator<V> with, Object gesture) {
        Light light = editor.selection().light();
        String name = light == null ? "" : light.bank();
        return editor.edit(scene -> BankEdits.with(scene, name, b -> attribute.with(b, with.apply(attribute.of(b)))), gesture);
    }

    /** The colour of the bank. */
    private final class Gel implements ColorSliders.Target {
        @Override
        public Gauge red() {
            return gauge("gel red", Bank.COLOR, (c, v) -> new Rgb(v, c.g(), c.b()));
        }

        @Override
        public Gauge green() {
            return gauge("gel green", Bank.COLOR, (c, v) -> new Rgb(c.r(), v, c.b()));
        }

        @Override
        public Gauge blue() {
            return gauge("gel blue", Bank.COLOR, (c, v) -> new Rgb(c.r(), c.g(), v));
        }

        @Override
        public Optional<String> hsv(Hsv color, Object gesture) {
            return edit(Bank.COLOR, _ -> color.rgb(), gesture);
        }
    }
}

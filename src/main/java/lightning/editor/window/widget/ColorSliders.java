package lightning.editor.window.widget;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.HsvColor;
import lightning.document.StepRange;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Color editor with a color well and tabs for RGB and HSV. */
public final class ColorSliders extends VBox implements ValueWidget<Rgb> {
    private static final double STEP = 0.1;

    private final Target target;
    private final String prefix;
    private final Button well = new Button();
    private final ToggleGroup tabs = new ToggleGroup();
    private final VBox content = new VBox();
    private final List<ColorSlider> rgb;
    /** Empty until its tab is shown first; {@link #square} is null until then. */
    private List<ColorSlider> hsv = List.of();
    private @Nullable ColorSquare square;
    private final DisabledReason disabledReason;
    private Rgb shownColor = Rgb.WHITE;
    private HsvColor shownHsv = HsvColor.of(Rgb.WHITE);
    /** Displayed color. */
    private @Nullable DisplayedColor displayed;

    private record DisplayedColor(Rgb color, HsvColor hsv) {}

    /** Receiver of edits. */
    public interface Target {
        /** Changes the color. Returns why it was refused; {@code gesture} as in {@link NumberSetting#set}. */
        Optional<String> edit(UnaryOperator<Rgb> change, @Nullable Object gesture);
    }

    /**
     * @param title  name for screen readers, for example {@code diffuse}; may be empty
     * @param help  description without a full stop
     * @param max  largest allowed channel value
     */
    public ColorSliders(String title, String help, double max, Target target) {
        this.target = target;
        prefix = title.isEmpty() ? "" : title + " ";
        rgb = List.of(channel("R", Messages.tr("red"), max, (c, v) -> new Rgb(v, c.g(), c.b())),
                channel("G", Messages.tr("green"), max, (c, v) -> new Rgb(c.r(), v, c.b())),
                channel("B", Messages.tr("blue"), max, (c, v) -> new Rgb(c.r(), c.g(), v)));
        well.getStyleClass().add("color-well");
        well.setTooltip(new Tooltip(Messages.tr("{0}.\nClick to change the color", help)));
        content.getStyleClass().add("color-content");
        HBox head = new HBox(well, tab("RGB", Messages.tr("red, green, blue"), () -> rgb),
                tab("HSV", Messages.tr("hue, saturation, value"), () -> hsvTab(max)));
        head.getStyleClass().add("color-head");
        well.setOnAction(_ -> {
            tabs.selectToggle(tabs.getToggles().get(1));
            requireNonNull(square).requestFocus();
        });
        VBox box = new VBox(head, content);
        box.getStyleClass().add("color-sliders");
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box);
        tabs.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                tabs.selectToggle(before);
            }
        });
        tabs.selectToggle(tabs.getToggles().getFirst());
        show(Rgb.WHITE);
    }

    /** Shows a color, linear, ≥ 0. */
    @Override
    public void show(Rgb color) {
        shownColor = color;
        if (!shownHsv.rgb().equals(color)) {
            HsvColor newColor = HsvColor.of(color);
            // Keeps the last hue for grays, so that saturation can be restored.
            shownHsv = newColor.saturation() == 0
                    ? new HsvColor(shownHsv.hue(), newColor.value() == 0 ? shownHsv.saturation() : 0, newColor.value())
                    : newColor;
        }
        var newColor = new DisplayedColor(color, shownHsv);
        if (!newColor.equals(displayed)) {
            displayed = newColor;
            draw(color);
        }
    }

    private void draw(Rgb color) {
        well.setStyle("-well-color: " + DisplayColors.css(color) + ";");
        well.setAccessibleText(
                prefix + String.format(Messages.locale(), Messages.tr("color: red %.3f, green %.3f, blue %.3f"), color.r(), color.g(),
                        color.b()));
        rgb.get(0).show(color.r(), v -> new Rgb(v, color.g(), color.b()));
        rgb.get(1).show(color.g(), v -> new Rgb(color.r(), v, color.b()));
        rgb.get(2).show(color.b(), v -> new Rgb(color.r(), color.g(), v));
        drawHsv();
    }

    private void drawHsv() {
        if (square == null) {
            return;
        }
        if (displayed == null) {
            hsv.forEach(ColorSlider::showNothing);
            square.show(new HsvColor(0, 0, 0));
            return;
        }
        HsvColor h = displayed.hsv();
        square.show(h);
        hsv.get(0).show(h.hue(), v -> new HsvColor(v, 1, 1).rgb());
        hsv.get(1).show(h.saturation(), v -> new HsvColor(h.hue(), v, Math.clamp(h.value(), 0, 1)).rgb());
        hsv.get(2).show(h.value(), v -> new HsvColor(h.hue(), h.saturation(), v).rgb());
    }

    @Override
    public void showNothing() {
        displayed = null;
        well.setStyle("-well-color: transparent;");
        well.setAccessibleText(prefix + Messages.tr("color: none"));
        rgb.forEach(ColorSlider::showNothing);
        drawHsv();
    }

    @Override
    public void revert() {
        rgb.forEach(ColorSlider::revert);
        hsv.forEach(ColorSlider::revert);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }

    private ColorSlider channel(String label, String name, double max, BiFunction<Rgb, Double, Rgb> edit) {
        String title = prefix + name;
        return new ColorSlider(label, title, ValueSlider.Scale.linear(0, 1),
                NumberSetting.of(title, new StepRange(STEP, 0, max), (v, gesture) -> target.edit(color -> {
                    SceneLimits.checkRange(title, v, 0, max);
                    return edit.apply(color, v);
                }, gesture)));
    }

    private ColorSlider hsv(String label, String title, StepRange steps, double max, BiFunction<HsvColor, Double, HsvColor> edit) {
        return new ColorSlider(label, title, ValueSlider.Scale.linear(0, max), NumberSetting.of(title, steps, (v, gesture) -> {
            HsvColor edited;
            try {
                edited = edit.apply(shownHsv, v);
            } catch (RefusalException e) {
                return Optional.of(e.getMessage());
            }
            return setHsv(edited, gesture);
        }));
    }

    /** Sets a color and keeps its hue even if the result has none, for example black. */
    private Optional<String> setHsv(HsvColor color, @Nullable Object gesture) {
        HsvColor oldHsv = shownHsv;
        shownHsv = color;
        Optional<String> refusal = target.edit(_ -> color.rgb(), gesture);
        if (refusal.isPresent()) {
            shownHsv = oldHsv;
        }
        show(shownColor);
        return refusal;
    }

    private List<Node> hsvTab(double max) {
        if (square == null) {
            square = new ColorSquare(this::setHsv);
            square.setAccessibleText(prefix + square.getAccessibleText());
            hsv = List.of(
                    hsv("H", prefix + Messages.tr("hue"), new StepRange(1, 0, 360), 360,
                            (h, v) -> new HsvColor(v, h.saturation(), h.value())),
                    hsv("S", prefix + Messages.tr("saturation"), new StepRange(STEP, 0, 1), 1,
                            (h, v) -> new HsvColor(h.hue(), v, h.value())),
                    hsv("V", prefix + Messages.tr("value"), new StepRange(STEP, 0, max), 1,
                            (h, v) -> new HsvColor(h.hue(), h.saturation(), v)));
            drawHsv();
        }
        return List.of(square, hsv.get(0), hsv.get(1), hsv.get(2));
    }

    /** @param nodes  supplies the tab's content each time it is selected */
    private ToggleButton tab(String name, String title, Supplier<List<? extends Node>> nodes) {
        ToggleButton tab = new ToggleButton(name);
        tab.setTooltip(new Tooltip(Messages.tr("Color as {0}", title)));
        tab.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(tab, Priority.ALWAYS);
        tab.setToggleGroup(tabs);
        tab.selectedProperty().addListener((_, _, selected) -> {
            if (selected) {
                content.getChildren().setAll(nodes.get());
            }
        });
        return tab;
    }
}

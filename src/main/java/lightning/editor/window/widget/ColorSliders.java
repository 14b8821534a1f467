package lightning.editor.window.widget;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;
import lightning.base.text.Measure;
import lightning.base.text.Texts;
import lightning.editor.document.Hsv;
import lightning.editor.document.Kelvin;
import lightning.editor.document.Steps;
import lightning.scene.Limits;

/**
 * A colour as red, green and blue, as hue, saturation and value, and that of a light as a temperature too; and a well that
 * shows it.
 */
public final class ColorSliders extends VBox {
    private static final List<Preset> PRESETS = List.of(new Preset(Texts.key("Candle"), 1900), new Preset(Texts.key("Tungsten"), 3200),
            new Preset(Texts.key("Daylight"), 5600), new Preset(Texts.key("Shade"), 8000));

    private final Target target;
    private final String prefix;
    private final Button well = new Button();
    private final ToggleGroup tabs = new ToggleGroup();
    private final VBox content = new VBox();
    private final List<ColorSlider> rgb;
    /** Empty before its tab was first in front; likewise {@link #square} and {@link #kelvin} are null. */
    private List<ColorSlider> hsv = List.of();
    private ColorSquare square;
    private ColorSlider kelvin;
    private final Obstacle obstacle;
    private Rgb shown = Rgb.WHITE;
    private Hsv shownHsv = Hsv.of(Rgb.WHITE);
    /** What the parts show; null for no colour. */
    private Drawn drawn;

    private record Drawn(Rgb color, Hsv hsv) {}

    /** Where the edits go. Each returns why it was refused; {@code gesture} as in {@link Gauge#set}. */
    public interface Target {
        Gauge red();

        Gauge green();

        Gauge blue();

        Optional<String> hsv(Hsv color, Object gesture);

        /** A surface has none. */
        default Optional<String> temperature(double kelvin, Object gesture) {
            return Optional.of(Texts.of("only a light has a colour temperature"));
        }
    }

    private record Preset(String name, double kelvin) {}

    /** The colour of a light. */
    public ColorSliders(Target target) {
        this("", Texts.of("The light's colour"), Limits.MAX_LIGHT_COLOR, true, target);
    }

    /**
     * A colour of a surface.
     *
     * @param title names it for screen readers: {@code diffuse}
     * @param help  what it does, a sentence without a full stop
     * @param max   the largest channel allowed
     */
    public static ColorSliders ofSurface(String title, String help, double max, Target target) {
        return new ColorSliders(title + " ", help, max, false, target);
    }

    private ColorSliders(String prefix, String help, double max, boolean ofLight, Target target) {
        this.target = target;
        this.prefix = prefix;
        rgb = List.of(channel("R", prefix + Texts.of("red"), target.red()), channel("G", prefix + Texts.of("green"), target.green()),
                channel("B", prefix + Texts.of("blue"), target.blue()));
        well.getStyleClass().add("color-well");
        well.setTooltip(new Tooltip(Texts.of("{0}.\nClick to pick another", help)));
        content.getStyleClass().add("color-content");
        HBox head = new HBox(well, tab("RGB", Texts.of("red, green, blue"), () -> rgb),
                tab("HSV", Texts.of("hue, saturation, value"), () -> hsvTab(max)));
        if (ofLight) {
            head.getChildren().add(tab("Kelvin", Texts.of("colour temperature"), this::kelvinTab));
        }
        head.getStyleClass().add("color-head");
        well.setOnAction(_ -> {
            tabs.selectToggle(tabs.getToggles().get(1));
            square.requestFocus();
        });
        VBox all = new VBox(head, content);
        all.getStyleClass().add("color-sliders");
        getChildren().add(all);
        obstacle = new Obstacle(this, all);
        tabs.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                tabs.selectToggle(before);
            }
        });
        tabs.selectToggle(tabs.getToggles().getFirst());
        show(Rgb.WHITE);
    }

    /** Shows a colour, linear, ≥ 0. */
    public void show(Rgb color) {
        shown = color;
        if (!shownHsv.rgb().equals(color)) {
            Hsv now = Hsv.of(color);
            // A grey has no hue: the last one stays, so that saturation can come back.
            shownHsv = now.saturation() == 0 ? new Hsv(shownHsv.hue(), now.value() == 0 ? shownHsv.saturation() : 0, now.value())
                    : now;
        }
        var now = new Drawn(color, shownHsv);
        if (!now.equals(drawn)) {
            drawn = now;
            draw(color);
        }
    }

    private void draw(Rgb color) {
        well.setStyle("-well-color: " + Paints.css(color) + ";");
        well.setAccessibleText(
                prefix + String.format(Texts.locale(), Texts.of("colour: red %.3f, green %.3f, blue %.3f"), color.r(), color.g(),
                        color.b()));
        rgb.get(0).show(color.r(), v -> new Rgb(v, color.g(), color.b()));
        rgb.get(1).show(color.g(), v -> new Rgb(color.r(), v, color.b()));
        rgb.get(2).show(color.b(), v -> new Rgb(color.r(), color.g(), v));
        drawHsv();
        drawKelvin();
    }

    private void drawHsv() {
        if (square == null) {
            return;
        }
        if (drawn == null) {
            hsv.forEach(ColorSlider::showNothing);
            square.show(new Hsv(0, 0, 0));
            return;
        }
        Hsv h = drawn.hsv();
        square.show(h);
        hsv.get(0).show(h.hue(), v -> new Hsv(v, 1, 1).rgb());
        hsv.get(1).show(h.saturation(), v -> new Hsv(h.hue(), v, Math.clamp(h.value(), 0, 1)).rgb());
        hsv.get(2).show(h.value(), v -> new Hsv(h.hue(), h.saturation(), v).rgb());
    }

    private void drawKelvin() {
        if (kelvin != null && drawn == null) {
            kelvin.showNothing();
        } else if (kelvin != null) {
            kelvin.show(Math.rint(Kelvin.of(drawn.color())), Kelvin::rgb);
        }
    }

    /** Shows that there is no colour. */
    public void showNothing() {
        drawn = null;
        well.setStyle("-well-color: transparent;");
        well.setAccessibleText(prefix + Texts.of("colour: none"));
        rgb.forEach(ColorSlider::showNothing);
        drawHsv();
        drawKelvin();
    }

    /** Forgets what was typed. */
    public void revert() {
        rgb.forEach(ColorSlider::revert);
        hsv.forEach(ColorSlider::revert);
        if (kelvin != null) {
            kelvin.revert();
        }
    }

    /** Disables the widget and says why, a clause; or enables it. */
    public void setObstacle(Optional<String> reason) {
        obstacle.set(reason);
    }

    private static ColorSlider channel(String label, String title, Gauge gauge) {
        return new ColorSlider(label, title, ColorSlider.Scale.even(0, 1), gauge);
    }

    private ColorSlider hsv(String label, String title, Steps steps, double max, BiFunction<Hsv, Double, Hsv> edit) {
        return new ColorSlider(label, title, ColorSlider.Scale.even(0, max), Gauge.of(title, steps, (v, gesture) -> {
            Hsv edited;
            try {
                edited = edit.apply(shownHsv, v);
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
            return setHsv(edited, gesture);
        }));
    }

    /** Keeps the hue of a colour that has none, as black. */
    private Optional<String> setHsv(Hsv color, Object gesture) {
        Hsv before = shownHsv;
        shownHsv = color;
        Optional<String> refusal = target.hsv(color, gesture);
        if (refusal.isPresent()) {
            shownHsv = before;
        }
        show(shown);
        return refusal;
    }

    private List<Node> hsvTab(double max) {
        if (square == null) {
            square = new ColorSquare(this::setHsv);
            square.setAccessibleText(prefix + square.getAccessibleText());
            hsv = List.of(
                    hsv("H", prefix + Texts.of("hue"), new Steps(1, 0, 360), 360, (h, v) -> new Hsv(v, h.saturation(), h.value())),
                    hsv("S", prefix + Texts.of("saturation"), new Steps(0.1, 0, 1), 1, (h, v) -> new Hsv(h.hue(), v, h.value())),
                    hsv("V", prefix + Texts.of("value"), new Steps(0.1, 0, max), 1,
                            (h, v) -> new Hsv(h.hue(), h.saturation(), v)));
            drawHsv();
        }
        return List.of(square, hsv.get(0), hsv.get(1), hsv.get(2));
    }

    private List<Node> kelvinTab() {
        if (kelvin == null) {
            kelvin = new ColorSlider("K", "temperature",
                    new ColorSlider.Scale(Kelvin.MIN, Kelvin.MAX, Math::log, Math::exp),
                    Gauge.of("temperature", new Steps(100, Kelvin.MIN, Kelvin.MAX), Measure.KELVIN, target::temperature));
            drawKelvin();
        }
        return List.of(kelvin, presets());
    }

    private Node presets() {
        FlowPane presets = new FlowPane();
        presets.getStyleClass().add("presets");
        for (Preset preset : PRESETS) {
            Button button = new Button(Texts.of(preset.name()));
            button.getStyleClass().add("small");
            button.setTooltip(new Tooltip(Limits.text(preset.kelvin()) + " K"));
            button.setOnAction(_ -> target.temperature(preset.kelvin(), null));
            presets.getChildren().add(button);
        }
        return presets;
    }

    /** @param nodes asked for whenever the tab comes in front */
    private ToggleButton tab(String name, String title, Supplier<List<? extends Node>> nodes) {
        ToggleButton tab = new ToggleButton(name);
        tab.setTooltip(new Tooltip(Texts.of("Colour as {0}", title)));
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

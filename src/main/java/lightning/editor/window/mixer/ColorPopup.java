package lightning.editor.window.mixer;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.layout.StackPane;
import javafx.stage.Popup;
import javafx.util.Subscription;
import lightning.base.math.Rgb;
import lightning.base.text.Texts;
import lightning.editor.document.Channel;
import lightning.editor.document.Hsv;
import lightning.editor.document.Kelvin;
import lightning.editor.document.Steps;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.Looks;
import lightning.scene.Limits;

/** The colour of a strip, below its chip until the mouse goes elsewhere. All strips that are selected with it get the same. */
final class ColorPopup {
    private static final double WIDTH = 300;

    private final Board board;
    private final Channel channel;
    private final double most;
    private final ColorSliders sliders;

    ColorPopup(Board board, Channel channel) {
        this.board = board;
        this.channel = channel;
        most = channel instanceof Channel.OfBank ? 1 : Limits.MAX_LIGHT_COLOR;
        sliders = channel instanceof Channel.OfBank
                ? ColorSliders.ofSurface(channel.title(), Texts.of("The gel, a factor of its lights' colours"), 1, new Target())
                : new ColorSliders(new Target());
    }

    void show(Node below) {
        var pane = new StackPane(sliders);
        pane.getStyleClass().addAll("color-popup", "root");
        Looks.color(pane);
        pane.setId("color-popup");
        pane.setPrefWidth(WIDTH);
        var popup = new Popup();
        popup.setAutoHide(true);
        popup.setHideOnEscape(true);
        popup.getContent().add(pane);
        Looks.dress(popup.getScene());
        Subscription shown = board.editor().sceneProperty().subscribe(scene -> {
            if (channel.isIn(scene)) {
                channel.color(scene).ifPresent(sliders::show);
            } else {
                popup.hide();
            }
        });
        popup.setOnHidden(_ -> shown.unsubscribe());
        Bounds at = below.localToScreen(below.getBoundsInLocal());
        popup.show(below, at.getMinX(), at.getMaxY() + 4);
    }

    private Gauge gauge(String title, BiFunction<Rgb, Double, Rgb> with) {
        return Gauge.of(title, new Steps(0.1, 0, most), (v, gesture) -> set(c -> with.apply(c, v), gesture));
    }

    private interface ColorEdit {
        Rgb of(Rgb color);
    }

    private Optional<String> set(ColorEdit edit, Object gesture) {
        return board.each(channel, (scene, c) -> c.color(scene).map(now -> c.withColor(scene, edit.of(now))).orElse(scene), gesture);
    }

    private final class Target implements ColorSliders.Target {
        @Override
        public Gauge red() {
            return gauge("red", (c, v) -> new Rgb(v, c.g(), c.b()));
        }

        @Override
        public Gauge green() {
            return gauge("green", (c, v) -> new Rgb(c.r(), v, c.b()));
        }

        @Override
        public Gauge blue() {
            return gauge("blue", (c, v) -> new Rgb(c.r(), c.g(), v));
        }

        @Override
        public Optional<String> hsv(Hsv color, Object gesture) {
            return set(_ -> color.rgb(), gesture);
        }

        @Override
        public Optional<String> temperature(double kelvin, Object gesture) {
            return set(c -> Kelvin.rgb(kelvin).times(c.isBlack() ? 1 : c.max()), gesture);
        }
    }
}

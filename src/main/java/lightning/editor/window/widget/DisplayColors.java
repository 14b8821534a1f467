package lightning.editor.window.widget;

import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javafx.scene.paint.Color;
import lightning.base.math.Rgb;
import lightning.render.image.ViewTransform;

/** Converts linear colors to display colors, at exposure 0. */
public final class DisplayColors {
    private static final int GRADIENT_STOPS = 8;

    private DisplayColors() {}

    /** Returns the display color. Colors brighter than white are scaled by their largest channel. */
    public static Color color(Rgb linear) {
        Rgb c = linear.times(1 / Math.max(1, linear.max()));
        return Color.rgb(encode(c.r()), encode(c.g()), encode(c.b()));
    }

    /** Returns a color as CSS. */
    public static String css(Rgb linear) {
        Color c = color(linear);
        return String.format(Locale.ROOT, "#%02x%02x%02x", Math.round(c.getRed() * 255), Math.round(c.getGreen() * 255),
                Math.round(c.getBlue() * 255));
    }

    /**
     * Returns a gradient as CSS.
     *
     * @param color  color at a fraction from the left, 0, to the right, 1
     */
    public static String gradient(DoubleFunction<Rgb> color) {
        return IntStream.rangeClosed(0, GRADIENT_STOPS).mapToObj(i -> css(color.apply(i / (double) GRADIENT_STOPS)))
                .collect(Collectors.joining(", ", "linear-gradient(to right, ", ")"));
    }

    private static int encode(double linear) {
        return ViewTransform.DEFAULT.encode((float) linear);
    }
}

package lightning.editor.window.preview;

import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Exposure of the preview that gives it the mean brightness of the traced picture. The preview lacks most shadows, which makes it brighter,
 * and indirect light, which makes it darker.
 */
final class BrightnessMatch {
    /** Maximum change in stops. */
    static final double MAX_STOPS = 4;
    /** Mean below which a picture is black. */
    private static final double BLACK = 1e-4;
    /** Each step halves the interval of the result. */
    private static final int STEPS = 14;
    /** Longer side of the grid of compared pixels. */
    private static final int GRID = 96;

    private BrightnessMatch() {}

    /**
     * Returns the stops to add to the preview's exposure; 0 if one of the pictures is black.
     *
     * @param gain factor of linear values in the view transform, above which values of 1 are clipped
     */
    static double stops(Film preview, Film traced, double gain) {
        double[] previewLuminances = luminances(preview);
        double target = mean(luminances(traced), gain);
        if (target < BLACK || mean(previewLuminances, gain) < BLACK) {
            return 0;
        }
        double low = -MAX_STOPS;
        double high = MAX_STOPS;
        for (int i = 0; i < STEPS; i++) {
            double middle = (low + high) / 2;
            if (mean(previewLuminances, gain * Math.pow(2, middle)) < target) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }

    /** Returns the view transform with a changed exposure. */
    static ViewTransform exposed(ViewTransform view, double stops) {
        return new ViewTransform(Math.clamp(view.exposure() + stops, -ViewTransform.MAX_EXPOSURE, ViewTransform.MAX_EXPOSURE), view.curve(),
                view.lut(), view.shaper(), view.marksClipping());
    }

    private static double[] luminances(Film film) {
        int step = Math.max(1, Math.max(film.width(), film.height()) / GRID);
        int columns = Math.ceilDiv(film.width(), step);
        return IntStream.range(0, columns * Math.ceilDiv(film.height(), step)).mapToDouble(i -> {
            int x = i % columns * step;
            int y = i / columns * step;
            return Math.max(0, new Rgb(film.red(x, y), film.green(x, y), film.blue(x, y)).luminance());
        }).toArray();
    }

    /** Returns the mean of the displayed luminances: bright lamps count as white. */
    private static double mean(double[] luminances, double gain) {
        double sum = 0;
        for (double luminance : luminances) {
            sum += Math.min(1, gain * luminance);
        }
        return sum / luminances.length;
    }
}

package lightning.editor.window.property;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

/** Display colors of small pictures of high dynamic range. */
final class AutoExposure {
    private static final ViewTransform VIEW = new ViewTransform(0, DisplayCurve.FILMIC);
    /** Brightness of the mean pixel before the curve. */
    private static final double GRAY = 0.18;
    /** Brighter pixels count as this or as a multiple of the median, whichever is larger, so that small suns do not darken the rest. */
    private static final double MAX_LUMINANCE = 4;
    private static final double MAX_MEDIANS = 8;

    private AutoExposure() {}

    /**
     * Returns display colors, exposed so that the mean is a medium gray.
     *
     * @param rgb linear values, three for each pixel
     * @return opaque 0xFFRRGGBB for each pixel
     */
    static int[] toPixels(float[] rgb) {
        int[] pixels = new int[rgb.length / 3];
        double[] luminances = new double[pixels.length];
        Arrays.setAll(luminances, i -> new Rgb(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]).luminance());
        Arrays.sort(luminances);
        double max = Math.max(MAX_LUMINANCE, MAX_MEDIANS * luminances[pixels.length / 2]);
        double sum = Arrays.stream(luminances).map(v -> Math.min(v, max)).sum();
        float gain = sum > 0 ? (float) (GRAY * pixels.length / sum) : 1;
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = 0xFF000000 | VIEW.pack(gain * rgb[3 * i], gain * rgb[3 * i + 1], gain * rgb[3 * i + 2]);
        }
        return pixels;
    }
}

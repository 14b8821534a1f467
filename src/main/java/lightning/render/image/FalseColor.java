package lightning.render.image;

import java.util.List;
import java.util.stream.IntStream;

/**
 * False-color scale of luminance (Rec. 709), one color per stop from middle gray 0.18. Gray is half a stop around it, colder colors
 * are darker, warmer ones brighter. White is 2.5 stops above, so orange and red mark clipped values.
 */
public final class FalseColor {
    /** Linear luminance of stop 0. */
    public static final double MIDDLE_GRAY = 0.18;

    private static final int MIN_STOP = -6;
    /** Colors from {@link #MIN_STOP} on, 0xRRGGBB. */
    private static final int[] COLORS = {0x14051F, 0x3B0F70, 0x2743B8, 0x1F7FC4, 0x16A5A0, 0x2E9E4F, 0x808080, 0xB9C74A, 0xF3DE5E, 0xF08A24,
        0xE0241B};
    private static final float SCALE = (float) (StrictMath.sqrt(2) / MIDDLE_GRAY);

    /**
     * One stop of the scale.
     *
     * @param stop stops from middle gray; the first band includes all below, the last all above
     * @param rgb  0xRRGGBB
     */
    public record Band(int stop, int rgb) {}

    private FalseColor() {}

    /** Returns all bands, from the darkest. */
    public static List<Band> bands() {
        return IntStream.range(0, COLORS.length).mapToObj(i -> new Band(MIN_STOP + i, COLORS[i])).toList();
    }

    /** Returns the color, 0xRRGGBB, of a linear pixel. */
    static int rgb(float red, float green, float blue) {
        float luminance = 0.2126f * red + 0.7152f * green + 0.0722f * blue;
        // The exponent of v·√2 is the nearest stop of v; that of 0 and NaN is beyond the ends.
        int stop = luminance > 0 ? Math.getExponent(luminance * SCALE) : Integer.MIN_VALUE / 2;
        return COLORS[Math.clamp(stop - (long) MIN_STOP, 0, COLORS.length - 1)];
    }
}

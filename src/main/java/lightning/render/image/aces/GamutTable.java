package lightning.render.image.aces;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import lightning.base.math.Primaries;

/** Table of {@link HueSlice}s over the hue. Entries are computed on first use, in 0.1 milliseconds each. */
final class GamutTable {
    private static final AppearanceModel SCENE = new AppearanceModel(Primaries.AP1);
    private static final AppearanceModel DISPLAY = new AppearanceModel(Primaries.REC709);
    /** Corners of the RGB cube around the gray axis, in order of hue. */
    private static final double[][] CORNERS = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    private static final double[] CORNER_HUES = Arrays.stream(CORNERS).mapToDouble(rgb -> DISPLAY.jmh(rgb)[2]).toArray();
    private static final double REACH_STEP = 50;
    private static final double MAX_REACH = 1300;
    /** Shares of the way from the cusp to white at which the upper boundary must contain the gamut. */
    private static final double[] TESTED = {0.01, 0.1, 0.5, 0.8, 0.99};
    private static final double MAX_GAMMA = 5;

    /** Each degree and the hue of each corner, so that no table cuts a corner off. */
    private static final double[] HUES =
            DoubleStream.concat(IntStream.rangeClosed(0, 360).asDoubleStream(), Arrays.stream(CORNER_HUES)).sorted().toArray();
    /** Slice of each entry of {@link #HUES}, or null. Threads that compute the same slice write equal records. */
    private static final HueSlice[] SLICES = new HueSlice[HUES.length];

    private GamutTable() {}

    /** Returns the slice at a hue in degrees, 0 to 360. */
    static HueSlice slice(double hue) {
        int found = Arrays.binarySearch(HUES, hue);
        int i = Math.clamp(found < 0 ? -found - 2 : found, 0, HUES.length - 2);
        double t = (hue - HUES[i]) / (HUES[i + 1] - HUES[i]);
        HueSlice a = entry(i);
        HueSlice b = entry(i + 1);
        return new HueSlice(lerp(a.cuspJ(), b.cuspJ(), t), lerp(a.cuspM(), b.cuspM(), t), lerp(a.upperPower(), b.upperPower(), t),
                lerp(a.reach(), b.reach(), t));
    }

    private static HueSlice entry(int i) {
        HueSlice slice = SLICES[i];
        if (slice == null) {
            slice = compute(HUES[i]);
            SLICES[i] = slice;
        }
        return slice;
    }

    private static double lerp(double a, double b, double t) {
        return a + t * (b - a);
    }

    /** Returns M at which a color with J = 100 gets a negative component in AP1. */
    private static double reach(double hue) {
        double high = REACH_STEP;
        while (high < MAX_REACH && isPositive(SCENE.rgb(100, high, hue))) {
            high += REACH_STEP;
        }
        double low = high - REACH_STEP;
        while (high - low > 1e-2) {
            double middle = (low + high) / 2;
            if (isPositive(SCENE.rgb(100, middle, hue))) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }

    private static boolean isPositive(double[] rgb) {
        return rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0;
    }

    private static HueSlice compute(double hue) {
        double[] cusp = cusp(hue);
        return withUpperBoundary(new HueSlice(cusp[0], cusp[1] * HueSlice.OUTWARD, 1, reach(hue)), hue);
    }

    /** Returns J, M and hue of the cusp: a point on the edges of the RGB cube between the corners. */
    private static double[] cusp(double hue) {
        int corner = 0;
        while (!(angle(CORNER_HUES[corner], hue) < angle(CORNER_HUES[corner], CORNER_HUES[(corner + 1) % 6]))) {
            corner++;
        }
        double[] from = CORNERS[corner];
        double[] to = CORNERS[(corner + 1) % 6];
        double target = angle(CORNER_HUES[corner], hue);
        double low = 0;
        double high = 1;
        while (high - low > 1e-7) {
            double middle = (low + high) / 2;
            // Rounding can put a sample near the corner on its other side, almost 360 degrees away.
            double sample = angle(CORNER_HUES[corner], onEdge(from, to, middle)[2]);
            if (sample <= target || sample > 180) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return onEdge(from, to, (low + high) / 2);
    }

    /** Returns the angle from one hue up to another, 0 to 360 degrees. */
    private static double angle(double from, double to) {
        return to >= from ? to - from : to - from + 360;
    }

    private static double[] onEdge(double[] from, double[] to, double t) {
        return DISPLAY.jmh(lerp(from[0], to[0], t), lerp(from[1], to[1], t), lerp(from[2], to[2], t));
    }

    /** Returns the slice with the smallest γ of the upper boundary that contains the display's gamut. */
    private static HueSlice withUpperBoundary(HueSlice slice, double hue) {
        double low = 0;
        double high = MAX_GAMMA;
        while (high - low > 1e-5) {
            double middle = (low + high) / 2;
            if (contains(slice.withUpperPower(1 / middle), hue)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return slice.withUpperPower(1 / high);
    }

    private static boolean contains(HueSlice slice, double hue) {
        for (double share : TESTED) {
            double[] point = slice.boundaryPoint(lerp(slice.cuspJ(), 100, share), slice.cuspM());
            double[] rgb = DISPLAY.rgb(point[0], point[1], hue);
            if (rgb[0] <= 1 && rgb[1] <= 1 && rgb[2] <= 1) {
                return false;
            }
        }
        return true;
    }
}

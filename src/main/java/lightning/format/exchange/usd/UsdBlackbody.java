package lightning.format.exchange.usd;

import lightning.base.math.Rgb;
import lightning.scene.value.ColorTemperature;

/**
 * Colors of temperatures in UsdLux, as {@code UsdLuxBlackbodyTemperatureAsRgb} of OpenUSD defines them: a Catmull-Rom spline through 19
 * colors of black bodies, with the luminance of white. Unlike {@link ColorTemperature#tint}, the color of 6500 K is not white.
 */
final class UsdBlackbody {
    private static final double MIN = 1000;
    private static final double STEP = 500;
    /** Linear Rec. 709 colors from 1000 K to 10000 K: red, green, blue. */
    private static final double[][] KNOTS = {{1, 0.027490, 0}, {1, 0.149664, 0}, {1, 0.256644, 0.008095}, {1, 0.372033, 0.067450},
        {1, 0.476725, 0.153601}, {1, 0.570376, 0.259196}, {1, 0.653480, 0.377155}, {1, 0.726878, 0.501606}, {1, 0.791543, 0.628050},
        {1, 0.848462, 0.753228}, {1, 0.898581, 0.874905}, {1, 0.942771, 0.991642}, {0.906947, 0.890456, 1}, {0.828247, 0.841838, 1},
        {0.765791, 0.801896, 1}, {0.715255, 0.768579, 1}, {0.673683, 0.740423, 1}, {0.638992, 0.716359, 1}, {0.609681, 0.695588, 1}};

    private UsdBlackbody() {}

    /**
     * Returns the color that multiplies that of a light.
     *
     * @param kelvin clamped to 1000…10000
     */
    static Rgb tint(double kelvin) {
        double position = Math.clamp((kelvin - MIN) / STEP, 0, KNOTS.length - 1.0);
        int knot = (int) position;
        Rgb color = new Rgb(spline(knot, position - knot, 0), spline(knot, position - knot, 1), spline(knot, position - knot, 2));
        Rgb scaled = color.times(1 / color.luminance());
        return new Rgb(Math.max(scaled.r(), 0), Math.max(scaled.g(), 0), Math.max(scaled.b(), 0));
    }

    /** Returns one channel between a knot and the next, with tangents along the chords of their neighbors. The ends count twice. */
    private static double spline(int knot, double t, int channel) {
        double from = value(knot, channel);
        double to = value(knot + 1, channel);
        double fromTangent = (to - value(knot - 1, channel)) / 2;
        double toTangent = (value(knot + 2, channel) - from) / 2;
        double left = 1 - t;
        return from * left * left * (1 + 2 * t) + to * t * t * (3 - 2 * t) + fromTangent * t * left * left - toTangent * t * t * left;
    }

    private static double value(int knot, int channel) {
        return KNOTS[Math.clamp(knot, 0, KNOTS.length - 1)][channel];
    }

    /**
     * Returns the factor by which a light's color here differs from that in USD, so that both lights have the same color; 1 in channels
     * without light here.
     *
     * @param usdKelvin temperature in USD
     * @param kelvin    temperature here, 1667…25000
     */
    static Rgb correction(double usdKelvin, double kelvin) {
        Rgb usd = tint(usdKelvin);
        Rgb here = ColorTemperature.tint(kelvin);
        return new Rgb(ratio(usd.r(), here.r()), ratio(usd.g(), here.g()), ratio(usd.b(), here.b()));
    }

    private static double ratio(double usd, double here) {
        return here > 0 ? usd / here : 1;
    }
}

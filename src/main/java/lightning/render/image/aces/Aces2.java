package lightning.render.image.aces;

import lightning.base.math.Matrix3;
import lightning.base.math.Primaries;
import lightning.base.math.SrgbCurve;

/** Exact output transform of ACES 2, from linear Rec. 709 to sRGB. Evaluates 30 powers, about a microsecond. */
final class Aces2 {
    /** Largest component in AP1; brighter ones are clamped. */
    static final double MAX = 1024;

    private static final AppearanceModel SCENE = new AppearanceModel(Primaries.AP1);
    private static final AppearanceModel DISPLAY = new AppearanceModel(Primaries.REC709);
    private static final Matrix3 TO_AP1 = Primaries.REC709.to(Primaries.AP1);

    private Aces2() {}

    /** Returns the encoded color. It can leave 0…1 a little, because the gamut's boundary is approximated; the display clamps it. */
    static double[] encoded(double red, double green, double blue) {
        double[] rgb = TO_AP1.times(red, green, blue);
        for (int c = 0; c < 3; c++) {
            // NaN becomes 0.
            rgb[c] = rgb[c] > 0 ? Math.min(rgb[c], MAX) : 0;
        }
        double[] shown = rendered(SCENE.opponents(rgb));
        return new double[] {encode(shown[0]), encode(shown[1]), encode(shown[2])};
    }

    /** Returns the linear display color of a scene color's {@link AppearanceModel#opponents}. */
    private static double[] rendered(double[] opponents) {
        double[] jmh = AppearanceModel.correlates(opponents);
        double j = jmh[0];
        double m = jmh[1];
        double hue = jmh[2];
        if (j == 0) {
            return new double[3];
        }
        double toned = AppearanceModel.lightnessOfGray(Tonescale.display(AppearanceModel.luminanceOfGray(opponents[0])));
        HueSlice slice = GamutTable.slice(hue);
        if (m > 0) {
            m = ChromaCompression.compress(m, j, toned, slice.reach(), opponents[1] / m, opponents[2] / m);
        }
        double[] inside = slice.compress(toned, m);
        return DISPLAY.rgb(inside[0], inside[1], hue);
    }

    /** Returns the sRGB encoding, symmetric around 0. */
    static double encode(double v) {
        return Math.copySign(SrgbCurve.fromLinear(Math.abs(v)), v);
    }
}

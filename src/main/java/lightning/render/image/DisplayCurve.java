package lightning.render.image;

import java.util.function.DoubleUnaryOperator;

/** How linear light becomes 8 or 16 bits of a display, correctly rounded. */
public enum DisplayCurve {
    /**
     * What displays expect (IEC 61966-2-1): {@code 12.92 · v} up to v = 0.0031308, else {@code 1.055 · v^(1/2.4) − 0.055}.
     */
    SRGB("srgb", "sRGB", Srgb::encoded, 1),
    /**
     * As computed in 1998: the linear value itself, {@code 255 · v}. Programs of that time sent it to the display as it was,
     * which shows mid tones darker and shadows deeper than they are.
     */
    LINEAR("1998", "Linear (No Curve)", v -> v, 1),
    /** {@link ToneCurves#filmic}, then sRGB. */
    FILMIC("filmic", "Filmic (Hable)", v -> Srgb.encoded(ToneCurves.filmic(v)), ToneCurves.FILMIC_WHITE),
    /** {@link ToneCurves#aces}, then sRGB. */
    ACES("aces", "ACES (Approximation)", v -> Srgb.encoded(ToneCurves.aces(v)), ToneCurves.ACES_WHITE),
    /** {@link FalseColor}: stops instead of colors. Single values are shown as by sRGB. */
    FALSE("false", "False Color", Srgb::encoded, 1);

    private static final double WHITE_16 = 0xFFFF;

    private final String keyword;
    private final String title;
    private final DoubleUnaryOperator curve;
    private final double white;
    private CodeTable table;
    private CurveTable valueTable;

    DisplayCurve(String word, String title, DoubleUnaryOperator curve, double white) {
        this.keyword = word;
        this.title = title;
        this.curve = v -> curve.applyAsDouble(Math.min(v, white));
        this.white = white;
    }

    /** As an artist types it. */
    public String word() {
        return keyword;
    }

    /** As menus have it. */
    public String title() {
        return title;
    }

    /** The linear value that is shown as white, and all above too. */
    public double white() {
        return white;
    }

    /** The codes, made when they are needed first: that takes some milliseconds. */
    CodeTable table() {
        synchronized (this) {
            if (table == null) {
                table = CodeTable.of(curve, white > 1 ? (float) Math.scalb(1.0, Math.getExponent(white) + 1) : 1);
            }
            return table;
        }
    }

    /**
     * What the display would get of a linear value, 0 to 1, before it is rounded to a code; the linear curve's own value, which is not cut
     * off. Within 10⁻⁶ of the curve; below 0 and NaN count as 0.
     */
    double value(float linear) {
        if (this == LINEAR) {
            return linear > 0 ? linear : 0;
        }
        return valueTable().value(linear);
    }

    private CurveTable valueTable() {
        synchronized (this) {
            if (valueTable == null) {
                valueTable = CurveTable.of(curve);
            }
            return valueTable;
        }
    }

    /** The definition of the codes, without a table. */
    int formula(float linear) {
        return CodeTable.formula(curve, linear);
    }

    /** The code of 16 bits, 0 to 65535, of a linear value; below 0 and NaN count as 0. */
    int encode16(float linear) {
        return linear > 0 ? (int) StrictMath.floor(WHITE_16 * Math.clamp(curve.applyAsDouble(linear), 0, 1) + 0.5) : 0;
    }
}

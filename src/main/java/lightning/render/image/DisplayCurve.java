package lightning.render.image;

import java.util.function.DoubleUnaryOperator;
import lightning.base.math.CurveTable;
import lightning.base.math.SrgbCurve;
import lightning.render.image.aces.Aces2Table;
import org.jspecify.annotations.Nullable;

/** Tone curve from linear light to 8- or 16-bit display codes, correctly rounded. */
public enum DisplayCurve {
    /** sRGB encoding (IEC 61966-2-1): {@code 12.92 · v} up to v = 0.0031308, else {@code 1.055 · v^(1/2.4) − 0.055}. */
    SRGB("srgb", "sRGB", SrgbCurve::fromLinear, 1),
    /**
     * No curve: the linear value itself, {@code 255 · v}. Programs of 1998 sent it to the display unchanged, which shows midtones
     * and shadows too dark.
     */
    LINEAR("1998", "Linear (No Curve)", v -> v, 1),
    /** {@link Filmic}: mixes the channels of bright colors. Single values are shown as grays. */
    FILMIC("filmic", "Filmic", Filmic::gray, Filmic.WHITE),
    /** {@link ToneCurves#aces}, then sRGB. */
    ACES("aces", "ACES (Approximation)", v -> SrgbCurve.fromLinear(ToneCurves.aces(v)), ToneCurves.ACES_WHITE),
    /** {@link Aces2Table ACES 2}: mixes the channels. Single values are shown as grays. */
    ACES2("aces2", "ACES 2", Aces2Table::gray, Aces2Table.WHITE),
    /** {@link AgX}: mixes the channels. Single values are shown as grays. */
    AGX("agx", "AgX", AgX::gray, AgX.WHITE),
    /** {@link FalseColor}: exposure stops as colors. Single values are encoded as sRGB. */
    FALSE("false", "False Color", SrgbCurve::fromLinear, 1);

    private static final double WHITE_16 = 0xFFFF;

    private final String keyword;
    private final String title;
    private final DoubleUnaryOperator curve;
    private final double white;
    private @Nullable CodeTable table;
    private @Nullable CurveTable valueTable;

    DisplayCurve(String word, String title, DoubleUnaryOperator curve, double white) {
        this.keyword = word;
        this.title = title;
        this.curve = v -> curve.applyAsDouble(Math.min(v, white));
        this.white = white;
    }

    /** Returns the keyword for files and options. */
    public String word() {
        return keyword;
    }

    /** Returns the menu title. */
    public String title() {
        return title;
    }

    /** Returns whether a channel of the shown color depends on all channels. */
    boolean mixesChannels() {
        return this == AGX || this == ACES2 || this == FILMIC;
    }

    /** Returns the smallest linear value that is shown as white. */
    public double white() {
        return white;
    }

    /** Returns the code table, created on first use in a few milliseconds. */
    CodeTable table() {
        synchronized (this) {
            if (table == null) {
                table = CodeTable.of(curve, white > 1 ? (float) Math.scalb(1.0, Math.getExponent(white) + 1) : 1);
            }
            return table;
        }
    }

    /**
     * Returns the display value, 0 to 1, of a linear value before rounding to a code. The linear curve returns its value unclamped.
     * Within 10⁻⁶ of the curve; below 0 and NaN count as 0.
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

    /** Returns the code of a linear value by the formula, without a table. */
    int formula(float linear) {
        return CodeTable.formula(curve, linear);
    }

    /** Returns the 16-bit code, 0 to 65535, of a linear value; below 0 and NaN count as 0. */
    int encode16(float linear) {
        return linear > 0 ? (int) StrictMath.floor(WHITE_16 * Math.clamp(curve.applyAsDouble(linear), 0, 1) + 0.5) : 0;
    }
}

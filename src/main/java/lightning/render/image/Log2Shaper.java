package lightning.render.image;

import java.math.BigDecimal;
import java.util.Arrays;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/**
 * Logarithmic encoding of linear light before a lookup table, as OpenColorIO's configurations use it: stops around middle gray, scaled to
 * 0…1.
 *
 * @param min stops below middle gray that become 0; values below are clamped
 * @param max stops above middle gray that become 1; values above are clamped
 */
public record Log2Shaper(double min, double max) {
    /** Linear reflectance of a gray card. */
    public static final double MIDDLE_GRAY = 0.18;
    /** Keyword of the shaper in options. */
    public static final String WORD = "log2";
    /** Largest absolute value of both ends, stops. */
    public static final double MAX_STOPS = 64;
    /** Shaper of the ACES configurations for displays of 48 nits: 6.5 stops on each side (log2 48 nits shaper). */
    public static final Log2Shaper DEFAULT = new Log2Shaper(-6.5, 6.5);

    /** @throws RefusalException if the stops do not rise, or are outside −64…64 */
    public Log2Shaper {
        if (!(min < max && min >= -MAX_STOPS && max <= MAX_STOPS)) {
            throw new RefusalException(
                    "log2: expected two rising numbers of stops from -64 to 64, found " + text(min) + "," + text(max));
        }
    }

    /** Returns the linear value that becomes 1. */
    public double white() {
        return MIDDLE_GRAY * StrictMath.pow(2, max);
    }

    /** Returns the encoded value, 0 to 1; NaN and values up to 0 give 0. */
    public double encode(double linear) {
        return Math.clamp((stops(linear) - min) / (max - min), 0, 1);
    }

    /** Returns the linear value that becomes {@code encoded}, 0 to 1. */
    double decode(double encoded) {
        return MIDDLE_GRAY * StrictMath.pow(2, min + encoded * (max - min));
    }

    /** Returns the stops of a linear value above middle gray; NaN and values up to 0 give −∞. */
    static double stops(double linear) {
        // NaN is not above 0.
        return linear > 0 ? StrictMath.log(linear / MIDDLE_GRAY) / StrictMath.log(2) : Double.NEGATIVE_INFINITY;
    }

    /**
     * Returns the shaper of a text such as {@code log2:-6.5,6.5}.
     *
     * @throws RefusalException if the text is no shaper; the message is a sentence
     */
    public static Log2Shaper parse(String text) {
        double[] stops = !text.startsWith(WORD + ":") ? new double[0] : Arrays.stream(text.substring(WORD.length() + 1).split(",", -1))
                .mapToDouble(v -> DecimalNumber.parse(v).orElse(Double.NaN)).toArray();
        if (stops.length != 2) {
            throw new RefusalException("expected two numbers of stops such as log2:-6.5,6.5, found " + Quote.of(text));
        }
        return new Log2Shaper(stops[0], stops[1]);
    }

    /** Returns the shaper in the syntax of options: {@code log2:-6.5,6.5}. */
    public String text() {
        return WORD + ":" + text(min) + "," + text(max);
    }

    private static String text(double v) {
        return Double.isFinite(v) ? BigDecimal.valueOf(v).stripTrailingZeros().toPlainString() : Double.toString(v);
    }
}

package lightning.layer;

import java.math.BigDecimal;
import java.util.List;
import lightning.format.exr.ExrAttribute;

/**
 * Time of an image in its shot.
 *
 * @param frame number of the frame
 * @param rate frames per second
 */
public record FrameTime(int frame, double rate) {
    /** Denominator of the rates of television: 23.976 means 24000/1001. */
    private static final int NTSC = 1001;
    private static final List<Long> NTSC_RATES = List.of(24L, 30L, 48L, 60L, 120L);
    /** Half a unit of the last place of rates written with two decimals, such as 29.97. */
    private static final double ROUNDING = 0.005;

    /** Returns the rate as a fraction: of television's rates, rounded to two or more decimals, the exact one. */
    ExrAttribute.Rational fraction() {
        long multiple = Math.round(rate * NTSC / 1000);
        if (rate != Math.rint(rate) && Math.abs(multiple * 1000.0 / NTSC - rate) < ROUNDING && NTSC_RATES.contains(multiple)) {
            return new ExrAttribute.Rational((int) multiple * 1000, NTSC);
        }
        BigDecimal decimal = BigDecimal.valueOf(rate).stripTrailingZeros();
        long denominator = 1;
        while (decimal.scale() > 0 && denominator < 100_000) {
            decimal = decimal.movePointRight(1);
            denominator *= 10;
        }
        long numerator = Math.round(decimal.doubleValue());
        long divisor = gcd(numerator, denominator);
        return new ExrAttribute.Rational((int) (numerator / divisor), (int) (denominator / divisor));
    }

    private static long gcd(long a, long b) {
        return b == 0 ? a : gcd(b, a % b);
    }
}

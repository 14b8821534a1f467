package lightning.editor.document;

import java.math.BigDecimal;

/**
 * How far a number goes at a click, and where it stops.
 *
 * @param step what one click adds
 * @param min  the least value
 * @param max  the largest value
 */
public record StepRange(double step, double min, double max) {

    /**
     * The value so many steps on, added in decimal so that 1.1 and a step of 0.1 make 1.2; at the nearer limit where it
     * would be beyond.
     *
     * @param steps how many, down where negative; may be a fraction
     */
    public double addSteps(double value, double steps) {
        BigDecimal change = BigDecimal.valueOf(step).multiply(BigDecimal.valueOf(steps));
        return Math.clamp(BigDecimal.valueOf(value).add(change).doubleValue(), min, max);
    }
}

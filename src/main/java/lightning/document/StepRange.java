package lightning.document;

import java.math.BigDecimal;
import lightning.scene.attribute.NumericKind;

/**
 * Step and limits of a number.
 *
 * @param step increment of one click
 * @param min  minimum
 * @param max  maximum
 */
public record StepRange(double step, double min, double max) {
    /** Returns the step and the limits of each number of a kind. */
    public static StepRange of(NumericKind<?> kind) {
        return new StepRange(kind.step(), kind.min(), kind.max());
    }

    /**
     * Adds steps in decimal arithmetic, so that 1.1 and a step of 0.1 make 1.2, clamped to the limits.
     *
     * @param steps number of steps, negative for down; may be a fraction
     */
    public double addSteps(double value, double steps) {
        BigDecimal change = BigDecimal.valueOf(step).multiply(BigDecimal.valueOf(steps));
        return Math.clamp(BigDecimal.valueOf(value).add(change).doubleValue(), min, max);
    }
}

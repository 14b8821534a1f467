package lightning.render.relight;

import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;

/**
 * Result of a renderer's update.
 *
 * @param rowsTouched  rows of light layers tested or written, counted once per light, and rows whose texture was looked up again
 * @param rowsComposed rows of all levels for which the equation was evaluated
 * @param bytesMoved   bytes of columns and film read or written, counted once per use: memory traffic without caches; 0 for a first
 *                     pass
 * @param rays         rays cast
 * @param nanoseconds  time from the call to the finished film
 * @param errorBound   largest difference of any value of the film from a full trace, linear; 0 at accuracy exact
 * @param wasRefreshed true if contributions were recomputed because the bound had grown too large
 */
public record UpdateResult(UpdatePlan plan, long rowsTouched, long rowsComposed, long bytesMoved, RayCounts rays, long nanoseconds,
        double errorBound, boolean wasRefreshed) {
    public double milliseconds() {
        return nanoseconds / 1e6;
    }
}

package lightning.render.relight;

import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;

/**
 * What a renderer did.
 *
 * @param rowsTouched  rows of light layers that were looked at or written, a row once for each light, and rows whose texture
 *                     was looked up anew
 * @param rowsComposed rows, of all levels, for which the equation was closed
 * @param bytesMoved   bytes of columns and film that were read or written, each counted once for each use: what
 *                     memory must move if no cache helps; 0 for a first pass
 * @param rays         rays cast
 * @param nanoseconds  from the call to the finished film
 * @param errorBound   how far any value of the film may be from a full trace's, linear; 0 at accuracy exact
 * @param wasRefreshed    whether contributions were computed anew because the bound had grown too large
 */
public record UpdateResult(UpdatePlan plan, long rowsTouched, long rowsComposed, long bytesMoved, RayCounts rays, long nanoseconds,
        double errorBound, boolean wasRefreshed) {
    public double milliseconds() {
        return nanoseconds / 1e6;
    }
}

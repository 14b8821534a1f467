package lightning.bench;

import lightning.bench.accuracy.UpdateSaving;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;

/**
 * What a re-render did.
 *
 * @param plan              in the paper's words
 * @param rowsTouched       rows of light layers, a row once for each light
 * @param shadowRays        rays to lights that it cast
 * @param shadowRaysAvoided how many fewer that is than the full trace casts
 * @param rays              all rays that it cast
 * @param bytesMoved        bytes that memory must move if no cache helps
 * @param floorMs           milliseconds that memory needs to move them
 * @param timesFloor        the measured time in units of that floor; NaN where there is none
 * @param cap               percent that it could save at most if it cast its rays as fast as the full trace casts its own and
 *                          moved its bytes at the speed of memory
 * @param errorBound        how far any value of the film may be off by the engine's own account, linear
 */
public record UpdateWork(String plan, long rowsTouched, long shadowRays, long shadowRaysAvoided, long rays, long bytesMoved, double floorMs,
        double timesFloor, double cap, double errorBound) {

    /**
     * @param ms         the re-render's time, median
     * @param fullMs     the full trace's
     * @param fullRays       the full trace's rays
     * @param bytesPerMs the bandwidth of memory
     */
    static UpdateWork of(UpdateResult update, double ms, double fullMs, RayCounts fullRays, double bytesPerMs) {
        double floor = update.bytesMoved() / bytesPerMs;
        return new UpdateWork(update.plan().description(), update.rowsTouched(), update.rays().shadow(),
                fullRays.shadow() - update.rays().shadow(),
                update.rays().total(), update.bytesMoved(), floor, floor > 0 ? ms / floor : Double.NaN,
                UpdateSaving.maxPercent(update, fullMs, fullRays, bytesPerMs), update.errorBound());
    }
}

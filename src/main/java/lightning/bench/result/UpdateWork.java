package lightning.bench.result;

import lightning.bench.accuracy.UpdateSaving;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;

/**
 * Work of an update.
 *
 * @param plan              plan in the paper's terms
 * @param rowsTouched       touched rows of light layers, counted per light
 * @param shadowRays        cast shadow rays
 * @param shadowRaysAvoided saved shadow rays relative to the full trace
 * @param rays              cast rays of all kinds
 * @param bytesMoved        bytes of memory traffic without caches
 * @param floorMs           minimum time of this traffic, milliseconds
 * @param timesFloor        measured time relative to that floor; NaN if there is none
 * @param cap               maximum saving in percent at the full trace's ray rate and at memory speed
 * @param errorBound        the engine's error bound of any value, linear
 */
public record UpdateWork(String plan, long rowsTouched, long shadowRays, long shadowRaysAvoided, long rays, long bytesMoved, double floorMs,
        double timesFloor, double cap, double errorBound) {

    /**
     * @param ms         median time of the update, milliseconds
     * @param fullMs     median time of the full trace, milliseconds
     * @param fullRays   rays of the full trace
     * @param bytesPerMs memory bandwidth
     */
    public static UpdateWork of(UpdateResult update, double ms, double fullMs, RayCounts fullRays, double bytesPerMs) {
        double floor = update.bytesMoved() / bytesPerMs;
        return new UpdateWork(update.plan().description(), update.rowsTouched(), update.rays().shadow(),
                fullRays.shadow() - update.rays().shadow(),
                update.rays().total(), update.bytesMoved(), floor, floor > 0 ? ms / floor : Double.NaN,
                UpdateSaving.maxPercent(update, fullMs, fullRays, bytesPerMs), update.errorBound());
    }
}

package lightning.bench;

import lightning.bench.accuracy.Saving;
import lightning.render.relight.Update;
import lightning.render.shading.TraceCounts;

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
public record Work(String plan, long rowsTouched, long shadowRays, long shadowRaysAvoided, long rays, long bytesMoved, double floorMs,
        double timesFloor, double cap, double errorBound) {

    /**
     * @param ms         the re-render's time, median
     * @param fullMs     the full trace's
     * @param full       the full trace's rays
     * @param bytesPerMs the bandwidth of memory
     */
    static Work of(Update update, double ms, double fullMs, TraceCounts full, double bytesPerMs) {
        double floor = update.bytesMoved() / bytesPerMs;
        return new Work(update.plan().text(), update.rowsTouched(), update.rays().shadow(), full.shadow() - update.rays().shadow(),
                update.rays().all(), update.bytesMoved(), floor, floor > 0 ? ms / floor : Double.NaN,
                Saving.cap(update, fullMs, full, bytesPerMs), update.errorBound());
    }
}

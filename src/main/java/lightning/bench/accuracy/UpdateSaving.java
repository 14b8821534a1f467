package lightning.bench.accuracy;

import lightning.render.measure.Timing;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;

/**
 * Saving of an update relative to full traces of the same image.
 *
 * @param update     first run of the update
 * @param time       milliseconds of the update
 * @param full       milliseconds of a full trace without a cache
 * @param fullRays   rays of that trace
 * @param bytesPerMs memory bandwidth, bytes read and written per millisecond
 * @param isVerified whether the image satisfies its guarantee: bit-identical, or within the bound
 * @param isWarm     whether the JIT compilers were idle; otherwise its times are unreliable
 */
public record UpdateSaving(UpdateResult update, Timing time, Timing full, RayCounts fullRays, double bytesPerMs, boolean isVerified,
        boolean isWarm) {
    /** Returns the saving in percent of the full trace's time; negative if the update is slower. */
    public double percent() {
        return time.percentSavedOf(full.median());
    }

    /** Returns the maximum saving in percent at the full trace's ray rate and at memory speed. */
    public double maxPercent() {
        return maxPercent(update, full.median(), fullRays, bytesPerMs);
    }

    /** Returns the maximum saving of an update relative to a full trace of {@code fullMs} milliseconds. */
    public static double maxPercent(UpdateResult update, double fullMs, RayCounts fullRays, double bytesPerMs) {
        double rays = fullMs * update.rays().total() / fullRays.total();
        return 100 * (1 - Math.max(rays, update.bytesMoved() / bytesPerMs) / fullMs);
    }
}

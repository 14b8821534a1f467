package lightning.bench.accuracy;

import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;

/**
 * What an update saved, measured beside full traces of the same picture.
 *
 * @param update     what the update did, the first time
 * @param time       milliseconds of the update
 * @param full       milliseconds of a full trace that keeps nothing
 * @param fullRays   the rays of that trace
 * @param bytesPerMs bytes in a millisecond that memory can read and write
 * @param isVerified       whether the picture is what the accuracy grade promises: equal in every bit, or within the bound
 * @param isWarm       whether Java's compilers rested while it was timed: else its times say little
 */
public record UpdateSaving(UpdateResult update, Timing time, Timing full, RayCounts fullRays, double bytesPerMs, boolean isVerified,
        boolean isWarm) {
    /** Percent of the full trace's time; negative where the update took longer. */
    public double percent() {
        return time.percentSavedOf(full.median());
    }

    /**
     * Percent that an update could save at most if it cast its rays as fast as the full trace casts its own and moved its
     * bytes at the speed of memory.
     */
    public double maxPercent() {
        return maxPercent(update, full.median(), fullRays, bytesPerMs);
    }

    /** The same of an update beside a full trace of {@code fullMs} milliseconds. */
    public static double maxPercent(UpdateResult update, double fullMs, RayCounts fullRays, double bytesPerMs) {
        double rays = fullMs * update.rays().total() / fullRays.total();
        return 100 * (1 - Math.max(rays, update.bytesMoved() / bytesPerMs) / fullMs);
    }
}

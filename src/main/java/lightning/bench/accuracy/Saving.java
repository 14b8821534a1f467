package lightning.bench.accuracy;

import lightning.render.relight.Update;
import lightning.render.shading.TraceCounts;

/**
 * What an update saved, measured beside full traces of the same picture.
 *
 * @param update     what the update did, the first time
 * @param time       milliseconds of the update
 * @param full       milliseconds of a full trace that keeps nothing
 * @param fullRays   the rays of that trace
 * @param bytesPerMs bytes in a millisecond that memory can read and write
 * @param kept       whether the picture is what the accuracy grade promises: equal in every bit, or within the bound
 * @param warm       whether Java's compilers rested while it was timed: else its times say little
 */
public record Saving(Update update, Timing time, Timing full, TraceCounts fullRays, double bytesPerMs, boolean kept, boolean warm) {
    /** Percent of the full trace's time; negative where the update took longer. */
    public double percent() {
        return time.savingOf(full.median());
    }

    /**
     * Percent that an update could save at most if it cast its rays as fast as the full trace casts its own and moved its
     * bytes at the speed of memory.
     */
    public double cap() {
        return cap(update, full.median(), fullRays, bytesPerMs);
    }

    /** The same of an update beside a full trace of {@code fullMs} milliseconds. */
    public static double cap(Update update, double fullMs, TraceCounts fullRays, double bytesPerMs) {
        double rays = fullMs * update.rays().all() / fullRays.all();
        return 100 * (1 - Math.max(rays, update.bytesMoved() / bytesPerMs) / fullMs);
    }
}

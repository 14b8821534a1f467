package lightning.accuracy;

import lightning.relight.Update;
import lightning.shading.TraceCounts;

/**
 * What an update saved, measured beside full traces of the same picture.
 *
 * @param update     what the update did, the first time
 * @param updateMs   milliseconds of the update, median
 * @param fullMs     milliseconds of a full trace that keeps nothing, median
 * @param fullRays   the rays of that trace
 * @param cap        percent that an update could save at most if it cast its rays as fast as the full trace casts its own
 *                   and moved its bytes at the speed of memory
 * @param kept       whether the picture is what the accuracy level promises: equal in every bit, or within the bound
 */
public record Saving(Update update, double updateMs, double fullMs, TraceCounts fullRays, double cap, boolean kept) {
    /** Percent of the full trace's time; negative where the update took longer. */
    public double percent() {
        return 100 * (1 - updateMs / fullMs);
    }
}

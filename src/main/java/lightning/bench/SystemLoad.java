package lightning.bench;

import java.lang.management.ManagementFactory;

/**
 * Other work on the machine while it measured.
 *
 * @param atStart load average of the minute before the run; NaN where the system does not report it
 * @param atEnd   load average of its last minute, this program included; NaN likewise
 * @param others  share of the processors' time, 0…1, that other programs or other machines of the same host had during the run; NaN
 *                where the system does not report it
 */
public record SystemLoad(double atStart, double atEnd, double others) {
    /** Above this share of others' time the machine was busy. */
    public static final double BUSY_SHARE = 0.1;
    /** Above this load for each processor before the run it was, where the share is unknown. */
    private static final double BUSY_LOAD = 0.5;

    /** Whether times say little because other work had the processors. */
    public boolean isBusy(int processors) {
        return Double.isNaN(others) ? atStart > BUSY_LOAD * processors : others > BUSY_SHARE;
    }

    /** The load average of the last minute; NaN where the system does not report it. */
    static double average() {
        double loadAverage = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        return loadAverage < 0 ? Double.NaN : loadAverage;
    }
}

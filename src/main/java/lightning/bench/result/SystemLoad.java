package lightning.bench.result;

import java.lang.management.ManagementFactory;

/**
 * Other work on the machine during a run.
 *
 * @param atStart load average of the minute before the run; NaN if the system does not report it
 * @param atEnd   load average of its last minute, this program included; NaN if not reported
 * @param others  share of processor time, 0…1, of other programs or other machines on the same host; NaN if not reported
 */
public record SystemLoad(double atStart, double atEnd, double others) {
    /** Share of other work above which the machine is busy. */
    public static final double BUSY_SHARE = 0.1;
    /** Load average per processor before the run above which the machine is busy, if the share is unknown. */
    private static final double BUSY_LOAD = 0.5;

    /** Returns whether other work makes the times unreliable. */
    public boolean isBusy(int processors) {
        return Double.isNaN(others) ? atStart > BUSY_LOAD * processors : others > BUSY_SHARE;
    }

    /** Returns the load average of the last minute; NaN if the system does not report it. */
    public static double average() {
        double loadAverage = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        return loadAverage < 0 ? Double.NaN : loadAverage;
    }
}

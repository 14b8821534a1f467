package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Cost of each effect.
 *
 * @param updatePlan plan of the measured update
 * @param columns    cached bytes by kind of column
 */
public record EffectsReport(double firstPassMilliseconds, double updateMilliseconds, String updatePlan, long cacheBytes, long rows,
        List<Effect> effects, List<Column> columns) {
    /**
     * One effect. If it is used, its added cost, else what its absence saves.
     *
     * @param usedBy   lights, materials, objects and settings
     * @param measured false if it cannot be forced on, or does not fit in memory; numbers are then absent
     */
    public record Effect(String effect, boolean used, List<String> usedBy, boolean measured, @Nullable Double firstPassMilliseconds,
            @Nullable Double firstPassNoiseMilliseconds, @Nullable Double updateMilliseconds, @Nullable Long bytes, @Nullable Long rays) {}

    /** Bytes of a kind of column. */
    public record Column(String column, long bytes) {}
}

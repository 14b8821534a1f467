package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Edited frames of a shot.
 *
 * @param frames                number of frames
 * @param nodes                 number of nodes at the end; absent without a cluster
 * @param frameMilliseconds     warm time of a frame of the last group; absent if not measured, as the next two
 * @param fullTraceMilliseconds warm time of its full trace
 * @param savedPercent          share of the full trace's time
 */
public record ShotRelightReport(int frames, @Nullable Integer nodes, double tracedMilliseconds, List<Group> groups,
        @Nullable Double frameMilliseconds, @Nullable Double fullTraceMilliseconds, @Nullable Double savedPercent) {
    /**
     * A group of edits.
     *
     * @param group             number from 1
     * @param folder            folder of its images
     * @param milliseconds      sum over all frames, without images; on a cluster, time until all frames were updated
     * @param totalMilliseconds time of the group, with images
     * @param retraced          frames traced again because they did not fit
     * @param rays              rays of all frames; absent on a cluster
     */
    public record Group(int group, String folder, double milliseconds, double totalMilliseconds, int retraced, @Nullable Long rays) {}
}

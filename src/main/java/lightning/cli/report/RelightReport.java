package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Edits of an image.
 *
 * @param image final image, or the pattern of the images' names
 * @param saved edited scene; absent without {@code --save}
 */
public record RelightReport(String image, double firstPassMilliseconds, RaysReport firstPassRays, List<Step> steps,
        @Nullable String saved) {
    /**
     * One update.
     *
     * @param step                  number of the group of edits, from 1
     * @param image                 image of this step; absent if none is written
     * @param reflectionsOnly       true for the update of reflections that follows the last group with {@code --update-reflections}
     * @param rows                  rows of light layers that were updated
     * @param milliseconds          warm median if savings were measured, else the update's own time
     * @param fullTraceMilliseconds median of full traces of the same image; absent if not measured
     * @param savedPercent          share of the full trace's time; absent if not measured
     * @param errorBoundLinear      largest difference from a full trace; 0 if exact
     * @param verified              result of {@code --verify}; absent without it
     */
    public record Step(int step, @Nullable String image, boolean reflectionsOnly, String plan, long rows, RaysReport rays,
            double milliseconds,
            @Nullable Double fullTraceMilliseconds, @Nullable Double savedPercent, double errorBoundLinear, @Nullable Verified verified) {}

    /**
     * Comparison with a full trace.
     *
     * @param passed true if the promise was kept
     */
    public record Verified(boolean passed, long differentPixels, long differentValues, double maxDifferenceLinear) {}
}

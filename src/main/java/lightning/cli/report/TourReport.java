package lightning.cli.report;

import java.util.List;

/**
 * Every kind of edit on a scene.
 *
 * @param images folder
 * @param warm   false if Java was still compiling: the times are then not reliable
 */
public record TourReport(String scene, String images, int widthPixels, int heightPixels, int threads, double firstPassMilliseconds,
        double fullTraceMilliseconds, double cachingCostsPercent, boolean warm, List<Edit> edits) {
    /**
     * One edit.
     *
     * @param rows              rows of light layers that were updated
     * @param savedPercent      share of the full trace's time
     * @param paperSavedPercent as reported in the paper; null if not reported
     * @param capPercent        largest possible saving
     * @param equal             true if the image equals a full trace in every bit
     */
    public record Edit(String edit, String plan, long rows, RaysReport rays, double milliseconds, double fullTraceMilliseconds,
            double savedPercent, double paperSavedPercent, double capPercent, boolean equal, boolean warm) {}
}

package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * OpenColorIO configuration, or a LUT that was baked from it.
 *
 * @param config   file or name
 * @param displays displays with their views, the default display first; empty for a LUT
 * @param lut      written LUT; absent for a list
 */
public record OcioReport(String config, List<Display> displays, @Nullable Lut lut) {
    /**
     * Display with its views.
     *
     * @param defaultView name of one of the views
     */
    public record Display(String name, List<String> views, String defaultView) {}

    /**
     * Written LUT. Its error is the largest of the three channels, in steps of 8 bits.
     *
     * @param lowStops   stops around middle gray, below which light is shown as black
     * @param highStops  stops around middle gray, above which colors do not change
     * @param maxErrorLevels  largest error of the compared colors
     * @param error99Levels   error that 99 % of them do not exceed
     * @param meanErrorLevels mean error
     * @param colors     number of compared random colors
     */
    public record Lut(String file, String display, String view, double lowStops, double highStops, double maxErrorLevels,
            double error99Levels, double meanErrorLevels, int colors) {}
}

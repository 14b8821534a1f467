package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Lights that were matched to a reference.
 *
 * @param output         the written scene; absent if none was
 * @param errorBefore    root mean square of the difference relative to the reference, with {@code errorAfter}
 * @param referenceScale factors by which red, green and blue of the reference were scaled
 * @param moved          other attributes that changed
 * @param alike          pairs of lights of which only the sum is known
 * @param unseen         lights that contribute nothing to the picture
 */
public record MatchReport(@Nullable String output, double errorBefore, double errorAfter, List<Double> referenceScale, List<Matched> lights,
        List<Moved> moved, List<List<String>> alike, List<String> unseen) {
    /**
     * One light, or the environment.
     *
     * @param factors of red, green and blue
     */
    public record Matched(String light, List<Double> factors, double intensityBefore, double intensityAfter) {}

    /**
     * Change of another attribute of a light or the environment, as in scene files.
     *
     * @param attribute its keyword
     */
    public record Moved(String light, String attribute, String before, String after) {}
}

package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Differences that lights make in the frames of a shot or a sequence.
 *
 * @param lights             all lights; the least difference comes first
 * @param needless           names of the lights that can be left out
 * @param togetherSteps      largest difference without all of these, steps of 8 bits; absent if there are none
 * @param togetherDifference the same as a linear value
 * @param output             written scene; absent for none
 */
public record ShotLightsReport(List<LightDifference> lights, List<String> needless, @Nullable Integer togetherSteps,
        @Nullable Double togetherDifference, @Nullable String output) {
    /**
     * Difference that a light makes.
     *
     * @param maxDifferenceLinear largest difference of a channel in any pixel of any frame, linear
     * @param maxSteps            largest difference of the displayed picture, steps of 8 bits
     * @param shot                shot of a sequence with the largest difference; absent for a scene, or without a difference
     * @param frame               its frame; absent without a difference
     */
    public record LightDifference(String light, double maxDifferenceLinear, int maxSteps, @Nullable String shot, @Nullable Integer frame) {}
}

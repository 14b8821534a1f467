package lightning.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Optional;
import lightning.base.text.Quote;

/**
 * Lights that are too bright together for a metallic material: its sharp highlights are brighter than the light is, so that sums of
 * contributions could overflow a float. The weights of all lights times the greatest term of any material add up to at most
 * {@link SceneLimits#MAX_TOTAL_LIGHT}, which lights without such a material never exceed. Lights count whether they are on or not, and as they are
 * or as their banks make them, whichever is brighter: so neither a switch nor a bank that goes makes a scene too bright.
 *
 * @param light    the brightest of them
 * @param material the one whose highlights are the sharpest
 * @param limit     what the greatest channels of the lights' colors times intensities may add up to
 * @param sum      what they add up to
 */
public record OverflowCheck(Light light, Material material, double limit, double sum) {

    /** What is too bright on a stage; empty where nothing is. Lamps of an environment never are. */
    public static Optional<OverflowCheck> of(Stage stage, LightRig rig) {
        if (stage.sharpestMaterial().isEmpty()) {
            return Optional.empty();
        }
        Material material = stage.sharpestMaterial().get();
        double limit = SceneLimits.MAX_TOTAL_LIGHT / material.maxTerm();
        double sum = 0;
        double brightest = 0;
        Light light = null;
        for (Light candidate : rig.lights()) {
            double weight = Math.max(candidate.weight().max(), rig.effectiveLight(candidate).weight().max());
            sum += weight;
            light = weight > brightest ? candidate : light;
            brightest = Math.max(brightest, weight);
        }
        return sum > limit ? Optional.of(new OverflowCheck(light, material, limit, sum)) : Optional.empty();
    }

    /** @throws IllegalArgumentException if anything is too bright; the message says what */
    static void check(Stage stage, LightRig rig) {
        of(stage, rig).ifPresent(overflow -> {
            throw new IllegalArgumentException(overflow.message());
        });
    }

    /** What may be, and what was found: a clause. */
    public String message() {
        return "light " + Quote.of(light.name()) + ": color times intensity of all lights must add up to at most "
                + SceneLimits.format(rounded(limit, RoundingMode.DOWN))
                + " for metallic material " + Quote.of(material.name()) + ", whose highlights are this sharp, was "
                + SceneLimits.format(rounded(sum, RoundingMode.HALF_EVEN));
    }

    /** To three digits. */
    private static double rounded(double v, RoundingMode mode) {
        return BigDecimal.valueOf(v).round(new MathContext(3, mode)).doubleValue();
    }
}

package lightning.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.asset.Environment;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.value.SceneLimits;

/**
 * Check that the sum of contributions cannot overflow a float. Sharp highlights of a metallic material are brighter than the light itself.
 * The weights of all lights times the largest term of any material may sum to at most {@link SceneLimits#MAX_TOTAL_LIGHT}, which scenes
 * without such a material never exceed. Includes lights that are off, and counts each light with or without its group and gains,
 * whichever is brightest, so that neither a switch nor a hidden effect can exceed the limit. Gains count as intensity. Without soft shadows
 * a light is never brighter.
 *
 * @param light    the brightest light
 * @param material the material with the sharpest highlights
 * @param limit    maximum sum of the largest channels of color times intensity
 * @param sum      actual sum
 */
public record OverflowCheck(Light light, Material material, double limit, double sum) {

    /** Returns the violation of a stage and its lights, if any. Environment lights never cause one. */
    public static Optional<OverflowCheck> of(Stage stage, LightRig rig) {
        return ofPlaced(stage, rig.withSurfaces(stage.surfaces(rig)));
    }

    /** @param rig lights with the surfaces of the stage */
    private static Optional<OverflowCheck> ofPlaced(Stage stage, LightRig rig) {
        if (stage.sharpestMaterial().isEmpty()) {
            return Optional.empty();
        }
        Material material = stage.sharpestMaterial().get();
        double limit = SceneLimits.MAX_TOTAL_LIGHT / material.maxTerm();
        double sum = 0;
        double brightest = 0;
        Light light = null;
        for (Light candidate : rig.lights()) {
            double weight = maxWeight(candidate, rig);
            sum += weight;
            light = weight > brightest ? candidate : light;
            brightest = Math.max(brightest, weight);
        }
        return light != null && sum > limit ? Optional.of(new OverflowCheck(light, material, limit, sum)) : Optional.empty();
    }

    /** Returns a light's largest weight times falloff, with or without each effect whose absence can make it brighter. */
    private static double maxWeight(Light light, LightRig rig) {
        return Stream.of(light, light.withLightGroup(""))
                .flatMap(l -> Stream.of(l, l.withInfluence(Influence.DEFAULT)))
                .mapToDouble(l -> rig.effectiveLight(l).maxWeight() * rig.withSurface(l).maxFactor()).max().orElse(0);
    }

    /**
     * @param rig lights with the surfaces of the stage
     * @throws RefusalException if the lights are too bright; the message says which
     */
    static void check(Stage stage, LightRig rig) {
        ofPlaced(stage, rig).ifPresent(overflow -> {
            throw new RefusalException(overflow.message());
        });
    }

    /** Returns a clause with the limit and the actual sum. */
    public String message() {
        return "light " + Quote.of(light.name()) + ": color times intensity of all lights must add up to at most "
                + SceneLimits.format(rounded(limit, RoundingMode.DOWN))
                + " for metallic material " + Quote.of(material.name()) + ", whose highlights are this sharp, was "
                + SceneLimits.format(rounded(sum, RoundingMode.HALF_EVEN));
    }

    /** Rounds to three digits. */
    private static double rounded(double v, RoundingMode mode) {
        return BigDecimal.valueOf(v).round(new MathContext(3, mode)).doubleValue();
    }
}

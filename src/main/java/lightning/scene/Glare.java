package lightning.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Optional;
import lightning.base.text.Quote;

/**
 * Lights that are too bright together for a metallic material: its sharp highlights are brighter than the light is, so that sums of
 * contributions could overflow a float. The weights of all lights times the greatest term of any material add up to at most
 * {@link Limits#MAX_LIGHT}, which lights without such a material never exceed. Lights count whether they are on or not, and as they are
 * or as their banks make them, whichever is brighter: so neither a switch nor a bank that goes makes a scene too bright.
 *
 * @param light    the brightest of them
 * @param material the one whose highlights are the sharpest
 * @param most     what the greatest channels of the lights' colours times intensities may add up to
 * @param sum      what they add up to
 */
public record Glare(Light light, Material material, double most, double sum) {

    /** What is too bright on a stage; empty where nothing is. Lamps of an environment never are. */
    public static Optional<Glare> of(Stage stage, Rig rig) {
        if (stage.glossiest().isEmpty()) {
            return Optional.empty();
        }
        Material material = stage.glossiest().get();
        double most = Limits.MAX_LIGHT / material.mostTerm();
        double sum = 0;
        double brightest = 0;
        Light light = null;
        for (Light own : rig.lights()) {
            double weight = Math.max(own.weight().max(), rig.acting(own).weight().max());
            sum += weight;
            light = weight > brightest ? own : light;
            brightest = Math.max(brightest, weight);
        }
        return sum > most ? Optional.of(new Glare(light, material, most, sum)) : Optional.empty();
    }

    /** @throws IllegalArgumentException if anything is too bright; the message says what */
    static void check(Stage stage, Rig rig) {
        of(stage, rig).ifPresent(glare -> {
            throw new IllegalArgumentException(glare.message());
        });
    }

    /** What may be, and what was found: a clause. */
    public String message() {
        return "light " + Quote.of(light.name()) + ": colour times intensity of all lights must add up to at most "
                + Limits.text(rounded(most, RoundingMode.DOWN))
                + " before metallic material " + Quote.of(material.name()) + ", which has highlights so sharp, was "
                + Limits.text(rounded(sum, RoundingMode.HALF_EVEN));
    }

    /** To three digits. */
    private static double rounded(double v, RoundingMode mode) {
        return BigDecimal.valueOf(v).round(new MathContext(3, mode)).doubleValue();
    }
}

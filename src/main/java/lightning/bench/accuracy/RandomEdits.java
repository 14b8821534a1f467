package lightning.bench.accuracy;

import java.util.Random;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.Attenuation;

/** Random slider edits of one light after another, within realistic ranges. */
public final class RandomEdits {
    private final Random random;

    /** Creates a sequence of edits that is deterministic in the seed. */
    public RandomEdits(long seed) {
        random = new Random(seed);
    }

    /** Returns the scene after the next edit; the scene must have a light. */
    public Scene next(Scene scene) {
        Light light = scene.lights().get(random.nextInt(scene.lights().size()));
        return scene.withLight(switch (random.nextInt(8)) {
            case 0, 1 -> light.withIntensity(logUniform(0.01, 10));
            case 2 -> light.withColor(new Rgb(logUniform(0.05, 1), logUniform(0.05, 1), logUniform(0.05, 1)));
            case 3, 4 -> light.withAttenuation(new Attenuation(logUniform(0.1, 1), logUniform(0.01, 1), logUniform(0.01, 0.2)));
            case 5 -> light.withDropoff(logUniform(0.1, 20));
            case 6 -> light.withAngle(logUniform(5, 60));
            default -> light.withOn(!light.on());
        });
    }

    /** Returns a value that is uniform in the logarithm. */
    private double logUniform(double min, double max) {
        return min * Math.pow(max / min, random.nextDouble());
    }
}

package lightning.relight;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** What an artist does with sliders: edits of one light of a studio with four, in the ranges that lamps have. */
final class OrdinaryEdits {
    private final Random random;

    OrdinaryEdits(long seed) {
        random = new Random(seed);
    }

    /** The studio with a spot, two point lights and a directional one, at a size. */
    static Scene studio(int width, int height) {
        Scene scene = StudioScene.of(LightType.SPOT);
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(StudioScene.key(LightType.POINT).withName("fill").withPosition(new Vec3(-3, 3, 3)));
        lights.add(StudioScene.key(LightType.POINT).withName("back").withPosition(new Vec3(0, 2, -4)).withIntensity(0.3));
        lights.add(StudioScene.key(LightType.DIRECTIONAL).withName("sun").withColor(new Rgb(1, 0.9, 0.7)));
        return scene.withLights(lights).withPicture(scene.picture().withSize(width, height));
    }

    /** The next scene. */
    Scene next(Scene scene) {
        Light light = scene.lights().get(random.nextInt(scene.lights().size()));
        return scene.withLight(switch (random.nextInt(8)) {
            case 0, 1 -> light.withIntensity(slider(0.01, 10));
            case 2 -> light.withColor(new Rgb(slider(0.05, 1), slider(0.05, 1), slider(0.05, 1)));
            case 3, 4 -> light.withAttenuation(new Attenuation(slider(0.1, 1), slider(0.01, 1), slider(0.01, 0.2)));
            case 5 -> light.withDropoff(slider(0.1, 20));
            case 6 -> light.withAngle(slider(5, 60));
            default -> light.withOn(!light.on());
        });
    }

    /** A value of a slider, which is even in the logarithm. */
    private double slider(double least, double most) {
        return least * Math.pow(most / least, random.nextDouble());
    }
}

package lightning;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.math.Rgb;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** Edits of every kind that the dispatcher knows, drawn from a seed. */
public final class RandomEdits {
    private final RandomScenes values;
    private final Random random;
    private int added;

    public RandomEdits(long seed) {
        values = new RandomScenes(seed);
        random = values.random();
    }

    /** One edit of a scene. */
    public Scene edit(Scene scene) {
        int lights = scene.lights().size();
        int kind = random.nextInt(20);
        if (kind == 0) {
            return scene.withWorld(scene.world().withAmbience(random.nextInt(3) * random.nextDouble()));
        }
        if (kind == 1) {
            return scene.withPicture(scene.picture().withDepth(random.nextInt(5)));
        }
        if (kind == 2 || lights == 0) {
            List<Light> more = new ArrayList<>(scene.lights());
            more.add(random.nextInt(lights + 1), values.light("a" + added++ + "_" + random.nextInt(1000000)));
            return lights >= 7 ? scene : scene.withLights(more);
        }
        int index = random.nextInt(lights);
        Light light = scene.lights().get(index);
        if (kind == 3) {
            List<Light> fewer = new ArrayList<>(scene.lights());
            fewer.remove(index);
            return scene.withLights(fewer);
        }
        if (kind == 4) {
            List<Light> same = new ArrayList<>(scene.lights());
            same.set(index, light.withName("r" + added++ + "_" + random.nextInt(1000000)));
            return scene.withLights(same);
        }
        return scene.withLight(edit(light, kind));
    }

    private Light edit(Light light, int kind) {
        return switch (kind) {
            case 5 -> light.withType(LightType.values()[random.nextInt(3)]);
            case 6 -> light.withOn(!light.on());
            case 7 -> light.withSolo(!light.solo());
            case 8, 9 -> light.withColor(new Rgb(channel(), channel(), channel()));
            case 10, 11 -> light.withIntensity(channel() * 3);
            case 12, 13 -> light.withAttenuation(values.attenuation());
            case 14, 15 -> light.withAngle(random.nextInt(4) == 0 ? 180 * random.nextDouble() : light.angle() * (0.8 + 0.4 * random.nextDouble()) % 180);
            case 16 -> light.withDropoff(random.nextInt(3) == 0 ? 0 : 9 * random.nextDouble());
            case 17 -> light.withPosition(values.position());
            default -> light.withDirection(values.direction(light.position()));
        };
    }

    private double channel() {
        return random.nextInt(6) == 0 ? 0 : random.nextDouble();
    }
}

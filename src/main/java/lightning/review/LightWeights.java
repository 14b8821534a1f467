package lightning.review;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;

/** Weights of the layers of lights, and scenes that differ in nothing but them. */
public final class LightWeights {
    private LightWeights() {}

    /** Returns the factors of red, green and blue of a light's layer in the picture of a scene, {@code float[3]}. */
    public static float[] of(Scene scene, Scene base, Contribution part) {
        Light light = part.light(scene).orElse(null);
        if (light == null) {
            float share = part.isShining(scene) ? (float) (part.values(scene).intensity() / part.values(base).intensity()) : 0;
            return new float[] {share, share, share};
        }
        if (!scene.isActive(light)) {
            return new float[3];
        }
        Light from = part.light(base).orElseThrow();
        double share = light.intensity() / from.intensity() * groupIntensity(scene, light) / groupIntensity(base, light);
        Rgb color = light.color();
        return new float[] {(float) (share * color.r() / from.color().r()), (float) (share * color.g() / from.color().g()),
            (float) (share * color.b() / from.color().b())};
    }

    /** Returns the intensity of a light's group, 1 if it has none. */
    public static double groupIntensity(Scene scene, Light light) {
        return scene.rig().lightGroup(light.lightGroup()).map(LightGroup::intensity).orElse(1.0);
    }

    /** Returns a scene in which all lights shine in all channels. */
    public static Scene allOn(Scene scene) {
        return withLights(scene, intensity -> intensity > 0 ? intensity : 1, false);
    }

    /** Returns a scene without what a page can change. */
    public static Scene neutral(Scene scene) {
        Scene neutral = withLights(scene, _ -> 1, true);
        return neutral.withPicture(neutral.picture().withView(neutral.picture().view().withExposure(0)));
    }

    private static Scene withLights(Scene scene, DoubleUnaryOperator intensity, boolean isWhite) {
        List<Light> lights = scene.lights().stream().map(light -> {
            Rgb color = light.color();
            boolean hasAll = color.r() > 0 && color.g() > 0 && color.b() > 0;
            return light.withOn(true).withSolo(false).withIntensity(intensity.applyAsDouble(light.intensity()))
                    .withColor(hasAll && !isWhite ? color : Rgb.WHITE);
        }).toList();
        Scene changed = scene.withLights(lights);
        for (LightGroup group : scene.rig().lightGroups()) {
            changed = changed.withRig(changed.rig()
                    .with(group.withOn(true).withSolo(false).withIntensity(intensity.applyAsDouble(group.intensity()))));
        }
        World world = changed.world();
        return changed.withWorld(world.withDomes(world.domes().stream()
                .map(dome -> dome.withOn(true).withSolo(false).withIntensity(intensity.applyAsDouble(dome.intensity()))).toList()));
    }
}

package lightning.render.shading;

import java.util.Arrays;
import lightning.render.fog.FogMedium;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Light of a scene with its weights and source, as the equation needs it. Owns a layer. The layer contains neither weights nor gains, so it
 * stays valid if only these change.
 *
 * @param light    the scene's light, after its light group
 * @param diffuse  weight of its diffuse contributions; 0 if the light is off
 * @param specular weight of its specular contributions; 0 if the light is off
 * @param fog      weight of its light in fog; 0 if the light is off
 * @param gains    its gains on single shapes; null if it has none
 * @param source   the light's geometry
 */
public record WeightedLight(Light light, LightWeight diffuse, LightWeight specular, LightWeight fog, @Nullable ObjectGains gains,
        LightSource source) {

    /** Prepares a light of a scene, before or after its light group is applied. */
    public static WeightedLight of(Light light, Scene scene) {
        Light acting = scene.rig().effectiveLight(light);
        WeightedLight shining = of(acting, scene, scene.stage());
        return scene.isActive(acting) ? shining : shining.darkened();
    }

    /** Prepares all lights of a scene, in its order. */
    public static WeightedLight[] ofScene(Scene scene) {
        return scene.rig().effectiveLights().stream().map(light -> of(light, scene)).toArray(WeightedLight[]::new);
    }

    /** Returns whether any light treats shapes differently, so that rows must store their owners: it has links or gains. */
    public static boolean needOwners(WeightedLight[] lights) {
        return Arrays.stream(lights).anyMatch(l -> !l.light().illuminates().isAll() || l.gains != null);
    }

    /** Prepares a light as if it were on and no other light were solo. */
    public static WeightedLight ofSwitchedOn(Light light, Scene scene) {
        return of(scene.rig().effectiveLight(light), scene, scene.stage());
    }

    /** Prepares a light as {@link #ofSwitchedOn(Light, Scene)}, with its gains on the shapes of another stage. */
    public static WeightedLight ofSwitchedOn(Light light, Scene scene, Stage gained) {
        return of(scene.rig().effectiveLight(light), scene, gained);
    }

    /**
     * Prepares a light for a film of its own or of its environment.
     *
     * @param light the light as it shines
     * @param unit  the same light as bright as in the film: a light of an environment, or the light itself, whose weight then is 1
     */
    static WeightedLight ofUnit(Light light, Light unit, Scene scene) {
        boolean isOwn = light == unit;
        LightWeight plain = isOwn ? LightWeight.ONE : LightWeight.of(unit.weight());
        boolean isGained = isOwn && light.influence().isGained();
        return new WeightedLight(light, isGained ? gain(light, light.influence().diffuse()) : plain,
                isGained ? gain(light, light.influence().specular()) : plain, isGained ? gain(light, light.influence().fog()) : plain,
                ObjectGains.of(light, scene.stage()), LightSource.of(light, scene));
    }

    private static LightWeight gain(Light light, double gain) {
        return LightWeight.gray((float) light.relativeGain(gain));
    }

    private static WeightedLight of(Light light, Scene scene, Stage gained) {
        LightWeight diffuse = LightWeight.of(light.diffuseWeight());
        return new WeightedLight(light, diffuse,
                light.influence().isGained() ? LightWeight.of(light.specularWeight()) : diffuse,
                light.influence().isGained() ? LightWeight.of(light.fogWeight()) : diffuse, ObjectGains.of(light, gained),
                LightSource.of(light, scene));
    }

    /** Returns this light without gains on single shapes. */
    public WeightedLight withoutGains() {
        return gains == null ? this : new WeightedLight(light, diffuse, specular, fog, null, source);
    }

    /** Returns this light switched off. */
    public WeightedLight darkened() {
        return new WeightedLight(light, LightWeight.ZERO, LightWeight.ZERO, LightWeight.ZERO, gains, source);
    }

    /** Returns this light as one that only fog scatters. */
    WeightedLight withoutSurfaces() {
        return new WeightedLight(light, LightWeight.ZERO, LightWeight.ZERO, fog, gains, source);
    }

    /** Returns this light dimmed by other fog. */
    public WeightedLight withFog(@Nullable FogMedium medium) {
        return new WeightedLight(light, diffuse, specular, fog, gains, source.withFog(medium));
    }

    /** Returns whether it contributes nothing to surfaces: it is off, or its weights are 0 in every channel. */
    public boolean isDark() {
        return diffuse.isZero() && specular.isZero();
    }

    /** Returns whether fog scatters none of its light. */
    public boolean isDarkInFog() {
        return fog.isZero();
    }

    /** Returns its gain on a shape. */
    public float gain(int shape) {
        return gains == null ? 1 : gains.of(shape);
    }

    /** Returns whether both have the same weights. */
    public boolean hasSameWeights(WeightedLight o) {
        return diffuse.equals(o.diffuse) && specular.equals(o.specular) && fog.equals(o.fog);
    }
}

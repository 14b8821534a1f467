package lightning.render.shading;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * Light of a scene with its weight and source, as the equation needs it. Owns a layer. The layer does not contain the weight, so it
 * stays valid if only the weight changes.
 *
 * @param light  the scene's light, after its light group
 * @param red    weight in the red channel; 0 in all three if the light is off
 * @param green  weight in the green channel
 * @param blue   weight in the blue channel
 * @param source the light's geometry
 */
public record WeightedLight(Light light, float red, float green, float blue, LightSource source) {

    /** Prepares a light of a scene, before or after its light group is applied. */
    public static WeightedLight of(Light light, Scene scene) {
        Light acting = scene.rig().effectiveLight(light);
        return of(acting, scene, scene.isActive(acting) ? acting.weight() : Rgb.BLACK);
    }

    /** Prepares all lights of a scene, in its order. */
    public static WeightedLight[] ofScene(Scene scene) {
        return scene.rig().effectiveLights().stream().map(light -> of(light, scene)).toArray(WeightedLight[]::new);
    }

    /** Returns whether any light illuminates only some shapes, so that rows must store their owners. */
    public static boolean hasLinked(WeightedLight[] lights) {
        return Arrays.stream(lights).anyMatch(l -> !l.light().illuminates().isAll());
    }

    /** Prepares a light as if it were on and no other light were solo. */
    public static WeightedLight ofSwitchedOn(Light light, Scene scene) {
        Light acting = scene.rig().effectiveLight(light);
        return of(acting, scene, acting.weight());
    }

    private static WeightedLight of(Light light, Scene scene, Rgb weight) {
        return new WeightedLight(light, (float) weight.r(), (float) weight.g(), (float) weight.b(), LightSource.of(light, scene));
    }

    /** Returns this light switched off. */
    public WeightedLight darkened() {
        return new WeightedLight(light, 0, 0, 0, source);
    }

    /**
     * Returns this light as edge detection sees it, with each weight rounded to the nearest power of two (in its logarithm). Edits
     * of color and intensity change edges only where a weight reaches another power.
     */
    public WeightedLight forEdges() {
        return new WeightedLight(light, nearestPowerOfTwo(red), nearestPowerOfTwo(green), nearestPowerOfTwo(blue), source);
    }

    /** Returns lights as edge detection sees them. */
    public static WeightedLight[] forEdges(WeightedLight[] lights) {
        return Arrays.stream(lights).map(WeightedLight::forEdges).toArray(WeightedLight[]::new);
    }

    private static float nearestPowerOfTwo(float weight) {
        return weight == 0 ? 0 : Math.scalb(1f, Math.min(Math.getExponent(weight * Math.sqrt(2)), Float.MAX_EXPONENT));
    }

    /** Returns whether it contributes nothing: it is off, or its weight is 0 in every channel. */
    public boolean isDark() {
        return red == 0 && green == 0 && blue == 0;
    }
}

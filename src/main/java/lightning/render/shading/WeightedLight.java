package lightning.render.shading;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * A light of a scene as the equation needs it: how strongly it shines, and where from. It is what owns a layer; a layer holds no
 * weight, so that it stays when the weight alone is another.
 *
 * @param light what it was made from, as its bank makes it
 * @param red   its weight in the red channel; 0 in all three where the light is off
 * @param green likewise
 * @param blue  likewise
 * @param source  where it shines from
 */
public record WeightedLight(Light light, float red, float green, float blue, LightSource source) {

    /** Prepares a light of a scene, as it stands there or as its bank makes it. */
    public static WeightedLight of(Light light, Scene scene) {
        Light acting = scene.rig().effectiveLight(light);
        return of(acting, scene, scene.isActive(acting) ? acting.weight() : Rgb.BLACK);
    }

    /** Prepares all lights of a scene, in its order. */
    public static WeightedLight[] ofScene(Scene scene) {
        return scene.rig().effectiveLights().stream().map(light -> of(light, scene)).toArray(WeightedLight[]::new);
    }

    /** Whether any of them shines on some shapes alone, so that rows must know whose they are. */
    public static boolean hasLinked(WeightedLight[] lights) {
        return Arrays.stream(lights).anyMatch(l -> !l.light().illuminates().isAll());
    }

    /** Prepares a light as if it were on and no other were solo. */
    public static WeightedLight ofSwitchedOn(Light light, Scene scene) {
        Light acting = scene.rig().effectiveLight(light);
        return of(acting, scene, acting.weight());
    }

    private static WeightedLight of(Light light, Scene scene, Rgb weight) {
        return new WeightedLight(light, (float) weight.r(), (float) weight.g(), (float) weight.b(), LightSource.of(light, scene));
    }

    /** Whether it adds nothing anywhere: off, or a weight that is 0 in every channel. */
    public boolean isDark() {
        return red == 0 && green == 0 && blue == 0;
    }
}

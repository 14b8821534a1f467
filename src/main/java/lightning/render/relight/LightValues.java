package lightning.render.relight;

import java.util.List;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Comparison of lights and scenes whose contributions are multiples of each other. */
public final class LightValues {
    private LightValues() {}

    /**
     * Returns whether nothing but values of lights differ: colors, intensities, exposures, temperatures, whether they are on or solo, and the
     * intensities of the environments.
     */
    public static boolean areOnlyDifference(Scene a, Scene b) {
        return b.camera().equals(a.camera()) && b.picture().equals(a.picture()) && b.stage().equals(a.stage())
                && a.world().withIntensitiesOf(b.world()).equals(b.world()) && areOnlyDifference(a.rig().effectiveLights(),
                        b.rig().effectiveLights());
    }

    private static boolean areOnlyDifference(List<Light> a, List<Light> b) {
        for (int l = 0; l < Math.min(a.size(), b.size()); l++) {
            if (!areOnlyDifference(a.get(l), b.get(l))) {
                return false;
            }
        }
        return a.size() == b.size();
    }

    /** Returns whether nothing but values of two effective lights differ. */
    public static boolean areOnlyDifference(Light a, Light b) {
        return a.withColor(b.color()).withIntensity(b.intensity()).withOn(b.on()).withSolo(b.solo()).equals(b);
    }
}

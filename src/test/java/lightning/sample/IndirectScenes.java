package lightning.sample;

import java.util.Optional;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/** Scenes with diffuse indirect light, with few rays so that tests are fast. */
public final class IndirectScenes {
    private IndirectScenes() {}

    /** Returns a scene with indirect light of its lights. */
    public static Scene with(Scene scene) {
        return with(scene, false);
    }

    /** Returns a scene with indirect light of its lights and its background. */
    public static Scene withBackground(Scene scene) {
        return with(scene, true);
    }

    private static Scene with(Scene scene, boolean background) {
        return scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 4, background))));
    }

    /** Returns a scene without anti-aliasing at edges. */
    public static Scene withoutEdges(Scene scene) {
        return scene.picture().sampling().antialias() != AntialiasMode.EDGES ? scene
                : scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
    }
}

package lightning.render.cache;

import java.util.List;
import lightning.render.shading.fog.PictureFog;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene that levels of a cached picture show, with what was computed of its light.
 *
 * @param scene    the scene
 * @param lights   all its lights, in order, with the stamps of their layers in these levels
 * @param indirect its indirect light; null if it has none
 * @param fog      its fog along the camera rays of the first level, or along the rays that bounce to levels in mirrors; null if its air is clear, and
 *     in mirrors also if no light is seen in it
 */
public record CachedScene(Scene scene, List<CachedLight> lights, @Nullable IndirectCache indirect, @Nullable PictureFog fog) {
    public CachedScene {
        lights = List.copyOf(lights);
    }
}

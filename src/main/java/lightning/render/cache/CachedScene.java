package lightning.render.cache;

import java.util.List;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene that levels of a cached picture show, with what was computed of its light.
 *
 * @param scene    the scene
 * @param lights   all its lights, in order, with the stamps of their layers in these levels
 * @param indirect its indirect light; null if it has none
 */
public record CachedScene(Scene scene, List<CachedLight> lights, @Nullable IndirectCache indirect) {
    public CachedScene {
        lights = List.copyOf(lights);
    }
}

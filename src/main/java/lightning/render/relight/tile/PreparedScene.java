package lightning.render.relight.tile;

import lightning.render.gather.PointChanges;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene of a level, prepared for rendering.
 *
 * @param geometry geometry with the scene's materials
 * @param lights     the scene's lights, in its order
 * @param edgeLights the same lights as edge detection sees them
 * @param indirect   the scene's indirect light; null if it has none, or before it is computed
 * @param pointChanges change of its gather points since the last picture; null if all may have changed, or none did
 */
public record PreparedScene(Geometry geometry, Scene scene, WeightedLight[] lights, WeightedLight[] edgeLights,
        @Nullable IndirectLight indirect, @Nullable PointChanges pointChanges) {
    // An array in a record: written once by its creator, never after.

    /** @param geometry geometry of the same shapes, with any materials */
    public static PreparedScene of(Geometry geometry, Scene scene) {
        WeightedLight[] lights = WeightedLight.ofScene(scene);
        return new PreparedScene(geometry.withMaterialsOf(scene), scene, lights, WeightedLight.forEdges(lights), null, null);
    }

    /** Returns this scene with its indirect light. */
    PreparedScene withIndirect(@Nullable IndirectLight light, @Nullable PointChanges changes) {
        return new PreparedScene(geometry, scene, lights, edgeLights, light, changes);
    }
}

package lightning.render.relight.tile;

import lightning.render.gather.PointChanges;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene of a level, prepared for rendering.
 *
 * @param geometry  geometry with the scene's materials
 * @param parts     its films
 * @param edgeParts films for edge detection: the same unless films contain weights
 * @param indirect  the scene's indirect light; null if it has none, or before it is computed
 * @param pointChanges change of its gather points since the last picture; null if all may have changed, or none did
 */
public record PreparedScene(Geometry geometry, FilmParts parts, FilmParts edgeParts, @Nullable IndirectLight indirect,
        @Nullable PointChanges pointChanges) {
    /**
     * @param geometry   geometry of the same shapes, with any materials
     * @param isWeighted whether films contain their weights, as the method of 1998 stores layers
     */
    static PreparedScene of(Geometry geometry, Scene scene, boolean isWeighted) {
        FilmParts units = FilmParts.of(scene);
        return new PreparedScene(geometry.withMaterialsOf(scene), isWeighted ? FilmParts.of(scene, true) : units, units, null, null);
    }

    Scene scene() {
        return parts.scene();
    }

    /** Returns the scene's lights, in its order, with the weights that films contain. */
    WeightedLight[] lights() {
        return parts.lights();
    }

    /** Returns this scene with its indirect light. */
    PreparedScene withIndirect(@Nullable IndirectLight light, @Nullable PointChanges changes) {
        return new PreparedScene(geometry, parts, edgeParts, light, changes);
    }
}

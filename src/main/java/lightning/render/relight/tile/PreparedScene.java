package lightning.render.relight.tile;

import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * A scene that levels show, made ready for work on them.
 *
 * @param geometry with the scene's materials
 * @param lights   the scene's lights, in its order
 */
public record PreparedScene(Geometry geometry, Scene scene, WeightedLight[] lights) {
    // An array in a record: written once by its maker, never after.

    /** @param geometry of the same shapes, with whatever materials */
    public static PreparedScene of(Geometry geometry, Scene scene) {
        return new PreparedScene(geometry.withMaterialsOf(scene), scene, WeightedLight.ofScene(scene));
    }
}

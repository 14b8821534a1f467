package lightning.format.exchange;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/**
 * Returns whether a scene's camera is in a closed room, where most light is indirect: at least nine of ten rays from the camera in all
 * directions hit an object. Windows and doors may be open.
 */
final class ClosedRoom {
    private static final int RAYS = 256;
    private static final double MIN_HIT_SHARE = 0.9;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private ClosedRoom() {}

    /** Returns whether the scene's camera is in a closed room. Ignores textures, so that they need not be loaded. */
    static boolean contains(Scene scene) {
        if (scene.stage().shapeCount() == 0) {
            return false;
        }
        List<Material> untextured = scene.materials().stream()
                .map(Material::withoutImages).toList();
        Geometry geometry = Geometry.of(scene.withMaterials(untextured));
        Vec3 eye = geometry.toRenderSpace(scene.camera().origin());
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            hits += geometry.nearest(new Ray(eye, direction(i))) >= 0 ? 1 : 0;
        }
        return hits >= MIN_HIT_SHARE * RAYS;
    }

    /** Returns a direction of an even distribution over the sphere: a spiral of equal heights. */
    private static Vec3 direction(int i) {
        double y = 1 - (2 * i + 1.0) / RAYS;
        double radius = Math.sqrt(1 - y * y);
        return new Vec3(radius * Math.cos(GOLDEN_ANGLE * i), y, radius * Math.sin(GOLDEN_ANGLE * i));
    }
}

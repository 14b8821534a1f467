package lightning.format.layer;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.cache.PixelCache;
import lightning.render.trace.Eye;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;

/** What the rays through the pixels' centres meet: no mean of samples, as a mean of two places, directions or numbers is neither. */
final class Surfaces {
    /** Normal, point, depth, number of the shape and of the material. */
    static final List<String> CHANNELS = List.of("N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "Z", "shape.id", "material.id");
    /** The depth where nothing is met, as in Blender. */
    static final float NOWHERE = 1e10f;

    private final Eye eye;
    private final Geometry geometry;
    private final Vec3 ahead;

    Surfaces(PixelCache cache) {
        eye = new Eye(cache.scene());
        geometry = cache.geometry();
        ahead = cache.scene().camera().to().minus(cache.scene().camera().from()).normalized();
    }

    /** Writes the numbers of a pixel, those of {@link #CHANNELS}; all but the depth are 0 where nothing is met. */
    void at(int x, int y, float[] to) {
        Ray ray = eye.through(x, y);
        int primitive = geometry.nearest(ray);
        if (primitive < 0) {
            java.util.Arrays.fill(to, 0);
            to[6] = NOWHERE;
            return;
        }
        SurfacePoint at = geometry.surface(primitive, ray);
        Vec3 render = new Vec3(at.px(), at.py(), at.pz());
        Vec3 point = geometry.toScene(render);
        to[0] = at.nx();
        to[1] = at.ny();
        to[2] = at.nz();
        to[3] = (float) point.x();
        to[4] = (float) point.y();
        to[5] = (float) point.z();
        to[6] = (float) render.minus(ray.origin()).dot(ahead);
        to[7] = geometry.owner(primitive) + 1;
        to[8] = at.material() + 1;
    }
}

package lightning.format.layer;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.cache.PixelCache;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;

/**
 * Surface data at the pixels' centers; not averaged over samples, because means of positions, directions or ids are
 * meaningless.
 */
final class SurfaceChannels {
    /** Normal, position, depth, shape id and material id. */
    static final List<String> CHANNELS = List.of("N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "Z", "shape.id", "material.id");
    /** Depth of the background, as in Blender. */
    static final float BACKGROUND_DEPTH = 1e10f;

    private final PixelRays eye;
    private final Geometry geometry;
    private final Vec3 viewDirection;

    SurfaceChannels(PixelCache cache) {
        eye = new PixelRays(cache.scene());
        geometry = cache.geometry();
        viewDirection = cache.scene().camera().to().minus(cache.scene().camera().from()).normalized();
    }

    /** Writes the values of a pixel, in the order of {@link #CHANNELS}; all except the depth are 0 for the background. */
    void sample(int x, int y, float[] out) {
        Ray ray = eye.ray(x, y);
        int primitive = geometry.nearest(ray);
        if (primitive < 0) {
            java.util.Arrays.fill(out, 0);
            out[6] = BACKGROUND_DEPTH;
            return;
        }
        SurfacePoint surface = geometry.surface(primitive, ray);
        Vec3 position = new Vec3(surface.px(), surface.py(), surface.pz());
        Vec3 point = geometry.toScene(position);
        out[0] = surface.nx();
        out[1] = surface.ny();
        out[2] = surface.nz();
        out[3] = (float) point.x();
        out[4] = (float) point.y();
        out[5] = (float) point.z();
        out[6] = (float) position.minus(ray.origin()).dot(viewDirection);
        out[7] = geometry.owner(primitive) + 1;
        out[8] = surface.material() + 1;
    }
}

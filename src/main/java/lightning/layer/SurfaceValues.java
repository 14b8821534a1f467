package lightning.layer;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.render.cache.PixelCache;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;

/**
 * Normal, position, depth and color of the surfaces that camera rays hit.
 *
 * @param viewDirection unit direction along which depth is measured
 */
record SurfaceValues(Geometry geometry, Vec3 viewDirection) {
    /** Number of values: three of the normal, three of the position, the depth, three of the color. */
    static final int COUNT = 10;
    static final int POSITION = 3;
    static final int DEPTH = 6;
    static final int COLOR = 7;
    /** Depth of the background, as in Blender. */
    static final float BACKGROUND_DEPTH = 1e10f;

    static SurfaceValues of(PixelCache cache) {
        Camera camera = cache.scene().camera();
        return new SurfaceValues(cache.geometry(), camera.to().minus(camera.from()).normalized());
    }

    /**
     * Returns the channels in the order of the values.
     *
     * @param suffix added to the names of the layers
     * @param depth name of the depth
     * @param type type of normals and colors
     */
    static List<ExrChannel> channels(String suffix, String depth, ExrType type) {
        List<ExrChannel> channels = new ArrayList<>();
        List.of("X", "Y", "Z").forEach(axis -> channels.add(new ExrChannel("N" + suffix + "." + axis, type)));
        List.of("X", "Y", "Z").forEach(axis -> channels.add(new ExrChannel("P" + suffix + "." + axis, ExrType.FLOAT)));
        channels.add(new ExrChannel(depth, ExrType.FLOAT));
        List.of("R", "G", "B").forEach(color -> channels.add(new ExrChannel("albedo" + suffix + "." + color, type)));
        return channels;
    }

    /**
     * Writes the values where a ray hits a primitive. Faces of lights have no color.
     *
     * @return the surface point
     */
    SurfacePoint write(int primitive, Ray ray, float[] to) {
        SurfacePoint surface = geometry.surface(primitive, ray);
        Vec3 position = new Vec3(surface.px(), surface.py(), surface.pz());
        Vec3 point = geometry.toScene(position);
        to[0] = surface.nx();
        to[1] = surface.ny();
        to[2] = surface.nz();
        to[POSITION] = (float) point.x();
        to[POSITION + 1] = (float) point.y();
        to[POSITION + 2] = (float) point.z();
        to[DEPTH] = (float) position.minus(ray.origin()).dot(viewDirection);
        for (int c = 0; c < 3; c++) {
            to[COLOR + c] = geometry.isLightFace(primitive) ? 0 : Math.min(1, surface.diffuse()[c] + surface.specular()[c]);
        }
        return surface;
    }
}

package lightning.render.shading.fog;

import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Fog of a picture, along camera rays or along bounced rays.
 *
 * @param rays   rays along which it is sampled
 * @param depths distance of the first surface along each ray: {@code float[rays]}
 * @param lights light in it of each light of the scene; null for lights of which it scatters nothing
 */
public record PictureFog(FogRays rays, FogMedium medium, float[] depths, @Nullable FogLight[] lights) {
    // An array in a record: written once by their creator, never after.

    /** Returns the maximum bytes of the fog of a scene, without its pixels; 0 in clear air. */
    public static long maxBytes(Scene scene) {
        if (FogMedium.of(scene) == null) {
            return 0;
        }
        long rays = new FogGrid(scene.camera(), scene.picture()).count();
        long lights = scene.rig().effectiveLights().size() * (long) FogLight.BYTES_PER_RAY;
        long bounced = lights == 0 ? 0 : BounceTracer.maxPaths(scene) * (BounceRays.BYTES + Integer.BYTES + Float.BYTES + lights);
        return rays * (Float.BYTES + lights + bounced);
    }

    /**
     * Returns the maximum bytes of fog for each camera ray of a picture: a column of each light and one of what passes, and a column of each light for
     * each bounce that shows it; 0 in clear air.
     */
    public static long maxBytesPerRay(Scene scene) {
        return FogMedium.of(scene) == null ? 0
                : Float.BYTES * (1 + scene.rig().effectiveLights().size() * (1 + BounceTracer.maxPaths(scene)));
    }

    /** Returns the grid of camera rays. */
    public FogGrid grid() {
        return rays.grid();
    }

    /** Returns the bytes of all lights. */
    public long bytes() {
        long bytes = 4L * depths.length + (rays instanceof BounceRays bounced ? bounced.bytes() : 0);
        for (FogLight light : lights) {
            bytes += light == null ? 0 : light.bytes();
        }
        return bytes;
    }
}

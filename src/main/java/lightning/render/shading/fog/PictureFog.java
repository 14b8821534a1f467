package lightning.render.shading.fog;

import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Fog of a picture.
 *
 * @param grid   rays along which it is sampled
 * @param depths distance of the first surface along each ray: {@code float[rays]}
 * @param lights light in it of each light of the scene; null for lights of which it scatters nothing
 */
public record PictureFog(FogGrid grid, FogMedium medium, float[] depths, @Nullable FogLight[] lights) {
    // An array in a record: written once by its creator, never after.

    /** Returns the maximum bytes of the fog of a scene, without its pixels; 0 in clear air. */
    public static long maxBytes(Scene scene) {
        return FogMedium.of(scene) == null ? 0
                : new FogGrid(scene.camera(), scene.picture()).count()
                        * (Float.BYTES + scene.rig().effectiveLights().size() * (long) FogLight.BYTES_PER_RAY);
    }

    /** Returns the bytes of all lights. */
    public long bytes() {
        long bytes = 4L * depths.length;
        for (FogLight light : lights) {
            bytes += light == null ? 0 : light.bytes();
        }
        return bytes;
    }
}

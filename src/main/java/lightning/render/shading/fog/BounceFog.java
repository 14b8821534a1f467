package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.render.fog.FogMedium;
import lightning.render.shading.TermKernel;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.scene.Scene;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Dims the colors of reflected and refracted rays by the fog along them, and adds its ambient light. There is no fog inside transparent bodies.
 * Light of lamps in the fog is not seen in mirrors. Holds scratch memory: use one instance per thread.
 */
public final class BounceFog {
    private final FogMedium medium;
    private final Fog fog;
    private final double[] distance = new double[TermKernel.MAX_ROWS];
    private final double[] direction = new double[3];

    private BounceFog(FogMedium medium, Fog fog) {
        this.medium = medium;
        this.fog = fog;
    }

    /** Returns the fog of a scene; null if its air is clear. */
    public static @Nullable BounceFog of(Scene scene) {
        FogMedium medium = FogMedium.of(scene);
        return medium == null ? null : new BounceFog(medium, scene.world().fog());
    }

    /**
     * Adds fog to the colors of the rays that bounce from a level's rows.
     *
     * @param below  rows that these rays hit
     * @param colors red, green and blue by row of the level above; overwritten
     */
    public void add(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, float[][] colors) {
        int count = bounce.rowCount(above);
        Arrays.fill(distance, 0, count, Double.POSITIVE_INFINITY);
        for (int i = 0; i < below.count; i++) {
            int from = below.parent[i];
            double x = (double) below.px[i] - above.px[from];
            double y = (double) below.py[i] - above.py[from];
            double z = (double) below.pz[i] - above.pz[from];
            distance[from] = Math.sqrt(x * x + y * y + z * z);
        }
        for (int i = 0; i < count; i++) {
            boolean isInside = i < above.clearCount && above.isInside(i) == (bounce == BounceKind.MIRRORED);
            if (!isInside && bounce.writeDirection(above, i, materials, direction)) {
                float transmittance = transmittance(medium, above.px[i], above.py[i], above.pz[i], direction, distance[i]);
                for (int c = 0; c < 3; c++) {
                    colors[c][i] = color(colors[c][i], transmittance, fog, c);
                }
            }
        }
    }

    /** Returns what fog transmits of a ray. */
    public static float transmittance(FogMedium medium, float x, float y, float z, double[] direction, double distance) {
        return (float) FogMedium.transmittance(medium.depth(x, y, z, direction[0], direction[1], direction[2], distance));
    }

    /** Returns one channel of the color of a ray through fog without lamps. */
    public static float color(float surface, float transmittance, Fog fog, int c) {
        return FogComposer.color(surface, transmittance, FogComposer.channel(fog.color(), c), FogComposer.channel(fog.ambient(), c), 0);
    }
}

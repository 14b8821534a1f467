package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.render.fog.FogMedium;
import lightning.render.shading.ClearMaterialShader;
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
    private final float[] transmittance = new float[TermKernel.MAX_ROWS];

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
        writeTransmittances(above, below, bounce, materials, transmittance);
        for (int c = 0; c < 3; c++) {
            float tint = ClearMaterialShader.channel(fog.color(), c);
            float ambient = ClearMaterialShader.channel(fog.ambient(), c);
            for (int i = 0; i < bounce.rowCount(above); i++) {
                colors[c][i] = FogComposer.color(colors[c][i], transmittance[i], tint, ambient, 0);
            }
        }
    }

    /**
     * Writes what the fog transmits of each ray that bounces from a level's rows; 1 inside of transparent bodies and for rows without a ray.
     *
     * @param below rows that these rays hit
     */
    public void writeTransmittances(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, float[] to) {
        int count = bounce.rowCount(above);
        float[] ox = bounce.originX(above);
        float[] oy = bounce.originY(above);
        float[] oz = bounce.originZ(above);
        Arrays.fill(distance, 0, count, Double.POSITIVE_INFINITY);
        for (int i = 0; i < below.count; i++) {
            int from = below.parent[i];
            double x = (double) below.px[i] - ox[from];
            double y = (double) below.py[i] - oy[from];
            double z = (double) below.pz[i] - oz[from];
            distance[from] = Math.sqrt(x * x + y * y + z * z);
        }
        for (int i = 0; i < count; i++) {
            boolean isInside = i < above.clearCount && above.isInside(i) == (bounce == BounceKind.MIRRORED);
            boolean passesFog = !isInside && bounce.writeDirection(above, i, materials, direction);
            to[i] = passesFog ? transmittance(ox[i], oy[i], oz[i], distance[i]) : 1;
        }
    }

    /** Returns what fog transmits of a ray. */
    private float transmittance(float x, float y, float z, double length) {
        return (float) FogMedium.transmittance(medium.depth(x, y, z, direction[0], direction[1], direction[2], length));
    }
}

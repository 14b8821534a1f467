package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Ray;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRay;
import lightning.render.shading.ClearMaterialShader;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Dims the colors of reflected and refracted rays by the fog along them, and adds its ambient light; along rays that bounce at the first level, and
 * those that only refractions lead to, the light of lamps, too. There is no fog inside transparent bodies. Holds scratch memory: use one instance
 * per thread.
 */
public final class BounceFog {
    private static final float[] @Nullable [] NO_LIGHT = {};

    private final FogMedium medium;
    private final Fog fog;
    /** Null if no light is seen in the fog. */
    private final @Nullable BounceLookup lookup;
    private final double[] distance = new double[TermKernel.MAX_ROWS];
    private final double[] direction = new double[3];
    private final float[] transmittance = new float[TermKernel.MAX_ROWS];
    private final float[] sum = new float[TermKernel.MAX_ROWS];

    private BounceFog(FogMedium medium, Fog fog, @Nullable BounceLookup lookup) {
        this.medium = medium;
        this.fog = fog;
        this.lookup = lookup;
    }

    /**
     * Returns the fog of a scene; null if its air is clear.
     *
     * @param bounced its fog along bounced rays; null if no light is seen there
     */
    public static @Nullable BounceFog of(Scene scene, @Nullable PictureFog bounced) {
        FogMedium medium = FogMedium.of(scene);
        return medium == null ? null
                : new BounceFog(medium, scene.world().fog(),
                        bounced == null || bounced.rays().count() == 0 ? null : new BounceLookup(bounced));
    }

    /**
     * Returns the first level's rows as the start of bounced rays; null if no light is seen in the fog.
     *
     * @param places image positions of the level's rays
     */
    public @Nullable BounceStart start(SamplePositions places, HitRows rows) {
        return lookup == null || rows.reflectiveCount == 0 ? null : BounceStart.of(places, rows);
    }

    /**
     * Adds fog to the colors of the rays that bounce from a level's rows.
     *
     * @param below  rows that these rays hit
     * @param start  the level's rows as the start of these rays; null if they show no light in fog
     * @param lights lights of the scene, in its order
     * @param colors red, green and blue by row of the level above; overwritten
     */
    public void add(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, @Nullable BounceStart start,
            WeightedLight[] lights, float[][] colors) {
        int count = bounce.rowCount(above);
        writeTransmittances(above, below, bounce, materials, transmittance);
        float[] @Nullable [] scattered = scattered(above, below, bounce, materials, start, lights, null);
        for (int c = 0; c < 3; c++) {
            float tint = ClearMaterialShader.channel(fog.color(), c);
            float ambient = ClearMaterialShader.channel(fog.ambient(), c);
            Arrays.fill(sum, 0, count, 0);
            for (int l = 0; l < scattered.length; l++) {
                float[] column = scattered[l];
                float weight = column == null ? 0 : lights[l].fog().channel(c);
                for (int i = 0; column != null && i < count; i++) {
                    sum[i] += weight * column[i];
                }
            }
            for (int i = 0; i < count; i++) {
                colors[c][i] = FogComposer.color(colors[c][i], transmittance[i], tint, ambient, sum[i]);
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
        writeDistances(above, below, bounce);
        float[] ox = bounce.originX(above);
        float[] oy = bounce.originY(above);
        float[] oz = bounce.originZ(above);
        for (int i = 0; i < count; i++) {
            to[i] = passesFog(above, i, bounce, materials) ? transmittance(ox[i], oy[i], oz[i], distance[i]) : 1;
        }
    }

    /**
     * Looks up the light of each lamp of weight 1 in the fog along rays that bounce from a level's rows.
     *
     * @param start  the level's rows as the start of these rays; null if they show no light in fog
     * @param lights lights of the scene, in its order
     * @param rows   rows to look up; null for all
     * @return a column for each light, in the order of these rows, null for lights that are dark there; no column if {@code start} is null. Scratch
     *         memory, valid until the next call
     */
    public float[] @Nullable [] scattered(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials,
            @Nullable BounceStart start, WeightedLight[] lights, int @Nullable [] rows) {
        int path = start == null ? -1 : start.path(bounce);
        if (lookup == null || start == null || path < 0) {
            return NO_LIGHT;
        }
        writeDistances(above, below, bounce);
        lookup.clear();
        int count = bounce.rowCount(above);
        for (int k = 0; k < (rows == null ? count : rows.length); k++) {
            int i = rows == null ? k : rows[k];
            if (i >= count || !passesFog(above, i, bounce, materials)) {
                lookup.addNone();
                continue;
            }
            FogRay line = lookup.next();
            line.ox = bounce.originX(above)[i];
            line.oy = bounce.originY(above)[i];
            line.oz = bounce.originZ(above)[i];
            line.dx = direction[0];
            line.dy = direction[1];
            line.dz = direction[2];
            lookup.add(start.x()[i], start.y()[i], path, above.material(i), distance[i]);
        }
        return lookup.lookUp(lights);
    }

    /**
     * Returns the light of each lamp of weight 1 in the fog along one bounced ray: {@code float[lights]}.
     *
     * @param bounced fog along bounced rays
     * @param length  distance of what it hits; infinite for none
     * @param x       image coordinates of the pixel that shows it, as {@code y}
     * @param path     its path, as in {@link lightning.render.fog.BounceRays}
     * @param material index of the material from which it bounces
     */
    public static float[] scatteredAlong(PictureFog bounced, Ray ray, double length, double x, double y, int path, int material,
            WeightedLight[] lights) {
        var lookup = new BounceLookup(bounced);
        FogRay line = lookup.next();
        line.ox = ray.origin().x();
        line.oy = ray.origin().y();
        line.oz = ray.origin().z();
        line.dx = ray.direction().x();
        line.dy = ray.direction().y();
        line.dz = ray.direction().z();
        lookup.add(x, y, path, material, length);
        float[] @Nullable [] columns = lookup.lookUp(lights);
        float[] light = new float[lights.length];
        for (int l = 0; l < light.length; l++) {
            light[l] = columns[l] == null ? 0 : columns[l][0];
        }
        return light;
    }

    private void writeDistances(HitRows above, HitRows below, BounceKind bounce) {
        float[] ox = bounce.originX(above);
        float[] oy = bounce.originY(above);
        float[] oz = bounce.originZ(above);
        Arrays.fill(distance, 0, bounce.rowCount(above), Double.POSITIVE_INFINITY);
        for (int i = 0; i < below.count; i++) {
            int from = below.parent[i];
            double x = (double) below.px[i] - ox[from];
            double y = (double) below.py[i] - oy[from];
            double z = (double) below.pz[i] - oz[from];
            distance[from] = Math.sqrt(x * x + y * y + z * z);
        }
    }

    /** Returns whether a row casts a ray into the air, and sets its direction. */
    private boolean passesFog(HitRows above, int row, BounceKind bounce, MaterialTable materials) {
        return !isInside(above, row, bounce, materials) && bounce.writeDirection(above, row, materials, direction);
    }

    /** Returns whether the ray that bounces from a row is inside of a transparent body. */
    private static boolean isInside(HitRows above, int row, BounceKind bounce, MaterialTable materials) {
        return row < above.clearCount && switch (bounce) {
            case MIRRORED -> above.isInside(row);
            case REFRACTED -> !above.isInside(row) && !materials.transmission(above.material(row)).thin();
        };
    }

    /** Returns what fog transmits of a ray. */
    private float transmittance(float x, float y, float z, double length) {
        return (float) FogMedium.transmittance(medium.depth(x, y, z, direction[0], direction[1], direction[2], length));
    }
}

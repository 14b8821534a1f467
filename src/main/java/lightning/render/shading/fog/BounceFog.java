package lightning.render.shading.fog;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.base.math.Ray;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRay;
import lightning.render.shading.FilmParts;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.FilmColors;
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
    private final FogMedium medium;
    private final Fog fog;
    /** Null if no light is seen in the fog. */
    private final @Nullable BounceLookup lookup;
    private final double[] distance = new double[TermKernel.MAX_ROWS];
    private final double[] direction = new double[3];
    private final float[] transmittance = new float[TermKernel.MAX_ROWS];
    private final FogComposer composer = new FogComposer();

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
     * @param below   rows that these rays hit
     * @param columns light of lamps along these rays; null if they show none
     * @param films   films that are composed; none is dark
     * @param colors  of these films; overwritten
     */
    public void add(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, @Nullable BounceColumns columns,
            FilmParts parts, BitSet films, FilmColors colors) {
        writeTransmittances(above, below, bounce, materials, transmittance);
        for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
            composer.add(transmittance, columns == null ? null : columns.columns(), parts, part, fog, bounce.rowCount(above), colors);
        }
    }

    /**
     * Writes what the fog transmits of each ray that bounces from a level's rows; 1 inside of transparent bodies and for rows without a ray.
     *
     * @param below rows that these rays hit
     */
    private void writeTransmittances(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, float[] to) {
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
     * Looks up the light of lamps in the fog along rays that bounce from a level's rows. Keeps columns that are known.
     *
     * @param start  the level's rows as the start of these rays; null if they show no light in fog
     * @param lights lights of the scene, in its order
     * @param known  columns that were looked up before; null for none
     * @return null if no light is seen along these rays
     */
    public @Nullable BounceColumns columns(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials,
            @Nullable BounceStart start, WeightedLight[] lights, @Nullable BounceColumns known) {
        int path = start == null ? -1 : start.path(bounce);
        if (lookup == null || start == null || path < 0) {
            return null;
        }
        @Nullable
        FogLight[] sources = lookup.sources(lights);
        BounceColumns same = known != null && known.areBetween(above, below) ? known : null;
        if (same != null && Arrays.equals(sources, same.sources(), (a, b) -> a == b ? 0 : 1)) {
            return same;
        }
        boolean[] isUnknown = new boolean[sources.length];
        boolean any = false;
        for (int l = 0; l < sources.length; l++) {
            FogLight source = sources[l];
            isUnknown[l] = source != null && (same == null || same.index(source) < 0);
            any |= isUnknown[l];
        }
        if (any) {
            setRays(above, below, bounce, materials, start, path);
        }
        float[] @Nullable [] columns = new float[sources.length][];
        for (int l = 0; l < sources.length; l++) {
            FogLight source = sources[l];
            if (source != null) {
                columns[l] = isUnknown[l] || same == null ? lookup.lookUp(l, lights[l]) : same.columns()[same.index(source)];
            }
        }
        return new BounceColumns(above, below, sources, columns);
    }

    private void setRays(HitRows above, HitRows below, BounceKind bounce, MaterialTable materials, BounceStart start, int path) {
        BounceLookup rays = requireNonNull(lookup);
        writeDistances(above, below, bounce);
        rays.clear();
        for (int i = 0; i < bounce.rowCount(above); i++) {
            if (!passesFog(above, i, bounce, materials)) {
                rays.addNone();
                continue;
            }
            FogRay line = rays.next();
            line.ox = bounce.originX(above)[i];
            line.oy = bounce.originY(above)[i];
            line.oz = bounce.originZ(above)[i];
            line.dx = direction[0];
            line.dy = direction[1];
            line.dz = direction[2];
            rays.add(start.x()[i], start.y()[i], path, above.material(i), distance[i]);
        }
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
        float[] light = new float[lights.length];
        @Nullable
        FogLight[] sources = lookup.sources(lights);
        for (int l = 0; l < light.length; l++) {
            float[] column = sources[l] == null ? null : lookup.lookUp(l, lights[l]);
            light[l] = column == null ? 0 : column[0];
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

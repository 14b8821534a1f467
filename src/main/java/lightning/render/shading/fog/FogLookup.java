package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.image.Film;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/** Looks up the fog before the surfaces of a tile. Casts no ray. Holds scratch memory: use one instance per thread. */
public final class FogLookup {
    private static final int SIZE = Film.TILE_PIXELS;
    /** Column of a tile that a light does not reach; never written. */
    private static final float[] DARK = new float[SIZE];

    private final PictureFog fog;
    private final WeightedLight[] lights;
    private final FogPath path = new FogPath();
    private final FogRay ray = new FogRay();
    private final double[] distance = new double[SIZE];
    private final double[] dx = new double[SIZE];
    private final double[] dy = new double[SIZE];
    private final double[] dz = new double[SIZE];
    private final double[] x = new double[SIZE];
    private final double[] y = new double[SIZE];
    /** Bounds of x and y. */
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;
    private final FogSums sums;
    /** Samples of each light, created on first use. */
    private final @Nullable FogSamples[] samples;

    /** @param lights lights of the scene, in its order */
    public FogLookup(PictureFog fog, WeightedLight[] lights) {
        this.fog = fog;
        this.lights = lights;
        sums = new FogSums(fog.grid());
        samples = new FogSamples[lights.length];
    }

    /**
     * Returns the fog of a tile; shares columns with the old one where nothing changed.
     *
     * @param rows rows of camera rays
     * @param old  fog before the same surfaces; null for none
     */
    public FogTile tile(SamplePositions places, HitRows rows, @Nullable FogTile old) {
        @Nullable
        FogLight[] sources = sources();
        FogTile known = old != null && fog.medium().equals(old.medium()) ? old : null;
        if (known != null && Arrays.equals(sources, known.sources(), (a, b) -> a == b ? 0 : 1)) {
            return known;
        }
        if (known == null || Arrays.stream(sources).anyMatch(light -> light != null && column(known, light) == null)) {
            setRays(places, rows);
        }
        return lookUp(places.count(), sources, known);
    }

    /** Returns the light in the fog of each light that shines in it; null for others. */
    private @Nullable FogLight[] sources() {
        @Nullable
        FogLight[] sources = new FogLight[lights.length];
        Arrays.setAll(sources, l -> lights[l].isDarkInFog() ? null : fog.lights()[l]);
        return sources;
    }

    /**
     * Looks up the rays that were set, where no column is known.
     *
     * @param known fog before the same surfaces; null for none
     */
    private FogTile lookUp(int count, @Nullable FogLight[] sources, @Nullable FogTile known) {
        float[] @Nullable [] scattered = new float[lights.length][];
        for (int l = 0; l < lights.length; l++) {
            FogLight light = sources[l];
            float[] column = light == null || known == null ? null : column(known, light);
            scattered[l] = light == null || column != null ? column : scattered(count, light, l);
        }
        return new FogTile(fog.medium(), known != null ? known.transmittance() : transmittance(count), sources, scattered);
    }

    /**
     * Returns the fog before one point of the image, as that of a tile with one position.
     *
     * @param px     image coordinates, pixels, as {@code py}
     * @param length distance of the surface from the eye; infinite for none
     */
    public FogTile point(double px, double py, double length) {
        x[0] = px;
        y[0] = py;
        distance[0] = length;
        setDirections(1);
        return lookUp(1, sources(), null);
    }

    private static float @Nullable [] column(FogTile known, FogLight light) {
        for (int i = 0; i < known.sources().length; i++) {
            if (known.sources()[i] == light) {
                return known.scattered()[i];
            }
        }
        return null;
    }

    /** Returns whether a column is the shared one of tiles that a light does not reach. */
    static boolean isDark(float[] column) {
        return column == DARK;
    }

    private FogSamples samples(int l) {
        FogSamples known = samples[l];
        if (known == null) {
            known = new FogSamples(fog.grid().scale(), lights[l].source());
            samples[l] = known;
        }
        return known;
    }

    private void setRays(SamplePositions places, HitRows rows) {
        int count = places.count();
        places.writePositions(0, count, x, y);
        Arrays.fill(distance, 0, count, Double.POSITIVE_INFINITY);
        Vec3 eye = fog.grid().eye();
        for (int i = 0; i < rows.count; i++) {
            double px = rows.px[i] - eye.x();
            double py = rows.py[i] - eye.y();
            double pz = rows.pz[i] - eye.z();
            distance[rows.parent[i]] = Math.sqrt(px * px + py * py + pz * pz);
        }
        setDirections(count);
    }

    private void setDirections(int count) {
        minX = Double.POSITIVE_INFINITY;
        minY = Double.POSITIVE_INFINITY;
        maxX = 0;
        maxY = 0;
        for (int i = 0; i < count; i++) {
            minX = Math.min(minX, x[i]);
            minY = Math.min(minY, y[i]);
            maxX = Math.max(maxX, x[i]);
            maxY = Math.max(maxY, y[i]);
            fog.grid().writeDirection(x[i], y[i], dx, dy, dz, i);
        }
    }

    private float[] transmittance(int count) {
        Vec3 eye = fog.grid().eye();
        float[] to = new float[SIZE];
        for (int i = 0; i < count; i++) {
            to[i] = (float) FogMedium.transmittance(fog.medium().depth(eye.x(), eye.y(), eye.z(), dx[i], dy[i], dz[i], distance[i]));
        }
        return to;
    }

    private float[] scattered(int count, FogLight light, int l) {
        if (!sums.set(light, minX, minY, maxX, maxY)) {
            return DARK;
        }
        FogSamples samples = samples(l);
        float[] to = new float[SIZE];
        Vec3 eye = fog.grid().eye();
        ray.ox = eye.x();
        ray.oy = eye.y();
        ray.oz = eye.z();
        for (int i = 0; i < count; i++) {
            ray.dx = dx[i];
            ray.dy = dy[i];
            ray.dz = dz[i];
            samples.aim(path, ray);
            to[i] = sums.before(x[i], y[i], path.place(distance[i]));
        }
        return to;
    }
}

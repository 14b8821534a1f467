package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.render.image.Film;
import lightning.render.shading.LightSource;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/** Looks up the fog before the surfaces of a tile. Casts no ray. Holds scratch memory: use one instance per thread. */
public final class FogLookup {
    private static final int SIZE = Film.TILE_PIXELS;

    private final PictureFog fog;
    private final WeightedLight[] lights;
    private final FogPath path = new FogPath();
    private final double[] distance = new double[SIZE];
    private final double[] dx = new double[SIZE];
    private final double[] dy = new double[SIZE];
    private final double[] dz = new double[SIZE];
    private final double[] x = new double[SIZE];
    private final double[] y = new double[SIZE];

    /** @param lights lights of the scene, in its order */
    public FogLookup(PictureFog fog, WeightedLight[] lights) {
        this.fog = fog;
        this.lights = lights;
    }

    /**
     * Returns the fog of a tile; shares columns with the old one where nothing changed.
     *
     * @param rows rows of camera rays
     * @param old  fog before the same surfaces; null for none
     */
    public FogTile tile(SamplePositions places, HitRows rows, @Nullable FogTile old) {
        boolean keepsAll = old != null && fog.medium().equals(old.medium());
        @Nullable
        FogLight[] sources = new FogLight[lights.length];
        @Nullable
        FogTile known = keepsAll ? old : null;
        float[] @Nullable [] scattered = new float[lights.length][];
        for (int l = 0; l < lights.length; l++) {
            FogLight light = fog.lights()[l];
            float[] column = light == null || lights[l].isDarkInFog() ? null : column(known, light);
            scattered[l] = column;
            sources[l] = column == null ? null : light;
            keepsAll &= column != null || light == null || lights[l].isDarkInFog();
        }
        if (known != null && keepsAll && Arrays.equals(sources, known.sources(), (a, b) -> a == b ? 0 : 1)) {
            return known;
        }
        if (!keepsAll) {
            setRays(places, rows);
        }
        for (int l = 0; l < lights.length; l++) {
            FogLight light = fog.lights()[l];
            if (scattered[l] == null && light != null && !lights[l].isDarkInFog()) {
                scattered[l] = scattered(places.count(), light, lights[l].source());
                sources[l] = light;
            }
        }
        return new FogTile(fog.medium(), known != null ? known.transmittance() : transmittance(places.count()), sources, scattered);
    }

    private static float @Nullable [] column(@Nullable FogTile known, FogLight light) {
        for (int i = 0; known != null && i < known.sources().length; i++) {
            if (known.sources()[i] == light) {
                return known.scattered()[i];
            }
        }
        return null;
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
        for (int i = 0; i < count; i++) {
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

    private float[] scattered(int count, FogLight light, LightSource source) {
        FogSamples samples = new FogSamples(fog.grid(), source);
        float[] to = new float[SIZE];
        for (int i = 0; i < count; i++) {
            samples.aim(path, dx[i], dy[i], dz[i]);
            to[i] = sum(light.sums(), x[i], y[i], path.place(distance[i]) * FogGrid.SAMPLES);
        }
        return to;
    }

    /** Interpolates the sums of the four rays around a point of the image. */
    private float sum(float[] sums, double px, double py, double place) {
        FogGrid grid = fog.grid();
        double column = FogGrid.position(px);
        double line = FogGrid.position(py);
        int c = Math.clamp((int) column, 1, grid.columns() - 3);
        int r = Math.clamp((int) line, 1, grid.lines() - 3);
        float u = (float) Math.clamp(column - c, 0, 1);
        float v = (float) Math.clamp(line - r, 0, 1);
        int k = Math.min((int) place, FogGrid.SAMPLES - 1);
        float share = (float) (place - k);
        int stride = FogGrid.SAMPLES + 1;
        int at = (r * grid.columns() + c) * stride + k;
        int below = at + grid.columns() * stride;
        float top = before(sums, at, share) * (1 - u) + before(sums, at + stride, share) * u;
        float bottom = before(sums, below, share) * (1 - u) + before(sums, below + stride, share) * u;
        return top * (1 - v) + bottom * v;
    }

    private static float before(float[] sums, int at, float share) {
        return sums[at] * (1 - share) + sums[at + 1] * share;
    }
}

package lightning.render.trace.primitive;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.scene.asset.TextureMap;
import org.jspecify.annotations.Nullable;

/** Mean texture color of a square on a surface. Holds scratch memory: use one per thread. */
public final class TextureFootprint {
    /** Lookups along a side. */
    private static final int SIDE = 4;
    private static final float SHARE = 1f / (SIDE * SIDE);

    private final TextureLookup lookup = new TextureLookup();
    private final float[] texel = new float[3];

    /**
     * Writes the mean linear RGB, 0…1, to {@code rgb[0…2]}.
     *
     * @param part part of primitive {@code s} that was hit
     * @param map  texture of its material; null if it has none
     * @param x    local coordinates of the center, with {@code y} and {@code z}
     * @param nx   unit normal of the square in render space, with {@code ny} and {@code nz}
     * @param side of the square, scene units
     */
    public void lookUp(PrimitiveTable primitives, int s, int part, @Nullable TextureMap map, double x, double y, double z, float nx,
            float ny, float nz, double side, float[] rgb) {
        lookUp(primitives, s, part, map, true, x, y, z, nx, ny, nz, side, rgb);
    }

    /** Writes the mean of an image alone, without vertex colors, as {@link #lookUp}. */
    public void lookUpMap(PrimitiveTable primitives, int s, int part, TextureMap map, double x, double y, double z, float nx, float ny,
            float nz, double side, float[] rgb) {
        lookUp(primitives, s, part, map, false, x, y, z, nx, ny, nz, side, rgb);
    }

    private void lookUp(PrimitiveTable primitives, int s, int part, @Nullable TextureMap map, boolean withVertexColors, double x, double y,
            double z, float nx, float ny, float nz, double side, float[] rgb) {
        // Two directions across the normal: the first also across the x axis, or across the z axis if the normal is near the x axis.
        boolean nearX = Math.abs(nx) > 0.75f;
        double ax = nearX ? -ny : 0;
        double ay = nearX ? nx : -nz;
        double az = nearX ? 0 : ny;
        double step = side / (SIDE * Math.sqrt(ax * ax + ay * ay + az * az));
        ax *= step;
        ay *= step;
        az *= step;
        double bx = ny * az - nz * ay;
        double by = nz * ax - nx * az;
        double bz = nx * ay - ny * ax;
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        Arrays.fill(rgb, 0);
        for (int cell = 0; cell < SIDE * SIDE; cell++) {
            double u = cell % SIDE - (SIDE - 1) / 2.0;
            double v = cell / SIDE - (SIDE - 1) / 2.0;
            double dx = u * ax + v * bx;
            double dy = u * ay + v * by;
            double dz = u * az + v * bz;
            double cellX = x + (m[i] * dx + m[i + 1] * dy + m[i + 2] * dz);
            double cellY = y + (m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz);
            double cellZ = z + (m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz);
            if (withVertexColors) {
                lookup.lookUp(primitives, s, part, map, cellX, cellY, cellZ, texel);
            } else {
                lookup.lookUpMap(primitives, s, part, requireNonNull(map), cellX, cellY, cellZ, texel);
            }
            for (int c = 0; c < 3; c++) {
                rgb[c] += SHARE * texel[c];
            }
        }
    }
}

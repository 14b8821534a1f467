package lightning.shading;

import lightning.scene.World;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;

/**
 * The third stage for one tile and level: sums the lights' contributions and closes the equation
 * over all rows. Holds scratch columns: one for each thread.
 *
 * <p>The sum over the lights is the tree of {@link LightingEquation#sum}. A light that lights no row
 * of the tile, or has no weight, adds +0 to sums that are never negative, so that leaving it out
 * changes no bit.
 */
public final class Composer {
    private static final int ROWS = LightLanes.ROWS;
    private static final float[] ONES = new float[ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    private final MaterialTable materials;
    private final SumRows[] sums = new SumRows[12];
    private final float[] red = new float[ROWS];
    private final float[] green = new float[ROWS];
    private final float[] blue = new float[ROWS];

    public Composer(MaterialTable materials) {
        this.materials = materials;
        for (int i = 0; i < sums.length; i++) {
            sums[i] = new SumRows();
        }
    }

    /** The colours of the rows composed last, linear, {@code float[1024]}. */
    public float[] red() {
        return red;
    }

    public float[] green() {
        return green;
    }

    public float[] blue() {
        return blue;
    }

    /**
     * Computes the colours of all rows.
     *
     * @param lamps    the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param mirrored Cr of the reflective rows: red, green and blue columns; unread where there are none
     */
    public void compose(HitRows rows, Lamp[] lamps, LightLayer[] layers, World world, float[][] mirrored) {
        SumRows sum = sum(rows.count, lamps, layers, 0, lamps.length, 0);
        for (int r = 0; r < rows.runs; r++) {
            closeRun(rows, r, sum, (float) world.ambience(), mirrored);
        }
    }

    private static boolean isActive(Lamp lamp, LightLayer layer) {
        return !lamp.isDark() && layer.lit() > 0;
    }

    /** The sum of lights {@code from … to}, or null where none of them adds anything. */
    private SumRows sum(int rows, Lamp[] lamps, LightLayer[] layers, int from, int to, int level) {
        if (to - from < 2) {
            if (from == to || !isActive(lamps[from], layers[from])) {
                return null;
            }
            SumRows own = sums[level];
            own.set(rows, lamps[from], layers[from], ONES);
            return own;
        }
        int middle = (from + to) >>> 1;
        SumRows left = sum(rows, lamps, layers, from, middle, level);
        if (left == null) {
            return sum(rows, lamps, layers, middle, to, level);
        }
        if (to - middle == 1) {
            if (isActive(lamps[middle], layers[middle])) {
                left.add(rows, lamps[middle], layers[middle], ONES);
            }
            return left;
        }
        SumRows right = sum(rows, lamps, layers, middle, to, level + 1);
        if (right != null) {
            left.add(rows, right);
        }
        return left;
    }

    private void closeRun(HitRows rows, int r, SumRows sum, float ambience, float[][] mirrored) {
        int m = rows.runMaterial[r];
        boolean textured = materials.isTextured(m);
        int from = rows.runStart(r);
        int to = rows.runEnd[r];
        close(from, to, m, 0, ambience, textured ? rows.diffuseRed : null, sum == null ? null : sum.diffuseRed,
                specular(sum, sum == null ? null : sum.specularRed), mirrored == null ? null : mirrored[0], red);
        close(from, to, m, 1, ambience, textured ? rows.diffuseGreen : null, sum == null ? null : sum.diffuseGreen,
                specular(sum, sum == null ? null : sum.specularGreen), mirrored == null ? null : mirrored[1], green);
        close(from, to, m, 2, ambience, textured ? rows.diffuseBlue : null, sum == null ? null : sum.diffuseBlue,
                specular(sum, sum == null ? null : sum.specularBlue), mirrored == null ? null : mirrored[2], blue);
    }

    private static float[] specular(SumRows sum, float[] column) {
        return sum == null || !sum.hasSpecular ? null : column;
    }

    /**
     * One channel of one run: {@link LightingEquation#color} with absent terms left out, which changes
     * no bit, because they would add +0 or multiply by 1.
     */
    private void close(int from, int to, int m, int channel, float ambience, float[] texture, float[] diffuse,
            float[] specular, float[] mirrored, float[] out) {
        float emitted = materials.ambient(m, channel) * ambience;
        float kd = materials.diffuse(m, channel);
        float ks = materials.specular(m, channel);
        float kr = materials.reflective(m, channel);
        if (diffuse == null) {
            java.util.Arrays.fill(out, from, to, emitted);
        } else if (texture == null) {
            for (int i = from; i < to; i++) {
                out[i] = emitted + kd * diffuse[i];
            }
        } else {
            for (int i = from; i < to; i++) {
                out[i] = emitted + texture[i] * diffuse[i];
            }
        }
        if (kr != 0) {
            float rest = 1 - kr;
            for (int i = from; i < to; i++) {
                out[i] = out[i] * rest;
            }
        }
        if (ks != 0 && specular != null) {
            for (int i = from; i < to; i++) {
                out[i] = out[i] + ks * specular[i];
            }
        }
        if (kr != 0) {
            for (int i = from; i < to; i++) {
                out[i] = out[i] + kr * mirrored[i];
            }
        }
    }
}

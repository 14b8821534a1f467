package lightning.render.gather.reflection;

import java.util.Arrays;
import lightning.render.gather.cell.Hash64;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.ray.FilmLight;
import lightning.render.lobe.RoughLobes;
import lightning.render.lobe.RoughLobes.Kind;

/**
 * Light of the sky in the parts of a point's lobes, each of which one ray stands for. A ray only tells whether its part sees the sky: what it
 * sees there is the mean over a regular grid of directions, the same in all copies of the point, so few rays leave no specks of small
 * bright lamps. Other points have a turned and shifted grid. Each direction sees the mean over its solid angle (J. Křivánek and M. Colbert,
 * Real-time Shading with Filtered Importance Sampling, 2008). Scratch memory of one thread.
 */
final class SkyParts {
    /** Directions along each side of the grid of a point, at least. */
    private static final int SIDE = 16;
    /** Share of the solid angle of a direction over which it sees the mean: the cells that are mixed reach beyond it. */
    private static final double SEEN_SHARE = 0.5;

    /** Least weight of a direction, so that a part has a mean where all its directions are below the surface. */
    private static final double LEAST = 1e-9;

    private final ReflectionPaths paths;
    private final FilmLight sky;
    private final int firstCell;
    private final int side;
    /** Directions along each side of a part. */
    private final int divisions;
    /** Places of the rows of the grid, 0…1, and how wide they are in widths of equal ones: the outer part of a lobe is divided more finely outward. */
    private final double[] place;
    private final double[] width;
    private final double[] cos;
    private final double[] sin;
    /** Turn and shift of the grid of the present point, by less than half a row or column. */
    private double turnCos;
    private double turnSin;
    private double shift;
    private final PointLobes lobes;
    private final int[] cell = new int[4];
    private final float[] share = new float[4];
    private final float[] radiance = new float[FilmLight.MAX_STRIDE];
    /** Sums of a part above the horizon, then below it; of what the reflectance multiplies, then of what no color multiplies. */
    private final float[][] sum = new float[4][FilmLight.MAX_STRIDE];
    private final double[] total = new double[4];
    /** Light of each part, in the same order. */
    private final FilmLight[] mean = new FilmLight[4];
    private final boolean[] isKnown;
    private final FilmLight met;

    /**
     * @param sky       light of the cells of the sky
     * @param firstCell number of the first of them
     */
    SkyParts(ReflectionPaths paths, FilmLight sky, int firstCell) {
        this.paths = paths;
        this.sky = sky;
        this.firstCell = firstCell;
        side = paths.side();
        divisions = Math.ceilDiv(SIDE, side);
        lobes = new PointLobes(side);
        place = new double[side * divisions];
        width = new double[side * divisions];
        for (int i = 0; i < place.length; i++) {
            double start = start(i);
            double end = start(i + 1);
            place[i] = (start + end) / 2;
            width[i] = (end - start) * place.length;
        }
        cos = new double[side * divisions];
        sin = new double[side * divisions];
        for (int i = 0; i < cos.length; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / cos.length;
            cos[i] = StrictMath.cos(angle);
            sin[i] = StrictMath.sin(angle);
        }
        isKnown = new boolean[side * side];
        met = FilmLight.black(sky.films(), paths.links().raysPerPoint());
        Arrays.setAll(mean, _ -> FilmLight.black(sky.films(), side * side));
    }

    /** Returns where a row begins. Those of the last part are half as wide as the one before. */
    private double start(int row) {
        int inner = (side - 1) * divisions;
        int rows = side * divisions;
        return row <= inner ? (double) row / rows : row == rows ? 1 : 1 - Math.scalb(1.0 / side, inner - row);
    }

    /** Moves to a point. */
    void moveTo(int p, RoughLobes material) {
        lobes.moveTo(paths.points(), p, material);
        long random = Hash64.mix(paths.origins().seed()[p]);
        double turn = 2 * Math.PI * ((random & 0xffffff) * 0x1p-24 - 0.5) / cos.length;
        turnCos = StrictMath.cos(turn);
        turnSin = StrictMath.sin(turn);
        shift = ((random >>> 24 & 0xffffff) * 0x1p-24 - 0.5) / place.length;
        Arrays.fill(isKnown, false);
    }

    private void find(int part) {
        isKnown[part] = true;
        Kind kind = lobes.kind(part);
        int values = 3 * sky.films();
        Arrays.fill(total, 0);
        for (float[] light : sum) {
            Arrays.fill(light, 0);
        }
        double directions = (double) lobes.rays(kind) * (divisions * divisions);
        for (int i = 0; i < divisions * divisions; i++) {
            int row = part / side * divisions + i / divisions;
            int column = part % side * divisions + i % divisions;
            lobes.scatter(kind, place[row] + shift * width[row], cos[column] * turnCos - sin[column] * turnSin,
                    sin[column] * turnCos + cos[column] * turnSin);
            see(SEEN_SHARE * width[row] / (directions * lobes.density));
            int first = lobes.d[1] < 0 ? 2 : 0;
            add(first, lobes.color * width[row] + LEAST, values);
            add(first + 1, lobes.white * width[row] + LEAST, values);
        }
        for (int i = 0; i < 4; i++) {
            // A part may see only one half of the sky in these directions, and a ray the other.
            int its = total[i] > 0 ? i : i ^ 2;
            float scale = total[its] > 0 ? (float) (1 / total[its]) : 0;
            int at = mean[i].at(part, 0);
            for (int v = 0; v < values; v++) {
                mean[i].values()[at + v] = sum[its][v] * scale;
            }
        }
    }

    private void add(int to, double weight, int values) {
        total[to] += weight;
        for (int v = 0; v < values; v++) {
            sum[to][v] += (float) weight * radiance[v];
        }
    }

    /** Computes what the present direction sees in each film. */
    private void see(double solidAngle) {
        SkyCells.mix(lobes.d[0], lobes.d[1], lobes.d[2], solidAngle, cell, share);
        int values = 3 * sky.films();
        Arrays.fill(radiance, 0, values, 0);
        for (int i = 0; i < 4; i++) {
            int at = sky.at(firstCell + cell[i], 0);
            for (int v = 0; v < values; v++) {
                radiance[v] += share[i] * sky.values()[at + v];
            }
        }
    }

    /** Returns room for what the rays of a point meet, by ray. */
    FilmLight met() {
        return met;
    }

    /**
     * Writes the light of a part to what its ray meets.
     *
     * @param part not one of a lobe that passes the surface
     * @param half 0 above the horizon, 1 below it
     * @param kind 0 for what the reflectance multiplies, 1 for what no color multiplies
     */
    void write(int part, int half, int kind) {
        if (!isKnown[part]) {
            find(part);
        }
        met.copy(mean[2 * half + kind], part, part);
    }
}

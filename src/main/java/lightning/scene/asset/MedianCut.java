package lightning.scene.asset;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.light.Light;

/**
 * Median cut of an environment map into regions of about equal energy, each represented by a directional light at its center (Debevec, A
 * Median Cut Algorithm for Light Probe Sampling, 2005). Unlike Debevec's method, which cuts all regions per step, it cuts the brightest
 * one, so that any number of regions is possible. Cuts a region across its longer side, where both halves have the most similar energy:
 * luminance times solid angle. The first cut is the horizon: a region on both sides of it would light floors too much or not at all. Large
 * maps are first summed in cells of several pixels; pixels of small maps are divided into several cells.
 */
final class MedianCut {
    private static final int MAX_COLUMNS = 256;
    private static final int MAX_ROWS = 128;
    private static final int MIN_COLUMNS = 32;
    private static final int MIN_ROWS = 16;
    private static final double ROUNDING = 1e-9;

    private final int columns;
    private final int rows;
    /** Red, green, blue times solid angle, and luminance, of each cell. */
    private final double[][] energy;
    /** Summed-area table of luminance over all cells to the left and above. */
    private final double[] sums;

    private record Region(int left, int top, int right, int bottom, double luminance) {
        boolean isSingleCell() {
            return right - left == 1 && bottom - top == 1;
        }
    }

    /** @param limit luminance of each pixel that is left out */
    MedianCut(EnvironmentMap sky, double limit) {
        columns = sky.width() > MAX_COLUMNS ? MAX_COLUMNS : sky.width() * Math.ceilDiv(MIN_COLUMNS, sky.width());
        int parts = Math.ceilDiv(MIN_ROWS, sky.height());
        // The horizon lies between two rows.
        rows = sky.height() > MAX_ROWS ? MAX_ROWS : sky.height() * (sky.height() * parts % 2 == 0 ? parts : parts + 1);
        energy = new double[4][columns * rows];
        // Each line is a part of one row and of one line of pixels; the same for columns.
        int lines = Math.max(rows, sky.height());
        int width = Math.max(columns, sky.width());
        for (int line = 0; line < lines; line++) {
            double angle = 2 * Math.PI / width * (StrictMath.cos(Math.PI * line / lines) - StrictMath.cos(Math.PI * (line + 1) / lines));
            int y = (int) ((long) line * sky.height() / lines);
            int row = (int) ((long) line * rows / lines) * columns;
            for (int i = 0; i < width; i++) {
                int cell = row + (int) ((long) i * columns / width);
                int x = (int) ((long) i * sky.width() / width);
                double share = limit == 0 ? 1 : 1 - sky.smoothShare(x, y, limit);
                for (int c = 0; share > 0 && c < 3; c++) {
                    energy[c][cell] += sky.channel(x, y, c) * share * angle;
                }
            }
        }
        sums = new double[(columns + 1) * (rows + 1)];
        for (int i = 0; i < columns * rows; i++) {
            energy[3][i] = 0.2126 * energy[0][i] + 0.7152 * energy[1][i] + 0.0722 * energy[2][i];
            int index = (i / columns + 1) * (columns + 1) + i % columns + 1;
            sums[index] = energy[3][i] + sums[index - 1] + sums[index - columns - 1] - sums[index - columns - 2];
        }
    }

    /**
     * Returns at most {@code maxLights} lights, fewer if fewer cells are bright.
     *
     * @param compact spread up to which a region is not divided, degrees
     */
    List<EnvironmentLight> lights(int maxLights, double compact) {
        List<Region> regions = new ArrayList<>();
        for (Region half : List.of(region(0, 0, columns, rows / 2), region(0, rows / 2, columns, rows))) {
            // Differences of sums leave roundings where there is no light.
            if (half.luminance > ROUNDING * sums[sums.length - 1]) {
                regions.add(half);
            }
        }
        if (regions.isEmpty()) {
            regions.add(region(0, 0, columns, rows));
        }
        List<EnvironmentLight> lights = new ArrayList<>();
        regions.forEach(region -> lights.add(light(region)));
        while (regions.size() < maxLights) {
            int brightest = -1;
            for (int i = 0; i < regions.size(); i++) {
                boolean better = brightest < 0 || regions.get(i).luminance > regions.get(brightest).luminance;
                boolean isDivisible = !regions.get(i).isSingleCell() && regions.get(i).luminance > 0
                        && lights.get(i).spread() >= compact;
                brightest = better && isDivisible ? i : brightest;
            }
            if (brightest < 0) {
                break;
            }
            split(regions, brightest);
            lights.set(brightest, light(regions.get(brightest)));
            lights.add(light(regions.getLast()));
        }
        return List.copyOf(lights);
    }

    private Region region(int left, int top, int right, int bottom) {
        int w = columns + 1;
        return new Region(left, top, right, bottom,
                sums[bottom * w + right] - sums[bottom * w + left] - sums[top * w + right] + sums[top * w + left]);
    }

    private void split(List<Region> parts, int index) {
        Region p = parts.get(index);
        double width = (p.right - p.left) * 2.0 / columns * StrictMath.sin(Math.PI * (p.top + p.bottom) / 2 / rows);
        boolean vertical = p.bottom - p.top == 1 || p.right - p.left > 1 && width >= (double) (p.bottom - p.top) / rows;
        Region first = null;
        Region second = null;
        for (int position = vertical ? p.left + 1 : p.top + 1; position < (vertical ? p.right : p.bottom); position++) {
            Region a = vertical ? region(p.left, p.top, position, p.bottom) : region(p.left, p.top, p.right, position);
            Region b = vertical ? region(position, p.top, p.right, p.bottom) : region(p.left, position, p.right, p.bottom);
            if (first == null || second == null || Math.abs(a.luminance - b.luminance) < Math.abs(first.luminance - second.luminance)) {
                first = a;
                second = b;
            }
        }
        parts.set(index, first);
        parts.add(second);
    }

    /** Returns the light at a region's center of energy; for a dark region, at the center of its cells. */
    private EnvironmentLight light(Region p) {
        double[] sum = new double[3];
        Vec3 weightedDirection = Vec3.ZERO;
        Vec3 middle = Vec3.ZERO;
        double total = 0;
        double cellSpread = 0;
        for (int y = p.top; y < p.bottom; y++) {
            double polar = Math.PI * (y + 0.5) / rows;
            double solidAngle = 2 * Math.PI / columns * (StrictMath.cos(Math.PI * y / rows) - StrictMath.cos(Math.PI * (y + 1) / rows));
            for (int x = p.left; x < p.right; x++) {
                double azimuth = 2 * Math.PI * ((x + 0.5) / columns - 0.5);
                Vec3 cell = new Vec3(StrictMath.sin(polar) * StrictMath.sin(azimuth), StrictMath.cos(polar),
                        -StrictMath.sin(polar) * StrictMath.cos(azimuth));
                middle = middle.plus(cell);
                weightedDirection = weightedDirection.plus(cell.times(energy[3][y * columns + x]));
                total += energy[3][y * columns + x];
                cellSpread += energy[3][y * columns + x] * solidAngle / (4 * Math.PI);
                for (int c = 0; c < 3; c++) {
                    sum[c] += energy[c][y * columns + x];
                }
            }
        }
        double meanLength = total > 0 ? weightedDirection.length() / total * (1 - cellSpread / total) : 0;
        Vec3 direction = direction(weightedDirection, middle);
        return new EnvironmentLight(direction, meanLength, total > 0 ? spread(meanLength) : 0, sum[0] / Math.PI, sum[1] / Math.PI,
                sum[2] / Math.PI);
    }

    /**
     * Returns the half-angle of the equivalent uniform cap. A uniform cap of half-angle a has a mean direction of length (1 + cos a) / 2,
     * the integral of cosines over its solid angle. A cell's solid angle is 2π(1 − cos a), so it shortens the mean by its share of 4π.
     *
     * @param length length of the mean direction, 0 … 1
     */
    private static double spread(double length) {
        return Math.toDegrees(StrictMath.acos(Math.clamp(2 * length - 1, 0, 1)));
    }

    private static Vec3 direction(Vec3 weightedDirection, Vec3 middle) {
        return weightedDirection.length() > 1e-30 ? weightedDirection.normalized() : middle.length() > 1e-6 ? middle.normalized() : Vec3.Y;
    }
}

package lightning.render.gather.point;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;

/**
 * Weighted means over neighboring gather points, which remove the noise of their rays. The weights are fixed, so the mean is linear in
 * the light. They are whole numbers up to 255, relative to the largest of each point.
 *
 * @param start first entry of each point, and the number of all entries
 */
public record PointFilter(int[] start, WeightedPoints neighbors) {
    /**
     * Creates a filter.
     *
     * @param point  neighbors of each point, ascending, each point itself included
     * @param weight their weights
     */
    public static PointFilter of(int[][] point, float[][] weight) {
        return of(point, weight, point.length);
    }

    /**
     * Creates a filter of the first of some points, as above.
     *
     * @param points number of all of them
     */
    public static PointFilter of(int[][] point, float[][] weight, int points) {
        int entries = 0;
        for (int[] neighbors : point) {
            entries = Math.addExact(entries, neighbors.length);
        }
        WeightedPoints.Builder builder = new WeightedPoints.Builder(points, entries);
        int[] start = new int[point.length + 1];
        for (int p = 0; p < point.length; p++) {
            float largest = 0;
            for (float w : weight[p]) {
                largest = Math.max(largest, w);
            }
            float scale = WeightedPoints.MAX_WEIGHT / largest;
            for (int i = 0; i < point[p].length; i++) {
                int w = WeightedPoints.whole(weight[p][i], scale);
                if (w > 0) {
                    builder.add(point[p][i], point[p][i], w);
                }
            }
            start[p + 1] = builder.entries();
        }
        return new PointFilter(start, builder.build());
    }

    /**
     * Writes the means of points {@code first … end − 1}.
     *
     * @param from light of each point
     * @param to   receives red, green and blue of each film
     */
    public void apply(FilmLight from, FilmKernel kernel, float[][][] to, int first, int end) {
        float[] sum = new float[FilmLight.MAX_STRIDE];
        int[] point = {};
        float[] weight = {};
        int table = neighbors.tableOf(start[first]);
        int tableEnd = neighbors.endEntry(table);
        int tablePoint = neighbors.firstPoint(table);
        int[] points = neighbors.points();
        for (int p = first; p < end; p++) {
            int entry = start[p];
            int count = start[p + 1] - entry;
            if (point.length < count) {
                point = new int[2 * count];
                weight = new float[2 * count];
            }
            int total = 0;
            for (int i = 0; i < count;) {
                while (entry + i >= tableEnd) {
                    tableEnd = neighbors.endEntry(++table);
                    tablePoint = neighbors.firstPoint(table);
                }
                for (int stop = Math.min(tableEnd - entry, count); i < stop; i++) {
                    int whole = neighbors.weight()[entry + i] & 0xFF;
                    point[i] = points[tablePoint + (neighbors.index()[entry + i] & 0xFF)];
                    weight[i] = whole * WeightedPoints.SCALE;
                    total += whole;
                }
            }
            float scale = 1 / (total * WeightedPoints.SCALE);
            kernel.weightedSum(from, point, weight, count, sum);
            for (int film = 0; film < to.length; film++) {
                for (int c = 0; c < 3; c++) {
                    to[film][c][p] = sum[3 * film + c] * scale;
                }
            }
        }
    }

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(start);
        neighbors.writeTo(out);
    }

    public static PointFilter readFrom(ColumnReader in) throws IOException {
        return new PointFilter(in.readInts(), WeightedPoints.readFrom(in));
    }

    public long bytes() {
        return 4L * start.length + neighbors.bytes();
    }
}

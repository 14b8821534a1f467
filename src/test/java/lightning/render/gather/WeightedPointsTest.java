package lightning.render.gather;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.ray.FilmLight;
import org.junit.jupiter.api.Test;

/** Tests weighted means over more points than a table holds. */
class WeightedPointsTest {
    private static final int POINTS = 2000;
    private static final float SCALE = 0x1p-24f;

    private final Random random = new Random(3);
    private final float[][] light = new float[3][POINTS];

    WeightedPointsTest() {
        for (float[] channel : light) {
            for (int p = 0; p < POINTS; p++) {
                channel[p] = random.nextFloat();
            }
        }
    }

    @Test
    void filterWithManyNeighbors_equalsPlainSum() {
        int[][] neighbors = new int[POINTS][];
        float[][] weights = new float[POINTS][];
        for (int p = 0; p < POINTS; p++) {
            neighbors[p] = random.ints(p % 100 == 0 ? 700 : 1 + p % 40, 0, POINTS).distinct().sorted().toArray();
            weights[p] = new float[neighbors[p].length];
            for (int i = 0; i < weights[p].length; i++) {
                weights[p][i] = (1 + random.nextInt(255)) / 255f;
            }
            weights[p][0] = 1;
        }
        float[] interleaved = new float[4 * POINTS];
        for (int i = 0; i < interleaved.length; i++) {
            interleaved[i] = i % 4 == 3 ? Float.NaN : light[i % 4][i / 4];
        }
        float[][] actual = new float[3][POINTS];
        PointFilter filter = PointFilter.of(neighbors, weights);
        for (int[] part : new int[][] {{1000, 1700}, {0, 1000}, {1700, POINTS}}) {
            filter.apply(new FilmLight(1, interleaved), Engines.LANES.sums(), new float[][][] {actual}, part[0], part[1]);
        }
        for (int p = 0; p < POINTS; p++) {
            int[] whole = new int[weights[p].length];
            for (int i = 0; i < whole.length; i++) {
                int rounded = Math.round(weights[p][i] * 255);
                // Smaller weights are left out.
                whole[i] = rounded < 4 ? 0 : rounded;
            }
            assertMean(actual, p, neighbors[p], whole);
        }
    }

    @Test
    void rowsWithManyPoints_equalPlainSum() {
        int rows = 1024;
        int[] points = random.ints(POINTS, 0, POINTS).distinct().toArray();
        short[] index = new short[8 * rows];
        byte[] weight = new byte[8 * rows];
        for (int row = 0; row < rows; row++) {
            int count = row % 9;
            int first = random.nextInt(points.length - 8);
            for (int i = 0; i < count; i++) {
                index[8 * row + i] = (short) (first + i);
                weight[8 * row + i] = (byte) (255 - i * 30);
            }
        }
        RowWeights weights = new RowWeights(null, points, index, weight, null);
        float[][] actual = new float[3][rows];
        weights.interpolate(new float[][][] {light}, Engines.LANES.sums(), new float[][][] {actual});
        for (int row = 0; row < rows; row++) {
            int count = row % 9;
            int[] near = new int[count];
            int[] whole = new int[count];
            for (int i = 0; i < count; i++) {
                near[i] = points[index[8 * row + i]];
                whole[i] = weight[8 * row + i] & 0xFF;
            }
            assertMean(actual, row, near, whole);
        }
        boolean[] marked = new boolean[POINTS];
        assertThat(weights.touches(marked)).isFalse();
        Arrays.fill(marked, true);
        assertThat(weights.touches(marked)).isTrue();
    }

    private void assertMean(float[][] actual, int at, int[] points, int[] weights) {
        float total = Arrays.stream(weights).sum() * SCALE;
        for (int c = 0; c < 3; c++) {
            float sum = 0;
            for (int i = 0; i < points.length; i++) {
                sum += weights[i] * SCALE * light[c][points[i]];
            }
            assertThat(actual[c][at]).isEqualTo(total == 0 ? 0 : sum * (1 / total));
        }
    }
}

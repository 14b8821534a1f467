package lightning.render.gather.reflection;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.ray.FilmLight;
import org.junit.jupiter.api.Test;

/** Filter of reflection points: where few neighbors reflect the same, points get copies. */
class ReflectionFilterTest {
    private static ReflectionFilter ofEqualNeighbors(int count) {
        float[] ones = new float[count];
        Arrays.fill(ones, 1);
        return new ReflectionFilter(new int[][] {IntStream.range(0, count).toArray()}, new float[][] {ones});
    }

    private static float[] white(int count) {
        float[] shares = new float[count];
        Arrays.fill(shares, 1);
        return shares;
    }

    @Test
    void pointThatReflectsLittle_hasFewerRays() {
        assertArrayEquals(new int[] {3}, ofEqualNeighbors(1).copies(new float[] {0.5f}));
        assertArrayEquals(new int[] {0}, ofEqualNeighbors(1).copies(new float[] {0.04f}));
    }

    @Test
    void lonelyPoint_hasAsManyRaysAsEightPoints() {
        assertArrayEquals(new int[] {7}, ofEqualNeighbors(1).copies(white(1)));
    }

    @Test
    void pointsWithManyNeighbors_haveNoCopies() {
        assertArrayEquals(new int[] {0}, ofEqualNeighbors(8).copies(white(8)));
    }

    @Test
    void pointWithThreeEqualNeighbors_getsTheSameNumberOfRays() {
        // Three times as many points: 3 · 3 ≥ 8.
        assertArrayEquals(new int[] {2}, ofEqualNeighbors(3).copies(white(3)));
    }

    @Test
    void filter_givesCopiesTheWeightOfTheirOriginal() {
        var filter = new ReflectionFilter(new int[][] {{0, 1}, {1}}, new float[][] {{1, 0.5f}, {1}});
        PointFilter points = filter.build(new int[] {0, 2});
        FilmLight light = FilmLight.black(1, 4);
        light.set(0, 0, 7, 0, 0);
        for (int p = 1; p < 4; p++) {
            light.set(p, 0, p, 0, 0);
        }
        float[][] mean = new float[3][2];
        points.apply(light, Engines.SCALAR.sums(), new float[][][] {mean}, 0, 2);
        // Point 1 and its copies, which are points 2 and 3, have half the weight of point 0 each.
        assertEquals((7 + 0.5 * (1 + 2 + 3)) / 2.5, mean[0][0], 0.01);
        assertEquals(2, mean[0][1], 1e-6);
    }
}

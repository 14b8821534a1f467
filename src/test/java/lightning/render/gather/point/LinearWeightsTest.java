package lightning.render.gather.point;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class LinearWeightsTest {
    private static final float[] UP = {0, 0, 1};

    @Test
    void pointsOnOneSideOnly_meanMovesNearlyToThePlace() {
        // Points at 1 and 2 with equal weights: their mean is 1.5 away. The damping of 2 % leaves a little of it.
        LinearWeights weights = along(new float[] {1, 1}, new float[] {1, 2});
        assertEquals(0, weights.weight(1), 1e-6);
        assertTrue(weights.weight(0) > 0);
    }

    @Test
    void symmetricPoints_keepTheirWeights() {
        LinearWeights weights = along(new float[] {0.25f, 1, 0.25f}, new float[] {-1, 0, 1});
        assertEquals(0.25f, weights.weight(0));
        assertEquals(1f, weights.weight(1));
        assertEquals(0.25f, weights.weight(2));
    }

    @Test
    void unevenPoints_reproduceALinearValueWithinTheDamping() {
        // By hand: m = 1·1 + 1·2 − 1·1 = 2, M = 1 + 4 + 1 = 6, λ = 0.12, so the factors are 1 − d / 3.06.
        LinearWeights weights = along(new float[] {1, 1, 1}, new float[] {1, 2, -1});
        assertEquals(1 - 1 / 3.06, weights.weight(0), 1e-6);
        assertEquals(1 - 2 / 3.06, weights.weight(1), 1e-6);
        assertEquals(1 + 1 / 3.06, weights.weight(2), 1e-6);
    }

    @Test
    void offsetAlongTheNormal_isIgnored() {
        LinearWeights weights = new LinearWeights();
        weights.start(0, 0, 1, 1);
        weights.add(1, 0, 0, 0.5f);
        weights.add(1, 0, 0, -0.1f);
        weights.adjust();
        assertEquals(1f, weights.weight(0));
        assertEquals(1f, weights.weight(1));
    }

    @Property
    void anyPoints_keepAFiniteWeightAboveZero(@ForAll long seed, @ForAll @IntRange(min = 1, max = 40) int count,
            @ForAll @FloatRange(min = -30, max = 30) float exponent) {
        LinearWeights weights = random(seed, count, (float) Math.pow(10, exponent), (float) Math.pow(10, exponent));
        assertTrue(weights.largest() > 0);
        for (int i = 0; i < count; i++) {
            assertTrue(weights.weight(i) >= 0 && Float.isFinite(weights.weight(i)));
        }
    }

    @Property
    void anyPoints_meanIsNotFartherFromThePlaceThanBefore(@ForAll long seed, @ForAll @IntRange(min = 2, max = 40) int count) {
        LinearWeights before = random(seed, count, 1, Float.NaN);
        LinearWeights after = random(seed, count, 1, 1);
        SplittableRandom random = new SplittableRandom(seed);
        double[] sums = new double[6];
        for (int i = 0; i < count; i++) {
            random.nextFloat();
            float x = random.nextFloat() - 0.3f;
            float y = random.nextFloat() - 0.3f;
            add(sums, 0, before.weight(i), x, y);
            add(sums, 3, after.weight(i), x, y);
        }
        assertTrue(distance(sums, 3) <= distance(sums, 0) + 1e-5);
    }

    private static void add(double[] sums, int at, double weight, double x, double y) {
        sums[at] += weight;
        sums[at + 1] += weight * x;
        sums[at + 2] += weight * y;
    }

    private static double distance(double[] sums, int at) {
        return Math.hypot(sums[at + 1], sums[at + 2]) / sums[at];
    }

    private static LinearWeights along(float[] weight, float[] x) {
        LinearWeights weights = new LinearWeights();
        weights.start(UP[0], UP[1], UP[2], 1);
        for (int i = 0; i < weight.length; i++) {
            weights.add(weight[i], x[i], 0, 0);
        }
        weights.adjust();
        return weights;
    }

    /** @param unit NaN leaves the weights as they are */
    private static LinearWeights random(long seed, int count, float size, float unit) {
        SplittableRandom random = new SplittableRandom(seed);
        LinearWeights weights = new LinearWeights();
        weights.start(UP[0], UP[1], UP[2], unit);
        for (int i = 0; i < count; i++) {
            float w = random.nextFloat() + 1e-6f;
            weights.add(w, (random.nextFloat() - 0.3f) * size, (random.nextFloat() - 0.3f) * size, 0);
        }
        weights.adjust();
        return weights;
    }
}

package lightning.render.gather.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that numbers of any size are stored, and that their values are added in the order of the rays. */
class RayNumbersTest {
    private static final int RAYS = 333;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 65_536, 65_537, 131_073, 262_145, 1 << 20, (1 << 20) + 1, (1 << 24) + 1})
    void numbersBelowLimit_areKept(int limit) {
        int[] expected = new Random(limit).ints(RAYS, 0, limit).toArray();
        expected[17] = limit - 1;
        RayNumbers numbers = numbers(expected, limit);
        for (int ray = 0; ray < RAYS; ray++) {
            assertThat(numbers.get(ray)).isEqualTo(expected[ray]);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 65_536, 65_537, 200_000, 300_000, 1_500_000})
    void sum_addsInOrder(int limit) {
        Random random = new Random(limit);
        int[] number = random.ints(RAYS, 0, limit).toArray();
        float[] values = new float[4 * limit];
        for (int i = 0; i < values.length; i++) {
            values[i] = random.nextFloat();
        }
        for (int[] range : new int[][] {{0, RAYS}, {16, 16}, {64, 64}, {5, 100}, {RAYS, 0}}) {
            float[] sum = new float[3];
            for (int ray = range[0]; ray < range[0] + range[1]; ray++) {
                for (int c = 0; c < 3; c++) {
                    sum[c] += values[4 * number[ray] + c];
                }
            }
            float[] actual = new float[3];
            numbers(number, limit).sum(range[0], range[1], values, actual);
            assertThat(actual).isEqualTo(sum);
        }
    }

    private static RayNumbers numbers(int[] number, int limit) {
        RayNumbers numbers = new RayNumbers(number.length, limit);
        for (int ray = 0; ray < number.length; ray++) {
            numbers.set(ray, number[ray]);
        }
        return numbers;
    }
}

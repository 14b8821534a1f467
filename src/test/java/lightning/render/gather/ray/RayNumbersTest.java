package lightning.render.gather.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that numbers of any size are stored, and read in the order of the rays. */
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
    void read_writesNumbersInOrder(int limit) {
        int[] number = new Random(limit).ints(RAYS, 0, limit).toArray();
        RayNumbers numbers = numbers(number, limit);
        for (int[] range : new int[][] {{0, RAYS}, {16, 16}, {64, 64}, {5, 100}, {RAYS, 0}}) {
            int[] read = new int[range[1]];
            numbers.read(range[0], range[1], read);
            assertThat(read).isEqualTo(Arrays.copyOfRange(number, range[0], range[0] + range[1]));
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

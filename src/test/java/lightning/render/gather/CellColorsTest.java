package lightning.render.gather;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CellColorsTest {
    /** Multiples of 1/4 and counts that are powers of two: the means are exact in floats. */
    @Test
    void means_doNotDependOnTheOrder() {
        CellColors colors = new CellColors();
        IntStream.range(0, 1 << 16).parallel().forEach(i -> colors.add(key(i >> 4), i % 4 * 0.25f, 1, i % 16 == 0 ? 1 : 0));
        for (int cell = 0; cell < 1 << 12; cell++) {
            assertThat(colors.mean(key(cell), 0)).isEqualTo(0.375f);
            assertThat(colors.mean(key(cell), 1)).isEqualTo(1);
            assertThat(colors.mean(key(cell), 2)).isEqualTo(0x1p-4f);
        }
    }

    private static long key(int cell) {
        return Hash64.mix(cell);
    }
}

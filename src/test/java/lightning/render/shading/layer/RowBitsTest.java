package lightning.render.shading.layer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.render.shading.TermKernel;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

/** Tests sets of rows, and the transposition of bit squares, words of rows and samples. */
class RowBitsTest {
    @Property
    void transpose_swapsRowsAndColumns(@ForAll @Size(RowBits.WIDTH) short[] words) {
        int[] square = new int[RowBits.WIDTH];
        Arrays.setAll(square, r -> words[r] & 0xFFFF);
        int[] turned = square.clone();

        RowBits.transpose(turned);

        for (int r = 0; r < RowBits.WIDTH; r++) {
            for (int c = 0; c < RowBits.WIDTH; c++) {
                assertThat(turned[c] >>> r & 1).isEqualTo(square[r] >>> c & 1);
            }
            assertThat(turned[r]).isBetween(0, 0xFFFF);
        }
    }

    @Test
    void addedRange_canFillTheSet() {
        int[] bits = RowBits.allocate();
        RowBits.add(bits, 0, TermKernel.MAX_ROWS);
        assertThat(RowBits.count(bits, TermKernel.MAX_ROWS)).isEqualTo(TermKernel.MAX_ROWS);
        RowBits.remove(bits, 1, TermKernel.MAX_ROWS);
        assertThat(RowBits.count(bits, TermKernel.MAX_ROWS)).isOne();
    }

    @Test
    void runs_areWholeWordsThatHaveRows() {
        int[] bits = RowBits.allocate();
        RowBits.add(bits, 1);
        RowBits.add(bits, RowBits.WIDTH + 3);
        RowBits.add(bits, 4 * RowBits.WIDTH);
        List<String> runs = new ArrayList<>();
        RowBits.forEachRun(bits, 6 * RowBits.WIDTH, (from, to) -> runs.add(from / RowBits.WIDTH + "-" + to / RowBits.WIDTH));
        assertThat(runs).containsExactly("0-2", "4-5");
    }
}

package lightning.render.shading.layer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

/** Tests the transposition of bit squares, words of rows and samples. */
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
}

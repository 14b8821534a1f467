package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class CoarseScalingTest {
    private static final int BLACK = 0xFF000000;
    private static final int WHITE = 0xFFFFFFFF;

    private static int[] smooth(int[] from, int fromWidth, int width) {
        int fromHeight = from.length / fromWidth;
        int height = width * fromHeight / fromWidth;
        int[] to = new int[width * height];
        CoarseScaling.smooth(from, fromWidth, fromHeight, to, width, height);
        return to;
    }

    @Test
    void equalPixels_stayEqual() {
        int[] color = new int[12];
        Arrays.fill(color, 0xFF123456);
        assertThat(smooth(color, 4, 100)).containsOnly(0xFF123456);
    }

    @Test
    void equalSize_isCopied() {
        int[] from = {BLACK, WHITE, 0xFF102030, 0xFF405060};
        assertThat(smooth(from, 2, 2)).isEqualTo(from);
    }

    @Test
    void betweenCenters_valuesIncreaseEvenly() {
        int[] line = new int[8];
        CoarseScaling.smooth(new int[] {BLACK, WHITE}, 2, 1, line, 8, 1);
        // The centers of the coarse pixels are at 2 and 6; pixel centers at 2.5, 3.5 … are 1/8, 3/8 … of the way between them.
        assertThat(Arrays.stream(line).map(v -> v & 0xFF)).containsExactly(0, 0, 32, 96, 159, 223, 255, 255);
        assertThat(Arrays.stream(line).map(v -> v >>> 24)).containsOnly(0xFF);
    }

    @Test
    void singlePixel_fillsPicture() {
        assertThat(smooth(new int[] {WHITE}, 1, 5)).containsOnly(WHITE);
    }

    @Test
    void repeat_addsNoColor() {
        int[] to = new int[16];
        CoarseScaling.repeat(new int[] {BLACK, WHITE, WHITE, BLACK}, 2, 2, to, 4, 4);
        assertThat(to).containsOnly(BLACK, WHITE).startsWith(BLACK, BLACK, WHITE, WHITE);
    }
}

package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ScopesTest {
    /** Left half: sRGB code 128 in red, otherwise black. Right half: white. */
    private static Film halves() {
        float[] rgb = new float[3 * 8 * 4];
        for (int i = 0; i < 32; i++) {
            boolean left = i % 8 < 4;
            rgb[3 * i] = left ? ViewTransform.linear(128) : 2;
            rgb[3 * i + 1] = left ? 0 : 2;
            rgb[3 * i + 2] = left ? 0 : 2;
        }
        return Film.ofScanlines(8, 4, rgb);
    }

    @Test
    void histogram_countsEveryPixelOnceInEachChannel() {
        Scopes scopes = Scopes.of(halves(), ViewTransform.DEFAULT);
        assertThat(scopes.histogram()[0][128]).isEqualTo(16);
        assertThat(scopes.histogram()[0][255]).isEqualTo(16);
        assertThat(scopes.histogram()[1][0]).isEqualTo(16);
        for (int[] channel : scopes.histogram()) {
            assertThat(Arrays.stream(channel).sum()).isEqualTo(32);
        }
        assertThat(scopes.pixelShare(255)).isEqualTo(0.5);
    }

    @Test
    void waveform_countsPerColumn() {
        Scopes scopes = Scopes.of(halves(), ViewTransform.DEFAULT);
        assertThat(scopes.columns()).isEqualTo(8);
        assertThat(scopes.waveform()[0][3 * 256 + 128]).isEqualTo(4);
        assertThat(scopes.waveform()[0][4 * 256 + 128]).isZero();
        assertThat(scopes.waveform()[2][4 * 256 + 255]).isEqualTo(4);
        int[] pixels = scopes.waveformPixels();
        // Code 128 is line 127 from the top.
        assertThat(pixels[127 * 8 + 3] >> 16 & 0xFF).isGreaterThan(0x50);
        assertThat(pixels[127 * 8 + 4]).isEqualTo(0xFF161616);
    }

    @Test
    void wideImage_mergesColumns() {
        Scopes scopes = Scopes.of(Film.black(1025, 3), ViewTransform.DEFAULT);
        assertThat(scopes.columns()).isEqualTo(512);
        assertThat(Arrays.stream(scopes.waveform()[1]).sum()).isEqualTo(3 * 1025);
    }

    /** One line of codes 20 to 59, three pixels of each, below 100 lines of code 200. */
    @Test
    void histogramImage_ignoresFlatBackgroundPeak() {
        int width = 120;
        float[] rgb = new float[3 * width * 101];
        Arrays.fill(rgb, ViewTransform.linear(200));
        for (int i = 0; i < 3 * width; i++) {
            rgb[i] = ViewTransform.linear(20 + i / 9);
        }
        int[] pixels = Scopes.of(Film.ofScanlines(width, 101, rgb), ViewTransform.DEFAULT).histogramPixels(10);
        assertThat(pixels[20]).isEqualTo(0xFFE6E6E6);
        assertThat(pixels[59]).isEqualTo(0xFFE6E6E6);
        assertThat(pixels[200]).isEqualTo(0xFFE6E6E6);
        assertThat(pixels[9 * 256 + 60]).isEqualTo(0xFF161616);
    }

    @Test
    void histogramImage_hasBarForEachCode() {
        int[] pixels = Scopes.of(halves(), ViewTransform.DEFAULT).histogramPixels(10);
        assertThat(pixels[128]).isEqualTo(0xFFE61616);
        assertThat(pixels[9 * 256 + 255]).isEqualTo(0xFFE6E6E6);
        assertThat(pixels[9 * 256 + 60]).isEqualTo(0xFF161616);
    }
}

package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Colors of files by their chromaticities. */
class ExrColorReaderTest {
    private static final List<Float> ACESCG = List.of(0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f);
    @TempDir
    private Path folder;

    private float[] read(List<Float> chromaticities, float... rgb) throws IOException {
        List<ExrChannel> channels = List.of(new ExrChannel("B", ExrType.FLOAT), new ExrChannel("G", ExrType.FLOAT),
                new ExrChannel("R", ExrType.FLOAT));
        var header = new ExrHeader(1, 1, channels, Map.of("chromaticities", new ExrAttribute.Chromaticities(chromaticities)));
        Path file = folder.resolve("a.exr");
        AtomicFile.of(file).writeRandomAccess(out -> {
            var writer = new ExrWriter(out, header);
            var chunk = new ExrChunk(header, 0);
            for (int c = 0; c < 3; c++) {
                chunk.put(2 - c, 0, 0, rgb[c]);
            }
            writer.writeChunk(0, chunk.compress());
            writer.finish();
        });
        float[] result = new float[3];
        try (var reader = new ExrReader(file)) {
            ExrColorReader.read(reader, (x, y, v) -> System.arraycopy(v, 0, result, 0, 3));
        }
        return result;
    }

    @Test
    void rec709_keepsEveryBit() throws IOException {
        assertThat(read(ExrAttribute.Chromaticities.REC_709.values(), 0.1f, 7e9f, -1e-30f)).containsExactly(0.1f, 7e9f, -1e-30f);
    }

    @Test
    void whiteOfAnotherSpace_becomesWhite() throws IOException {
        assertThat(read(ACESCG, 3, 3, 3)).containsExactly(new float[] {3, 3, 3}, within(2e-6f));
    }

    /** The columns of the well-known matrix from ACEScg to linear sRGB. */
    @Test
    void primariesOfAcesCg_areConverted() throws IOException {
        assertThat(read(ACESCG, 1, 0, 0)).containsExactly(new float[] {1.70505f, -0.13026f, -0.02400f}, within(2e-5f));
        assertThat(read(ACESCG, 0, 1, 0)).containsExactly(new float[] {-0.62179f, 1.14080f, -0.12897f}, within(2e-5f));
        assertThat(read(ACESCG, 0, 0, 1)).containsExactly(new float[] {-0.08326f, -0.01055f, 1.15297f}, within(2e-5f));
    }

    /** Rec. 709 with exchanged primaries: each color is the other one. */
    @Test
    void exchangedPrimaries_exchangeChannels() throws IOException {
        List<Float> exchanged = List.of(0.15f, 0.06f, 0.3f, 0.6f, 0.64f, 0.33f, 0.3127f, 0.329f);
        assertThat(read(exchanged, 1, 2, 3)).containsExactly(new float[] {3, 2, 1}, within(1e-5f));
    }

    @Test
    void infinitePixels_areNotLost() throws IOException {
        float infinite = Float.POSITIVE_INFINITY;
        for (float component : read(ACESCG, infinite, infinite, infinite)) {
            assertThat(component).isGreaterThan(1e38f);
        }
        float[] red = read(ACESCG, infinite, 0, 0);
        assertThat(red[0]).isEqualTo(infinite);
        assertThat(red[1]).isLessThan(-1e37f);
        assertThat(read(ACESCG, Float.NaN, 0, 0)).containsOnly(Float.NaN);
    }

    @Test
    void chromaticitiesWithoutSpace_areRejected() {
        assertThatIOException().isThrownBy(() -> read(List.of(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 1, 1, 1))
                .withMessageStartingWith("has chromaticities that are no color space");
    }
}

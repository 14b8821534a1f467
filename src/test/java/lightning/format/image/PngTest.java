package lightning.format.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.zip.CRC32;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import lightning.render.image.RandomFilms;
import lightning.render.image.ViewTransform;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PngTest {
    /** Decodes with another decoder: around tile edges, and beyond one batch of bands. */
    @Property(tries = 60)
    void everyPixel_isReadBack(@ForAll @IntRange(min = 1, max = 70) int width, @ForAll @IntRange(min = 1, max = 600) int height,
            @ForAll long seed) throws IOException {
        Film film = RandomFilms.anyCodes(width, height, seed);
        var image = ImageIO.read(new ByteArrayInputStream(encode(film, 8, 2)));
        assertThat(image.getRGB(0, 0, width, height, null, 0, width)).containsExactly(ViewTransform.DEFAULT.toPixels(film));
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void file_isEqualForAnyWorkerCount(int bits) throws IOException {
        Film film = smooth(130, 700);
        assertThat(encode(film, bits, 3)).isEqualTo(encode(film, bits, 1));
    }

    /** Java's inflater verifies the stream's checksum. */
    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void checksums_areCorrect(int bits) throws IOException {
        Film film = smooth(90, 650);
        ByteBuffer file = ByteBuffer.wrap(encode(film, bits, 2)).position(8);
        var compressed = new ByteArrayOutputStream();
        while (file.hasRemaining()) {
            byte[] content = new byte[file.getInt()];
            byte[] name = new byte[4];
            file.get(name).get(content);
            CRC32 crc = new CRC32();
            crc.update(name);
            crc.update(content);
            assertThat(file.getInt()).isEqualTo((int) crc.getValue());
            if (new String(name, StandardCharsets.US_ASCII).equals("IDAT")) {
                compressed.write(content);
            }
        }
        byte[] lines = new InflaterInputStream(new ByteArrayInputStream(compressed.toByteArray())).readAllBytes();
        assertThat(lines).hasSize(650 * (1 + 90 * 3 * bits / 8));
    }

    /** Each line is longer than deflate's window of 32 kB. */
    @Test
    void similarRows_compressWell() throws IOException {
        int width = 16_000;
        float[] rgb = new float[3 * width * 16];
        Random noise = new Random(1);
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i < 3 * width ? noise.nextFloat() : rgb[i - 3 * width];
        }
        assertThat(encode(Film.ofScanlines(width, 16, rgb), 8, 1)).hasSizeLessThan(rgb.length / 10);
    }

    private static Film smooth(int width, int height) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (0.5 + 0.5 * Math.sin(i * 0.001));
        }
        return Film.ofScanlines(width, height, rgb);
    }

    private static byte[] encode(Film film, int bits, int threads) throws IOException {
        var out = new ByteArrayOutputStream();
        try (WorkerPool workers = new WorkerPool(threads)) {
            Png.write(out, film, ViewTransform.DEFAULT, bits, workers);
        }
        return out.toByteArray();
    }
}

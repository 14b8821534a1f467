package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lightning.base.file.AtomicFile;
import lightning.sample.TryFolder;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** OpenEXR: round trips, files of another writer, and damaged files. */
class ExrTest {
    private static final List<ExrChannel> CHANNELS = List.of(new ExrChannel("Z", ExrType.FLOAT), new ExrChannel("id", ExrType.UINT),
            new ExrChannel("a.G", ExrType.HALF));
    /** Image of 2 × 17 pixels written by the OpenEXR library 3.4 with ZIP: R = x + 2y as float, A = y / 4 as half. */
    private static final String OPENEXR_SAMPLE =
            "di8xAQIAAABjaGFubmVscwBjaGxpc3QAJQAAAEEAAQAAAAAAAAABAAAAAQAAAFIAAgAAAAAAAAABAAAAAQAAAABjb21wcmVzc2lvbgBjb21wcm"
                    + "Vzc2lvbgABAAAAA2RhdGFXaW5kb3cAYm94MmkAEAAAAAAAAAAAAAAAAQAAABAAAABkaXNwbGF5V2luZG93AGJveDJpABAAAAAAAAAAAAAAAAEA"
                    + "AAAQAAAAbGluZU9yZGVyAGxpbmVPcmRlcgABAAAAAHBpeGVsQXNwZWN0UmF0aW8AZmxvYXQABAAAAAAAgD9zY3JlZW5XaW5kb3dDZW50ZXIAdj"
                    + "JmAAgAAAAAAAAAAAAAAHNjcmVlbldpbmRvd1dpZHRoAGZsb2F0AAQAAAAAAIA/dHlwZQBzdHJpbmcADQAAAHNjYW5saW5laW1hZ2UAVAEAAAAA"
                    + "AADxAQAAAAAAAAAAAACVAAAAeF49zK0SglAQhuGNRiKRaCRSlOPPOAQDkUg0UpxhHNRXk5FLIBq5Aw/NyCUQjVyCZ8vZ8MzO/nyCKxHVGu2iCY"
                    + "wtO520FXRln+tujGGK5kBvFjUSzOEPomlZIPGYfPUrS5C8L95QdqcQqdr6pTmfM0drbE3mvHBwNuyHdGjYOa9snTc2zjvGC6n3wdr7ZOX9AwvH"
                    + "WMIQAAAADAAAAABEAEQAAABCAAAEQg==";

    @TempDir
    private Path folder;

    @Property(tries = 30)
    void values_areReadAsWritten(@ForAll @IntRange(min = 1, max = 40) int width, @ForAll @IntRange(min = 1, max = 40) int height,
            @ForAll long seed, @ForAll boolean noise) throws IOException {
        float[][] values = values(width * height, seed, noise);
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("a.exr");
            write(file, width, height, values);
            float[][] result = new float[3][width * height];
            try (ExrReader reader = new ExrReader(file)) {
                assertThat(reader.header().texts()).containsEntry("who", "Ä");
                reader.read(List.of("Z", "id", "a.G"), (x, y, numbers) -> {
                    for (int c = 0; c < 3; c++) {
                        result[c][y * width + x] = numbers[c];
                    }
                });
            }
            for (int i = 0; i < width * height; i++) {
                assertThat(Float.floatToRawIntBits(result[0][i])).isEqualTo(Float.floatToRawIntBits(values[0][i]));
                assertThat(result[1][i]).isEqualTo(values[1][i]);
                assertThat(result[2][i]).isEqualTo(Float.float16ToFloat(Float.floatToFloat16(values[2][i])));
            }
        }
    }

    private static float[][] values(int count, long seed, boolean noise) {
        Random random = new Random(seed);
        float[][] values = new float[3][count];
        for (int i = 0; i < count; i++) {
            values[0][i] = noise ? Float.intBitsToFloat(random.nextInt() & 0xFF7FFFFF) : i / 7;
            values[1][i] = noise ? random.nextInt(1 << 24) : 3;
            values[2][i] = noise ? random.nextFloat() * 60_000 : 0.5f;
        }
        return values;
    }

    private static void write(Path file, int width, int height, float[][] values) throws IOException {
        ExrHeader header = new ExrHeader(width, height, CHANNELS, Map.of("who", new ExrAttribute.Text("Ä")));
        AtomicFile.of(file).writeRandomAccess(channel -> {
            ExrWriter writer = new ExrWriter(channel, header);
            // Written from the bottom up, as threads may do.
            for (int c = header.chunkCount() - 1; c >= 0; c--) {
                ExrChunk chunk = new ExrChunk(header, c);
                for (int i = c * ExrHeader.LINES_PER_CHUNK * width; i < (c * ExrHeader.LINES_PER_CHUNK + header.lineCount(c)) * width;
                        i++) {
                    for (int k = 0; k < 3; k++) {
                        chunk.put(header.channels().indexOf(CHANNELS.get(k)), i % width, i / width - c * ExrHeader.LINES_PER_CHUNK,
                                values[k][i]);
                    }
                }
                writer.writeChunk(c, chunk.compress());
            }
            writer.finish();
        });
    }

    @Test
    void fileFromOpenExrLibrary_isRead() throws IOException {
        Path file = Files.write(folder.resolve("library.exr"), Base64.getDecoder().decode(OPENEXR_SAMPLE));
        List<String> values = new ArrayList<>();
        try (ExrReader reader = new ExrReader(file)) {
            reader.read(List.of("R", "A"), (x, y, v) -> values.add(v[0] + " " + v[1]));
        }
        assertThat(values).hasSize(34).startsWith("0.0 0.0", "1.0 0.0", "2.0 0.25").endsWith("33.0 4.0");
    }

    @Test
    void tooLargeValue_becomesMaxHalf() {
        ExrHeader header = new ExrHeader(1, 1, List.of(new ExrChannel("R", ExrType.HALF)), Map.of());
        ExrChunk chunk = new ExrChunk(header, 0);
        chunk.put(0, 0, 0, 1e9f);
        float[] line = new float[1];
        chunk.readLine(0, 0, line);
        assertThat(line).containsExactly(65504);
    }

    @Test
    void longNames_setTheVersionFlag() throws IOException {
        Path file = folder.resolve("long.exr");
        ExrHeader header = new ExrHeader(1, 1, List.of(new ExrChannel("a".repeat(40), ExrType.FLOAT)), Map.of());
        AtomicFile.of(file).writeRandomAccess(channel -> {
            ExrWriter writer = new ExrWriter(channel, header);
            writer.writeChunk(0, new ExrChunk(header, 0).compress());
            writer.finish();
        });
        assertThat(Files.readAllBytes(file)[5]).isEqualTo((byte) 4);
        try (ExrReader reader = new ExrReader(file)) {
            assertThat(reader.header().channels().getFirst().name()).hasSize(40);
        }
    }

    @Test
    void otherFormat_isRejected() throws IOException {
        Path file = Files.write(folder.resolve("a.exr"), new byte[100]);
        assertThatIOException().isThrownBy(() -> new ExrReader(file).close()).withMessageContaining("is not an OpenEXR file");
    }

    /** Files with one changed or missing byte. */
    @Property(tries = 400)
    void damagedFile_isReadOrRejectedWithMessage(@ForAll long seed) throws IOException {
        Random random = new Random(seed);
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("a.exr");
            write(file, 5, 20, values(100, seed, random.nextBoolean()));
            byte[] bytes = Files.readAllBytes(file);
            for (int n = random.nextInt(4); n >= 0; n--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
            }
            Files.write(file, random.nextInt(4) == 0 ? java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes);
            try (ExrReader reader = new ExrReader(file)) {
                if (reader.header().width() < 1000 && reader.header().height() < 1000) {
                    reader.read(List.of("Z"), (x, y, v) -> {});
                }
            } catch (IOException e) {
                assertThat(e.getMessage()).matches("(has|is) .*");
            }
        }
    }
}

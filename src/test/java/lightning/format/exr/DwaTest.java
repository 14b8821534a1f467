package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.zip.DataFormatException;
import lightning.base.file.AtomicFile;
import lightning.sample.PythonPrograms;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Colors in DWA compression: the OpenEXR library's files, files that it reads, and their errors. */
class DwaTest {
    /** Error of written luminance, as the root of the mean square on the curve: the transform keeps it, so it is that of the steps. */
    private static final double LUMINANCE_ERROR = 45e-5 * Math.sqrt(squares(new int[] {16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26,
        58,
        60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62, 18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104,
        113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99}) / 64) / 10;
    /** The same of color differences, whose largest step is 99 / 17 of the smallest one. */
    private static final double DIFFERENCE_ERROR = 45e-5 * 99 / 17;
    /** Largest factor of a difference in a color. */
    private static final double DIFFERENCE_FACTOR = 1.8556;
    /** A half on the curve, and one of the color, are each rounded to 2⁻¹¹; values are below 8. */
    private static final double HALVES = 2 * 8 * 0x1p-11;

    /** Colors of all kinds, read back by the library as 32-bit floats. */
    private static final String WRITE = """
            import itertools, numpy as np, OpenEXR
            rng = np.random.default_rng(1)
            n = 0
            for compression, tiles, kind, (w, h) in itertools.product(["DWAA", "DWAB"], [None, (64, 32)], ["smooth", "noise", "black"],
                                                                      [(1, 1), (37, 45), (100, 300)]):
                y, x = np.mgrid[0:h, 0:w]
                base = {"smooth": np.sin(x * 0.1) + np.cos(y * 0.07) + 2, "noise": rng.random((h, w)) ** 4 * 50, "black": 0.0 * x}[kind]
                pixels = {"R": base.astype(np.float16), "G": (base * 0.5).astype(np.float16), "B": (base[::-1] * 2).astype(np.float16),
                          "A": np.minimum(base, 1).astype(np.float16), "key.R": base.astype(np.float32), "key.G": base.astype(np.float32),
                          "key.B": (base ** 2).astype(np.float32), "lone.R": base.astype(np.float16), "luma.Y": base.astype(np.float32),
                          "Z": base.astype(np.float32)}
                header = {"compression": getattr(OpenEXR, compression + "_COMPRESSION"),
                          "type": OpenEXR.tiledimage if tiles else OpenEXR.scanlineimage}
                if tiles:
                    header["tiles"] = OpenEXR.TileDescription()
                    header["tiles"].xSize, header["tiles"].ySize = tiles
                OpenEXR.File(header, pixels).write(f"{n}.exr")
                read = OpenEXR.File(f"{n}.exr", separate_channels=True).channels()
                open(f"{n}.words", "wb").write(b"".join(read[c].pixels.astype("<f4").tobytes() for c in sorted(pixels)))
                n += 1
            """;
    /** Prints all channels of a file as 32-bit floats. */
    private static final String READ = """
            import sys, OpenEXR
            read = OpenEXR.File("a.exr", separate_channels=True).channels()
            open("a.words", "wb").write(b"".join(read[c].pixels.astype("<f4").tobytes() for c in sorted(read)))
            """;

    @TempDir
    private Path folder;

    private static double squares(int[] steps) {
        double sum = 0;
        for (int step : steps) {
            sum += (double) step * step;
        }
        return sum;
    }

    /** Returns all values by channel, as the library and this reader order them. */
    private static float[] values(Path file) throws IOException {
        try (var reader = new ExrReader(file)) {
            List<String> names = reader.header().channels().stream().map(ExrChannel::name).toList();
            int width = reader.header().width();
            int pixels = width * reader.header().height();
            float[] values = new float[names.size() * pixels];
            reader.read(names, (x, y, v) -> {
                for (int c = 0; c < v.length; c++) {
                    values[c * pixels + y * width + x] = v[c];
                }
            });
            return values;
        }
    }

    private static float[] words(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        float[] values = new float[bytes.length / Float.BYTES];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(values);
        return values;
    }

    /** Returns the place of a color on the curve of the format. */
    private static double curve(double light) {
        return light <= 1 ? Math.pow(Math.max(light, 0), 1 / 2.2) : Math.log(light) / 2.2 + 1;
    }

    /**
     * Largest difference on the curve that the library's cosines cause: it writes π with six digits, which changes each by at most 7/16 of
     * 2.7e-6 in either direction. The 64 frequencies of a block of values below 8 add up to at most 64 · 8, of which each pixel gets a
     * quarter at most. A color adds a difference to the luminance.
     */
    private static final double LIBRARY_COSINES = 2 * 7.0 / 16 * 2.7e-6 * 64 * 8 / 4 * (1 + DIFFERENCE_FACTOR);

    /** Both readers compute in floats, so that two halves on the curve may differ, each by one step, and the color after them. */
    private static void assertClose(float[] read, float[] expected) {
        assertThat(read).hasSameSizeAs(expected);
        for (int i = 0; i < read.length; i++) {
            assertThat(curve(read[i])).as("value %d", i).isCloseTo(curve(expected[i]),
                    within(4 * 0x1p-11 * curve(expected[i]) + LIBRARY_COSINES));
        }
    }

    @Test
    void colorsOfOpenExrLibrary_areReadAsByIt() throws IOException {
        PythonPrograms.require("OpenEXR");
        PythonPrograms.script(folder, List.of("-c", WRITE));
        for (int n = 0; n < 36; n++) {
            assertClose(values(folder.resolve(n + ".exr")), words(folder.resolve(n + ".words")));
        }
    }

    /** Colors of halves, with channels that must not lose a bit. */
    private static final List<ExrChannel> CHANNELS = List.of(new ExrChannel("R", ExrType.HALF), new ExrChannel("G", ExrType.HALF),
            new ExrChannel("B", ExrType.HALF), new ExrChannel("A", ExrType.HALF), new ExrChannel("N.X", ExrType.HALF),
            new ExrChannel("CryptoObject00.R", ExrType.FLOAT), new ExrChannel("CryptoObject00.G", ExrType.FLOAT),
            new ExrChannel("CryptoObject00.B", ExrType.FLOAT), new ExrChannel("Z", ExrType.FLOAT), new ExrChannel("id", ExrType.UINT));

    private static boolean isColor(ExrChannel channel) {
        return channel.type() == ExrType.HALF && List.of("R", "G", "B").contains(channel.name());
    }

    private static float[] write(Path file, ExrHeader header, Random random) throws IOException {
        int pixels = header.width() * header.height();
        float[] values = new float[header.channels().size() * pixels];
        AtomicFile.of(file).writeRandomAccess(out -> {
            var writer = new ExrWriter(out, header);
            for (int chunk = 0; chunk < header.chunkCount(); chunk++) {
                var content = new ExrChunk(header, chunk);
                for (int c = 0; c < header.channels().size(); c++) {
                    for (int i = 0; i < header.lineCount(chunk) * header.width(); i++) {
                        int y = i / header.width();
                        int x = i % header.width();
                        float value = value(header.channels().get(c), x, y, random);
                        content.put(c, x, y, value);
                        values[c * pixels + chunk * header.compression().lines() * header.width() + i] = value;
                    }
                }
                writer.writeChunk(chunk, content.compress());
            }
            writer.finish();
        });
        return values;
    }

    private static float value(ExrChannel channel, int x, int y, Random random) {
        if (isColor(channel) || channel.type() == ExrType.HALF) {
            double wave = Math.sin(x * 0.2) + Math.cos(y * 0.13) + 2 + (x / 16 + y / 16) % 2 * 3 + random.nextDouble() * 0.2;
            return Float.float16ToFloat(Float.floatToFloat16((float) wave));
        }
        return channel.type() == ExrType.UINT ? random.nextInt(1 << 20) : Float.intBitsToFloat(random.nextInt(0x7F000000));
    }

    @Test
    void writtenFile_isReadByTheLibraryWithinTheErrorOfItsSteps() throws IOException {
        PythonPrograms.require("OpenEXR");
        for (int[] size : new int[][] {{1, 1}, {37, 45}, {100, 70}}) {
            var header = new ExrHeader(size[0], size[1], CHANNELS, Map.of(), ExrCompression.DWAA, new ExrWindow(0, 0, size[0], size[1]));
            float[] written = write(folder.resolve("a.exr"), header, new Random(3));
            PythonPrograms.script(folder, List.of("-c", READ));
            float[] library = words(folder.resolve("a.words"));
            assertClose(values(folder.resolve("a.exr")), library);
            int pixels = size[0] * size[1];
            // Blocks are larger than the picture, so that an error may gather in what is left of them.
            double share = Math.sqrt(Math.ceilDiv(size[0], 8) * 8.0 * Math.ceilDiv(size[1], 8) * 8 / pixels);
            for (int c = 0; c < CHANNELS.size(); c++) {
                double sum = 0;
                for (int i = c * pixels; i < (c + 1) * pixels; i++) {
                    if (isColor(header.channels().get(c))) {
                        double error = curve(library[i]) - curve(written[i]);
                        sum += error * error;
                    } else {
                        assertThat(Float.floatToRawIntBits(library[i])).isEqualTo(Float.floatToRawIntBits(written[i]));
                    }
                }
                assertThat(Math.sqrt(sum / pixels))
                        .isLessThanOrEqualTo((LUMINANCE_ERROR + DIFFERENCE_FACTOR * DIFFERENCE_ERROR) * share + HALVES);
            }
        }
    }

    @Test
    void equalColors_takeFewBytes() throws IOException {
        var header = new ExrHeader(512, 32, CHANNELS.subList(0, 3), Map.of(), ExrCompression.DWAA, new ExrWindow(0, 0, 512, 32));
        assertThat(new ExrChunk(header, 0).compress()).hasSizeLessThan(250);
    }

    /** Chunks with changed or missing bytes. */
    @Property
    void damagedChunk_isReadOrRejected(@ForAll @IntRange(max = 1 << 30) int seed) {
        var random = new Random(seed);
        var header = new ExrHeader(24, 20, CHANNELS, Map.of(), ExrCompression.DWAA, new ExrWindow(0, 0, 24, 20));
        var chunk = new ExrChunk(header, 0);
        for (int i = 0; i < 24 * 20; i++) {
            for (int c = 0; c < 5; c++) {
                chunk.put(c, i % 24, i / 24, random.nextInt(3));
            }
        }
        byte[] bytes = chunk.compress();
        for (int k = random.nextInt(4); k >= 0; k--) {
            // Most damage is in the numbers and the rules at the start.
            bytes[random.nextInt(random.nextBoolean() ? bytes.length : 120)] = (byte) random.nextInt();
        }
        try {
            assertThat(ExrCompression.DWAA.decompress(bytes, header.block(0))).hasSize((int) header.block(0).byteCount());
        } catch (DataFormatException e) {
            assertThat(e).isNotNull();
        }
    }

    @Test
    void rules_areReadAsWritten() throws DataFormatException {
        List<DwaRule> rules = new ArrayList<>(DwaRule.LEGACY);
        rules.addAll(DwaRule.WRITTEN);
        assertThat(DwaRule.read(ByteBuffer.wrap(DwaRule.encode(rules)).order(ByteOrder.LITTLE_ENDIAN))).isEqualTo(rules);
    }
}

package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of all compressions, in scan lines and tiles, written and read by the OpenEXR library. */
class ExrCompressionTest {
    /**
     * Writes each picture as a file, and what the library reads from it as 32-bit words: half bits, float bits, integers as floats.
     */
    private static final String WRITE =
            """
                    import itertools, numpy as np, OpenEXR
                    rng = np.random.default_rng(1)
                    def picture(kind, w, h):
                        y, x = np.mgrid[0:h, 0:w]
                        if kind == "noise":
                            f = rng.integers(0, 2**31 - 2**24, (h, w)).astype(np.uint32).view(np.float32)
                            return rng.integers(0, 31000, (h, w)).astype(np.uint16).view(np.float16), f, rng.integers(0, 2**32, (h, w), np.uint32)
                        s = np.sin(x * 0.1) + np.cos(y * 0.07) + 2
                        return (s * 0.3).astype(np.float16), (s * 100).astype(np.float32), (s * 1000).astype(np.uint32)
                    def flat(w, h):
                        return np.full((h, w), 0.5, np.float16), np.full((h, w), 7, np.float32), np.zeros((h, w), np.uint32)
                    n = 0
                    for compression, tiles, kind, (w, h) in itertools.product(
                            ["NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"], [None, (32, 16)], ["noise", "smooth", "flat"],
                            [(1, 1), (37, 45), (100, 70)]):
                        half, single, integer = flat(w, h) if kind == "flat" else picture(kind, w, h)
                        header = {"compression": getattr(OpenEXR, compression + "_COMPRESSION"),
                                  "type": OpenEXR.tiledimage if tiles else OpenEXR.scanlineimage}
                        if tiles:
                            d = OpenEXR.TileDescription()
                            d.xSize, d.ySize = tiles
                            header["tiles"] = d
                        name = f"{n}-{compression}-{kind}-{w}x{h}{'-tiled' if tiles else ''}"
                        n += 1
                        OpenEXR.File(header, {"h": half, "f": single, "u": integer}).write(name + ".exr")
                        channels = OpenEXR.File(name + ".exr", separate_channels=True).channels()
                        words = [channels["h"].pixels.view(np.uint16).astype("<u4"), channels["f"].pixels.view(np.uint32).astype("<u4"),
                                 channels["u"].pixels.astype(np.float32).view(np.uint32).astype("<u4")]
                        open(name + ".words", "wb").write(b"".join(np.ascontiguousarray(v).tobytes() for v in words))
                    print(n)
                    """;
    @TempDir
    private Path folder;

    private List<Path> files() throws IOException {
        PythonPrograms.require("OpenEXR");
        PythonPrograms.script(folder, List.of("-c", WRITE));
        try (var all = Files.list(folder)) {
            return all.filter(file -> file.toString().endsWith(".exr")).sorted().toList();
        }
    }

    @Test
    void pixelsOfOpenExrLibrary_areReadInEveryBit() throws IOException {
        List<Path> files = files();
        assertThat(files).hasSize(180);
        for (Path file : files) {
            byte[] expected = Files.readAllBytes(Path.of(file.toString().replace(".exr", ".words")));
            assertThat(words(file)).as(file.toString()).isEqualTo(expected);
        }
    }

    private static byte[] words(Path file) throws IOException {
        try (var reader = new ExrReader(file)) {
            int width = reader.header().width();
            int pixels = width * reader.header().height();
            ByteBuffer out = ByteBuffer.allocate(3 * pixels * Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);
            reader.read(List.of("h", "f", "u"), (x, y, v) -> {
                int at = Integer.BYTES * (y * width + x);
                out.putInt(at, Short.toUnsignedInt(Float.floatToFloat16(v[0])));
                out.putInt(at + Integer.BYTES * pixels, Float.floatToRawIntBits(v[1]));
                out.putInt(at + 2 * Integer.BYTES * pixels, Float.floatToRawIntBits(v[2]));
            });
            return out.array();
        }
    }

    /** Files with changed or missing bytes. */
    @Test
    void damagedFile_isReadOrRejectedWithMessage() throws IOException {
        var random = new Random(7);
        int rejected = 0;
        for (Path file : files()) {
            byte[] original = Files.readAllBytes(file);
            for (int n = 0; n < 20; n++) {
                byte[] bytes = random.nextInt(4) == 0 ? Arrays.copyOf(original, random.nextInt(original.length)) : original.clone();
                for (int k = random.nextInt(4); k >= 0 && bytes.length > 0; k--) {
                    bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
                }
                Path damaged = Files.write(folder.resolve("damaged"), bytes);
                try (var reader = new ExrReader(damaged)) {
                    long pixels = (long) reader.header().width() * reader.header().height();
                    assertThat(pixels).isLessThanOrEqualTo(bytes.length * reader.header().compression().maxRatio());
                    reader.read(List.of("f"), (x, y, v) -> {});
                } catch (IOException e) {
                    assertThat(e.getMessage()).matches("(has|is) .*");
                    rejected++;
                }
            }
        }
        assertThat(rejected).isGreaterThan(200);
    }
}

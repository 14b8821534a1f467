package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files with several parts, written by the OpenEXR library. */
class ExrPartsTest {
    /** Red is column / 8, green is row / 4, blue is 1; a smaller depth comes first, in a compression of its own, and normals last. */
    private static final String WRITE = """
            import numpy as np, OpenEXR
            y, x = np.mgrid[0:70, 0:90].astype(np.float32)
            def box(w, h):
                return np.array([0, 0], np.int32), np.array([w - 1, h - 1], np.int32)
            def header(name, compression, tiles=None):
                result = {"name": name, "compression": getattr(OpenEXR, compression + "_COMPRESSION"), "displayWindow": box(90, 70),
                          "type": OpenEXR.tiledimage if tiles else OpenEXR.scanlineimage}
                if tiles:
                    result["tiles"] = OpenEXR.TileDescription()
                    result["tiles"].xSize, result["tiles"].ySize = tiles
                return result
            def write(name, color, depth="ZIP", names="RGB", tiles=None):
                OpenEXR.File([
                    OpenEXR.Part(header("depth", depth) | {"dataWindow": box(40, 50)}, {"Z": np.zeros((50, 40), np.float16)}, "depth"),
                    OpenEXR.Part(header("beauty", color, tiles), dict(zip(names, (x / 8, y / 4, x * 0 + 1))), "beauty"),
                    OpenEXR.Part(header("normals", "ZIP"), {"R": x, "G": x, "B": x}, "normals")]).write(name + ".exr")
            write("lines", "ZIP")
            write("plain", "NO", depth="PIZ")
            write("tiles", "PIZ", depth="ZIPS", tiles=(32, 16))
            def make_unknown(name, part):
                data = open(name + ".exr", "rb").read()
                pieces = data.split(b"compression\\0compression\\0\\1\\0\\0\\0")
                pieces[part + 1] = bytes([11]) + pieces[part + 1][1:]
                open(name + ".exr", "wb").write(b"compression\\0compression\\0\\1\\0\\0\\0".join(pieces))
            write("other", "ZIP")
            make_unknown("other", 0)
            write("unreadable", "ZIP")
            make_unknown("unreadable", 1)
            write("names", "ZIP", names="XYZ")
            """;

    @TempDir
    private static Path folder;

    @BeforeAll
    static void writeFiles() throws IOException {
        PythonPrograms.require("OpenEXR");
        PythonPrograms.script(folder, List.of("-c", WRITE));
    }

    private static Path file(String name) {
        return folder.resolve(name + ".exr");
    }

    private static void assertColors(Path file) throws IOException {
        try (var reader = new ExrReader(file)) {
            assertThat(List.of(reader.header().width(), reader.header().height())).containsExactly(90, 70);
            int[] pixels = new int[1];
            reader.read(List.of("R", "G", "B"), (x, y, v) -> {
                assertThat(v).containsExactly(x / 8f, y / 4f, 1);
                pixels[0]++;
            });
            assertThat(pixels[0]).isEqualTo(90 * 70);
        }
    }

    @Test
    void firstPartWithColors_isRead() throws IOException {
        assertColors(file("lines"));
        assertColors(file("plain"));
    }

    @Test
    void partOfTiles_isRead() throws IOException {
        assertColors(file("tiles"));
    }

    @Test
    void unreadablePart_doesNotMatterBesideTheColors() throws IOException {
        assertColors(file("other"));
    }

    @Test
    void unreadablePartWithColors_isRejected() throws IOException {
        assertThatThrownBy(() -> new ExrReader(file("unreadable"))).isInstanceOf(IOException.class)
                .hasMessage("has compression HTJ2K32; expected none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA or DWAB");
    }

    @Test
    void withoutOtherColors_laterPartIsRead() throws IOException {
        try (var reader = new ExrReader(file("names"))) {
            reader.read(List.of("R", "G", "B"), (x, y, v) -> assertThat(v).containsExactly(x, x, x));
        }
    }

    @Test
    void deepFile_isRejected() throws IOException {
        byte[] bytes = Files.readAllBytes(file("lines"));
        bytes[5] = ExrHeader.DEEP_FLAG >> 8;
        Path file = Files.write(folder.resolve("deep.exr"), bytes);
        assertThatThrownBy(() -> new ExrReader(file)).hasMessage("has only deep pixels; expected scan lines or tiles");
    }

    /** Files with changed or missing bytes. */
    @Test
    void damagedFile_isReadOrRejectedWithMessage() throws IOException {
        var random = new Random(3);
        int rejected = 0;
        for (Path file : List.of(file("plain"), file("tiles"))) {
            byte[] original = Files.readAllBytes(file);
            for (int n = 0; n < 1000; n++) {
                byte[] bytes = random.nextInt(4) == 0 ? Arrays.copyOf(original, random.nextInt(original.length)) : original.clone();
                for (int k = random.nextInt(4); k >= 0 && bytes.length > 0; k--) {
                    bytes[random.nextInt(Math.min(bytes.length, 1500))] = (byte) random.nextInt();
                }
                Path damaged = Files.write(folder.resolve("damaged"), bytes);
                try (var reader = new ExrReader(damaged)) {
                    reader.read(List.of("R", "G", "B"), (x, y, v) -> {});
                } catch (IOException e) {
                    assertThat(e.getMessage()).matches("(has|is) .*");
                    rejected++;
                }
            }
        }
        assertThat(rejected).isGreaterThan(500);
    }
}

package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Display windows of pictures, and channels other than R, G and B. */
class ExrWindowTest {
    @TempDir
    private Path folder;

    /** Writes four pixels of values 1 to 4 with other windows: left, top, right and bottom. */
    private Path picture(int[] data, int[] display, String... channels) throws IOException {
        Path file = folder.resolve("a.exr");
        List<ExrChannel> all = Arrays.stream(channels).map(name -> new ExrChannel(name, ExrType.FLOAT)).toList();
        var header = new ExrHeader(2, 2, all, Map.of());
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            var writer = new ExrWriter(channel, header);
            var chunk = new ExrChunk(header, 0);
            for (int c = 0; c < channels.length; c++) {
                for (int i = 0; i < 4; i++) {
                    chunk.put(c, i % 2, i / 2, i + 1);
                }
            }
            writer.writeChunk(0, chunk.compress());
            writer.finish();
        }
        byte[] bytes = Files.readAllBytes(file);
        putWindow(bytes, "dataWindow", data);
        putWindow(bytes, "displayWindow", display);
        // The only chunk's first line is that of the data window.
        int chunk = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(ExrHeader.encode(List.of(header)).length);
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(chunk, data[1]);
        return Files.write(file, bytes);
    }

    private static void putWindow(byte[] file, String name, int[] window) {
        int at = new String(file, StandardCharsets.ISO_8859_1).indexOf(name + "\0box2i\0") + name.length() + 11;
        for (int v : window) {
            ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(at, v);
            at += 4;
        }
    }

    /** Returns the red values, line by line. */
    private static float[] red(Path file) throws IOException {
        try (var reader = new ExrReader(file)) {
            float[] values = new float[reader.header().width() * reader.header().height()];
            ExrColorReader.read(reader, (x, y, rgb) -> values[y * reader.header().width() + x] = rgb[0]);
            return values;
        }
    }

    @Test
    void crop_isSurroundedByBlack() throws IOException {
        assertThat(red(picture(new int[] {11, 20, 12, 21}, new int[] {10, 20, 12, 22}, "R", "G", "B")))
                .containsExactly(0, 1, 2, 0, 3, 4, 0, 0, 0);
    }

    @Test
    void overscan_isCut() throws IOException {
        assertThat(red(picture(new int[] {-1, -1, 0, 0}, new int[] {0, 0, 0, 0}, "R", "G", "B"))).containsExactly(4);
    }

    @Test
    void windowFarLargerThanItsData_isRejected() {
        assertThatThrownBy(() -> red(picture(new int[] {0, 0, 1, 1}, new int[] {0, 0, 9999, 9999}, "R", "G", "B")))
                .hasMessageStartingWith("has a display window of 10000×10000 pixels for data of 2×2");
    }

    @Test
    void luminanceAndLayers_areColors() throws IOException {
        int[] all = {0, 0, 1, 1};
        assertThat(red(picture(all, all, "A", "Y"))).containsExactly(1, 2, 3, 4);
        assertThat(red(picture(all, all, "left.R", "left.G", "left.B", "Z"))).containsExactly(1, 2, 3, 4);
        assertThatThrownBy(() -> red(picture(all, all, "A", "Z"))).hasMessage("has no channel 'R'");
    }
}

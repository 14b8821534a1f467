package lightning.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Header of an OpenEXR file, or of one of its parts (OpenEXR File Layout, openexr.com). All numbers are little-endian. Written files have scan lines
 * in increasing order, and ZIP compression in chunks of 16 lines.
 *
 * @param channels sorted by name, as the format requires
 * @param attributes additional attributes by name; a required one replaces its default. A header that was read has only texts
 *     and chromaticities
 */
public record ExrHeader(int width, int height, List<ExrChannel> channels, Map<String, ExrAttribute> attributes) {
    static final int MAGIC = 20000630;
    static final int VERSION = 2;
    /** Version flag that allows names longer than 31 bytes. */
    static final int LONG_NAMES_FLAG = 0x400;
    /** Version flag of a file of tiles. */
    static final int TILED_FLAG = 0x200;
    /** Version flag of a file with deep pixels: a list of values for each. */
    static final int DEEP_FLAG = 0x800;
    /** Version flag of a file with several parts. */
    static final int PARTS_FLAG = 0x1000;
    private static final int MAX_SHORT_NAME = 31;
    static final byte ZIP = 3;
    /** Width of the image at distance 1 from the camera; 1 if there is no camera. */
    public static final String SCREEN_WINDOW_WIDTH = "screenWindowWidth";
    public static final String SCREEN_WINDOW_CENTER = "screenWindowCenter";
    /** Scan lines per chunk. */
    public static final int LINES_PER_CHUNK = 16;

    public ExrHeader {
        channels = channels.stream().sorted(Comparator.comparing(ExrChannel::name)).toList();
    }

    /** Returns the text attributes by name. */
    public Map<String, String> texts() {
        Map<String, String> texts = new LinkedHashMap<>();
        attributes.forEach((name, value) -> {
            if (value instanceof ExrAttribute.Text text) {
                texts.put(name, text.value());
            }
        });
        return texts;
    }

    /** Returns the number of chunks. */
    public int chunkCount() {
        return Math.ceilDiv(height, LINES_PER_CHUNK);
    }

    /** Returns the number of lines of a chunk. */
    public int lineCount(int chunk) {
        return Math.min(LINES_PER_CHUNK, height - chunk * LINES_PER_CHUNK);
    }

    /** Returns the uncompressed bytes per line: all values of the first channel, then those of the next. */
    public long bytesPerLine() {
        return new ExrBlock(channels, width, 1).bytesPerLine();
    }

    /** Returns the layout of a written chunk. */
    ExrBlock block(int chunk) {
        return new ExrBlock(channels, width, lineCount(chunk));
    }

    /** Returns the header's bytes in the file. */
    byte[] encode() {
        var out = new ByteArrayOutputStream();
        boolean longNames = Stream.concat(channels.stream().map(ExrChannel::name), attributes.keySet().stream())
                .anyMatch(name -> name.length() > MAX_SHORT_NAME);
        out.writeBytes(encodeInts(MAGIC, longNames ? VERSION | LONG_NAMES_FLAG : VERSION));
        writeAttribute(out, "channels", "chlist", channelList());
        writeAttribute(out, "compression", "compression", new byte[] {ZIP});
        writeAttribute(out, "dataWindow", "box2i", encodeInts(0, 0, width - 1, height - 1));
        writeAttribute(out, "displayWindow", "box2i", encodeInts(0, 0, width - 1, height - 1));
        writeAttribute(out, "lineOrder", "lineOrder", new byte[] {0});
        writeAttribute(out, "pixelAspectRatio", "float", encodeInts(Float.floatToIntBits(1)));
        if (!attributes.containsKey(SCREEN_WINDOW_CENTER)) {
            writeAttribute(out, SCREEN_WINDOW_CENTER, "v2f", encodeInts(0, 0));
        }
        if (!attributes.containsKey(SCREEN_WINDOW_WIDTH)) {
            writeAttribute(out, SCREEN_WINDOW_WIDTH, "float", encodeInts(Float.floatToIntBits(1)));
        }
        // Sorted, so that equal images have equal bytes: some sources have maps of no order.
        new TreeMap<>(attributes).forEach((name, value) -> writeAttribute(out, name, value.type(), value.encode()));
        out.write(0);
        return out.toByteArray();
    }

    private byte[] channelList() {
        var out = new ByteArrayOutputStream();
        for (ExrChannel channel : channels) {
            writeText(out, channel.name());
            // The type, the perceptually-linear flag, then the sampling in x and y.
            out.writeBytes(encodeInts(channel.type().ordinal(), 0, 1, 1));
        }
        out.write(0);
        return out.toByteArray();
    }

    private static void writeAttribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
        writeText(out, name);
        writeText(out, type);
        out.writeBytes(encodeInts(value.length));
        out.writeBytes(value);
    }

    private static void writeText(ByteArrayOutputStream out, String text) {
        out.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
        out.write(0);
    }

    private static byte[] encodeInts(int... values) {
        ByteBuffer buffer = ByteBuffer.allocate(Integer.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            buffer.putInt(value);
        }
        return buffer.array();
    }
}

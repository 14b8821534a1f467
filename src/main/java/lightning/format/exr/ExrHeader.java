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
 * in increasing order.
 *
 * @param width of the data
 * @param height of the data
 * @param channels sorted by name, as the format requires
 * @param attributes additional attributes by name; a required one replaces its default. A header that was read has only texts
 *     and chromaticities
 * @param compression compression of its chunks
 * @param window what the picture shows of its data
 */
public record ExrHeader(int width, int height, List<ExrChannel> channels, Map<String, ExrAttribute> attributes, ExrCompression compression,
        ExrWindow window) {
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
    /** Width of the image at distance 1 from the camera; 1 if there is no camera. */
    public static final String SCREEN_WINDOW_WIDTH = "screenWindowWidth";
    public static final String SCREEN_WINDOW_CENTER = "screenWindowCenter";
    /** Attribute with the name of a part. */
    public static final String NAME = "name";
    /** Scan lines per chunk of a file with ZIP compression. */
    public static final int LINES_PER_CHUNK = 16;

    public ExrHeader {
        channels = channels.stream().sorted(Comparator.comparing(ExrChannel::name)).toList();
    }

    /** Creates the header of a whole picture with ZIP compression. */
    public ExrHeader(int width, int height, List<ExrChannel> channels, Map<String, ExrAttribute> attributes) {
        this(width, height, channels, attributes, ExrCompression.ZIP, new ExrWindow(0, 0, width, height));
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
        return Math.ceilDiv(height, compression.lines());
    }

    /** Returns the number of lines of a chunk. */
    public int lineCount(int chunk) {
        return Math.min(compression.lines(), height - chunk * compression.lines());
    }

    /** Returns the uncompressed bytes per line: all values of the first channel, then those of the next. */
    public long bytesPerLine() {
        return new ExrBlock(channels, width, 1).bytesPerLine();
    }

    /** Returns the layout of a written chunk. */
    ExrBlock block(int chunk) {
        return new ExrBlock(channels, width, lineCount(chunk));
    }

    /**
     * Returns the bytes of a file before its table of chunks.
     *
     * @param parts headers of its parts, at least one; each of several has an attribute {@link #NAME} of its own
     */
    static byte[] encode(List<ExrHeader> parts) {
        var out = new ByteArrayOutputStream();
        boolean longNames = parts.stream()
                .flatMap(part -> Stream.concat(part.channels.stream().map(ExrChannel::name), part.attributes.keySet().stream()))
                .anyMatch(name -> name.length() > MAX_SHORT_NAME);
        boolean hasParts = parts.size() > 1;
        out.writeBytes(encodeInts(MAGIC, VERSION | (longNames ? LONG_NAMES_FLAG : 0) | (hasParts ? PARTS_FLAG : 0)));
        for (ExrHeader part : parts) {
            part.encodeAttributes(out, hasParts);
        }
        if (hasParts) {
            out.write(0);
        }
        return out.toByteArray();
    }

    private void encodeAttributes(ByteArrayOutputStream out, boolean isPart) {
        writeAttribute(out, "channels", "chlist", channelList());
        if (isPart) {
            writeAttribute(out, "chunkCount", "int", encodeInts(chunkCount()));
        }
        writeAttribute(out, "compression", "compression", new byte[] {(byte) compression.code()});
        writeAttribute(out, "dataWindow", "box2i",
                encodeInts(window.left(), window.top(), window.left() + width - 1, window.top() + height - 1));
        writeAttribute(out, "displayWindow", "box2i", encodeInts(0, 0, window.width() - 1, window.height() - 1));
        writeAttribute(out, "lineOrder", "lineOrder", new byte[] {0});
        writeAttribute(out, "pixelAspectRatio", "float", encodeInts(Float.floatToIntBits(1)));
        if (!attributes.containsKey(SCREEN_WINDOW_CENTER)) {
            writeAttribute(out, SCREEN_WINDOW_CENTER, "v2f", encodeInts(0, 0));
        }
        if (!attributes.containsKey(SCREEN_WINDOW_WIDTH)) {
            writeAttribute(out, SCREEN_WINDOW_WIDTH, "float", encodeInts(Float.floatToIntBits(1)));
        }
        if (isPart) {
            writeAttribute(out, "type", "string", "scanlineimage".getBytes(StandardCharsets.US_ASCII));
        }
        // Sorted, so that equal images have equal bytes: some sources have maps of no order.
        new TreeMap<>(attributes).forEach((name, value) -> writeAttribute(out, name, value.type(), value.encode()));
        out.write(0);
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

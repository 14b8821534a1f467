package lightning.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/**
 * What stands before the numbers of a file: one part, lines from the top, compressed by ZIP in chunks of 16 lines (OpenEXR File
 * Layout, openexr.com). All is little-endian.
 *
 * @param channels sorted by name, as a file must have them
 * @param texts    more that is told of the picture, by name
 */
public record ExrHeader(int width, int height, List<ExrChannel> channels, Map<String, String> texts) {
    static final int MAGIC = 20000630;
    static final int VERSION = 2;
    /** The version's bit that allows names of more than 31 bytes. */
    static final int LONG_NAMES = 0x400;
    private static final int SHORT_NAME = 31;
    static final byte ZIP = 3;
    /** Lines of a chunk. */
    public static final int LINES = 16;

    public ExrHeader {
        channels = channels.stream().sorted(Comparator.comparing(ExrChannel::name)).toList();
    }

    /** How many chunks there are. */
    public int chunks() {
        return Math.ceilDiv(height, LINES);
    }

    /** How many lines a chunk has. */
    public int lines(int chunk) {
        return Math.min(LINES, height - chunk * LINES);
    }

    /** The bytes of a line, not compressed: first all numbers of the first channel, then of the next. */
    public long bytesPerLine() {
        return channels.stream().mapToLong(c -> (long) c.type().bytes() * width).sum();
    }

    /** Where each channel's numbers begin in a line. */
    int[] starts() {
        int[] starts = new int[channels.size()];
        for (int c = 1; c < starts.length; c++) {
            starts[c] = starts[c - 1] + channels.get(c - 1).type().bytes() * width;
        }
        return starts;
    }

    /** The header as a file has it. */
    byte[] bytes() {
        var out = new ByteArrayOutputStream();
        boolean longNames = channels.stream().anyMatch(c -> c.name().length() > SHORT_NAME);
        out.writeBytes(ints(MAGIC, longNames ? VERSION | LONG_NAMES : VERSION));
        attribute(out, "channels", "chlist", channelList());
        attribute(out, "compression", "compression", new byte[] {ZIP});
        attribute(out, "dataWindow", "box2i", ints(0, 0, width - 1, height - 1));
        attribute(out, "displayWindow", "box2i", ints(0, 0, width - 1, height - 1));
        attribute(out, "lineOrder", "lineOrder", new byte[] {0});
        attribute(out, "pixelAspectRatio", "float", ints(Float.floatToIntBits(1)));
        attribute(out, "screenWindowCenter", "v2f", ints(0, 0));
        attribute(out, "screenWindowWidth", "float", ints(Float.floatToIntBits(1)));
        texts.forEach((name, text) -> attribute(out, name, "string", text.getBytes(StandardCharsets.UTF_8)));
        out.write(0);
        return out.toByteArray();
    }

    private byte[] channelList() {
        var out = new ByteArrayOutputStream();
        for (ExrChannel channel : channels) {
            text(out, channel.name());
            // Its type, then whether it is to be seen as it is, then one number for each pixel across and down.
            out.writeBytes(ints(channel.type().ordinal(), 0, 1, 1));
        }
        out.write(0);
        return out.toByteArray();
    }

    private static void attribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
        text(out, name);
        text(out, type);
        out.writeBytes(ints(value.length));
        out.writeBytes(value);
    }

    private static void text(ByteArrayOutputStream out, String text) {
        out.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
        out.write(0);
    }

    private static byte[] ints(int... values) {
        ByteBuffer buffer = ByteBuffer.allocate(Integer.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            buffer.putInt(value);
        }
        return buffer.array();
    }
}

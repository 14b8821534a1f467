package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;

/** Reads the header of a file of one part with lines. */
final class HeaderReader {
    private static final int MOST_CHANNELS = 4096;
    private static final List<String> COMPRESSIONS = List.of("none", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB");

    private final ByteBuffer in;
    private int compression = -1;
    private int[] window;
    private List<ExrChannel> channels;
    private final Map<String, String> texts = new LinkedHashMap<>();

    /** @param in little-endian, the beginning of a file */
    HeaderReader(ByteBuffer in) {
        this.in = in;
    }

    /** What was read. */
    record Read(ExrHeader header, int compression, int top, int end) {}

    /**
     * Reads it.
     *
     * @throws EOFException if it does not end here
     * @throws IOException  if it is none, or that of a file of another kind
     */
    Read read() throws IOException {
        need(8);
        if (in.getInt() != ExrHeader.MAGIC) {
            throw new IOException("is no OpenEXR picture: its first four bytes are others");
        }
        int version = in.getInt();
        if ((version & ~ExrHeader.LONG_NAMES) != ExrHeader.VERSION) {
            throw new IOException("is an OpenEXR picture of tiles, parts or deep samples; expected one part with lines");
        }
        for (String name = text(); !name.isEmpty(); name = text()) {
            attribute(name, text());
        }
        if (channels == null || window == null || compression < 0) {
            throw new IOException("has a damaged OpenEXR header: expected channels, dataWindow and compression");
        }
        long width = (long) window[2] - window[0] + 1;
        long height = (long) window[3] - window[1] + 1;
        if (width < 1 || height < 1 || width > Integer.MAX_VALUE || height > Integer.MAX_VALUE) {
            throw new IOException("has a damaged OpenEXR header: its data window has no pixels");
        }
        return new Read(new ExrHeader((int) width, (int) height, channels, texts), compression, window[1], in.position());
    }

    private void attribute(String name, String type) throws IOException {
        need(Integer.BYTES);
        int size = in.getInt();
        if (size < 0) {
            throw new IOException("has a damaged OpenEXR header: attribute " + Quote.of(name) + " has " + size + " bytes");
        }
        need(size);
        int end = in.position() + size;
        switch (name + " " + type) {
            case "channels chlist" -> channels = channels(end);
            case "compression compression" -> compression = compression(size);
            case "dataWindow box2i" -> {
                if (size != 4 * Integer.BYTES) {
                    throw new IOException("has a damaged OpenEXR header: a data window must have 16 bytes, has " + size);
                }
                window = new int[] {in.getInt(), in.getInt(), in.getInt(), in.getInt()};
            }
            default -> {
                if (type.equals("string")) {
                    byte[] bytes = new byte[size];
                    in.get(bytes);
                    texts.put(name, new String(bytes, StandardCharsets.UTF_8));
                }
            }
        }
        in.position(end);
    }

    private int compression(int size) throws IOException {
        int code = size == 1 ? in.get() : -1;
        if (code != 0 && code != 2 && code != 3) {
            throw new IOException("is compressed as " + (code >= 0 && code < COMPRESSIONS.size() ? COMPRESSIONS.get(code) : "nobody knows")
                    + "; expected none, ZIPS or ZIP");
        }
        return code;
    }

    private List<ExrChannel> channels(int end) throws IOException {
        List<ExrChannel> read = new ArrayList<>();
        for (String name = text(); !name.isEmpty(); name = text()) {
            need(4 * Integer.BYTES);
            int type = in.getInt();
            in.getInt();
            int across = in.getInt();
            int down = in.getInt();
            if (type < 0 || type >= ExrType.values().length || across != 1 || down != 1 || read.size() == MOST_CHANNELS) {
                throw new IOException("has a channel " + Quote.of(name) + " that is not read: expected at most " + MOST_CHANNELS
                        + " channels of whole numbers, half or float, one for each pixel");
            }
            read.add(channel(name, ExrType.values()[type]));
        }
        if (in.position() != end || read.stream().map(ExrChannel::name).distinct().count() != read.size()) {
            throw new IOException("has a damaged OpenEXR header: its list of channels");
        }
        return read;
    }

    private static ExrChannel channel(String name, ExrType type) throws IOException {
        try {
            return new ExrChannel(name, type);
        } catch (IllegalArgumentException e) {
            throw new IOException("has a channel " + Quote.of(name) + "; expected a name of ASCII", e);
        }
    }

    private String text() throws IOException {
        int start = in.position();
        do {
            need(1);
        } while (in.get() != 0 && in.position() - start <= ExrChannel.LONGEST + 1);
        int length = in.position() - 1 - start;
        if (length > ExrChannel.LONGEST) {
            throw new IOException("has a damaged OpenEXR header: a name is longer than " + ExrChannel.LONGEST + " bytes");
        }
        byte[] bytes = new byte[length];
        in.get(start, bytes);
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private void need(int bytes) throws IOException {
        if (in.remaining() < bytes) {
            throw new EOFException("is cut short: its OpenEXR header has no end");
        }
    }
}

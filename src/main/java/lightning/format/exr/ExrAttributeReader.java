package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import org.jspecify.annotations.Nullable;

/** Reader for the attributes of one part of a file. What cannot be read counts only if the part is used. */
final class ExrAttributeReader {
    private static final int MAX_CHANNELS = 4096;
    private static final int CHROMATICITIES = 8;
    /** Names of later compressions, which cannot be read, from code 10 on. */
    private static final List<String> LATER_COMPRESSIONS = List.of("HTJ2K256", "HTJ2K32");
    private static final int FIRST_LATER = 10;

    private final ExrHeaderBytes in;
    private @Nullable ExrCompression compression;
    private int @Nullable [] tileSize;
    private int @Nullable [] dataWindow;
    /** Window that a picture shows; null if it says none. */
    private int @Nullable [] displayWindow;
    private @Nullable List<ExrChannel> channels;
    private final Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
    private int chunkCount = -1;
    /** Why the part's pixels cannot be read; null if they can. */
    private @Nullable IOException unsupported;

    /**
     * Creates a reader.
     *
     * @param in content of a file, at the start of the attributes
     */
    ExrAttributeReader(ExrHeaderBytes in) {
        this.in = in;
    }

    /**
     * Reads all attributes.
     *
     * @throws EOFException if the buffer ends within them
     * @throws IOException if they are damaged
     */
    void read() throws IOException {
        for (String name = in.readText(); !name.isEmpty(); name = in.readText()) {
            readAttribute(name, in.readText());
        }
    }

    /** Returns whether the part has channels with all of these names. */
    boolean hasChannels(List<String> names) {
        return channels != null && channels.stream().map(ExrChannel::name).toList().containsAll(names);
    }

    /** Returns the kind of a part of a file with several; empty if it says none. */
    String type() {
        return attributes.get("type") instanceof ExrAttribute.Text text ? text.value() : "";
    }

    /** Returns the number of chunks of a part of a file with several; −1 if it says none. */
    int chunkCount() {
        return chunkCount;
    }

    /**
     * Returns the part.
     *
     * @param isTiled true if it has tiles, false for scan lines
     * @param number number of the part in a file of several; −1 in others
     * @param tableOffset place of the table of its chunks, bytes
     * @throws IOException if an attribute is missing or wrong, or the pixels are of an unsupported kind
     */
    ExrPart part(boolean isTiled, int number, long tableOffset) throws IOException {
        if (unsupported != null) {
            throw unsupported;
        }
        if (channels == null || dataWindow == null || compression == null) {
            throw new IOException("has a damaged OpenEXR header: expected channels, dataWindow and compression");
        }
        long width = (long) dataWindow[2] - dataWindow[0] + 1;
        long height = (long) dataWindow[3] - dataWindow[1] + 1;
        if (width < 1 || height < 1 || width > Integer.MAX_VALUE || height > Integer.MAX_VALUE) {
            throw new IOException("has a damaged OpenEXR header: its data window has no pixels");
        }
        if (isTiled && tileSize == null) {
            throw new IOException("has a damaged OpenEXR header: expected the size of its tiles");
        }
        var header =
                new ExrHeader((int) width, (int) height, channels, attributes, compression, ExrWindow.of(dataWindow, displayWindow));
        return new ExrPart(header, dataWindow[1], isTiled ? tileSize : null, number, tableOffset);
    }

    private int[] readWindow(int size) throws IOException {
        if (size != 4 * Integer.BYTES) {
            throw new IOException("has a damaged OpenEXR header: a window must have 16 bytes, has " + size);
        }
        return new int[] {in.getInt(), in.getInt(), in.getInt(), in.getInt()};
    }

    private void readAttribute(String name, String type) throws IOException {
        int size = in.getInt();
        if (size < 0) {
            throw new IOException("has a damaged OpenEXR header: attribute " + Quote.of(name) + " has " + size + " bytes");
        }
        in.require(size);
        int end = in.position() + size;
        switch (name + " " + type) {
            case "channels chlist" -> channels = readChannels(end);
            case "compression compression" -> compression = readCompression(size);
            case "dataWindow box2i" -> dataWindow = readWindow(size);
            case "displayWindow box2i" -> displayWindow = readWindow(size);
            case "chunkCount int" -> chunkCount = in.getInt();
            case "tiles tiledesc" -> tileSize = readTileSize(size);
            case "chromaticities chromaticities" -> attributes.put(name, readChromaticities(size));
            default -> {
                if (type.equals("string")) {
                    attributes.put(name, new ExrAttribute.Text(new String(in.getBytes(size), StandardCharsets.UTF_8)));
                }
            }
        }
        in.moveTo(end);
    }

    private @Nullable ExrCompression readCompression(int size) throws IOException {
        int code = size == 1 ? in.getByte() : -1;
        Optional<ExrCompression> known = ExrCompression.of(code);
        if (known.isEmpty()) {
            String name = code >= FIRST_LATER && code < FIRST_LATER + LATER_COMPRESSIONS.size() ? LATER_COMPRESSIONS.get(code - FIRST_LATER)
                    : "unknown";
            unsupported = new IOException(
                    "has compression " + name + "; expected none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA or DWAB");
        }
        return known.orElse(null);
    }

    /** Reads the size of tiles. Smaller levels may follow the first one. */
    private int[] readTileSize(int size) throws IOException {
        if (size != 2 * Integer.BYTES + 1) {
            throw new IOException("has a damaged OpenEXR header: the description of tiles must have 9 bytes, has " + size);
        }
        int[] tile = {in.getInt(), in.getInt()};
        if (tile[0] < 1 || tile[1] < 1) {
            throw new IOException("has a damaged OpenEXR header: its tiles have no pixels");
        }
        return tile;
    }

    private ExrAttribute.Chromaticities readChromaticities(int size) throws IOException {
        if (size != CHROMATICITIES * Float.BYTES) {
            throw new IOException("has a damaged OpenEXR header: chromaticities must have 32 bytes, have " + size);
        }
        List<Float> values = new ArrayList<>();
        for (int i = 0; i < CHROMATICITIES; i++) {
            values.add(in.getFloat());
        }
        return new ExrAttribute.Chromaticities(List.copyOf(values));
    }

    private List<ExrChannel> readChannels(int end) throws IOException {
        List<ExrChannel> result = new ArrayList<>();
        for (String name = in.readText(); !name.isEmpty(); name = in.readText()) {
            int type = in.getInt();
            boolean isPerceptual = (in.getInt() & 0xFF) != 0;
            int xSampling = in.getInt();
            int ySampling = in.getInt();
            if (result.size() == MAX_CHANNELS || type < 0 || type >= ExrType.values().length) {
                throw unsupportedChannel(name);
            }
            if (xSampling != 1 || ySampling != 1) {
                unsupported = unsupportedChannel(name);
            }
            result.add(channel(name, ExrType.values()[type], isPerceptual));
        }
        if (in.position() != end || result.stream().map(ExrChannel::name).distinct().count() != result.size()) {
            throw new IOException("has a damaged OpenEXR header: its channel list");
        }
        return result;
    }

    private static IOException unsupportedChannel(String name) {
        return new IOException("has a channel " + Quote.of(name) + ", which is not supported: expected at most " + MAX_CHANNELS
                + " channels of type uint, half or float without subsampling");
    }

    private static ExrChannel channel(String name, ExrType type, boolean isPerceptual) throws IOException {
        try {
            return new ExrChannel(name, type, isPerceptual);
        } catch (RefusalException e) {
            throw new IOException("has a channel " + Quote.of(name) + "; expected an ASCII name", e);
        }
    }
}

package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/**
 * Reader for the header of a file of scan lines or tiles (OpenEXR File Layout, openexr.com). Of several parts, it chooses the first one with
 * colors.
 */
final class ExrHeaderReader {
    private static final String SCAN_LINES = "scanlineimage";
    private static final String TILES = "tiledimage";
    /** Maximum number of parts, so that a damaged file cannot request more. */
    private static final int MAX_PARTS = 4096;

    private final ExrHeaderBytes in;

    /**
     * Creates a reader.
     *
     * @param in little-endian start of a file
     */
    ExrHeaderReader(ByteBuffer in) {
        this.in = new ExrHeaderBytes(in);
    }

    /**
     * Reads the header.
     *
     * @throws EOFException if the buffer ends within the header
     * @throws IOException if it is not an OpenEXR header, or of an unsupported kind
     */
    ExrPart read() throws IOException {
        if (in.getInt() != ExrHeader.MAGIC) {
            throw new IOException("is not an OpenEXR file: wrong first four bytes");
        }
        int version = in.getInt();
        int flags = version & ~ExrHeader.LONG_NAMES_FLAG;
        return switch (flags) {
            case ExrHeader.VERSION, ExrHeader.VERSION | ExrHeader.TILED_FLAG -> {
                ExrAttributeReader only = readAttributes();
                yield only.part((flags & ExrHeader.TILED_FLAG) != 0, -1, in.position());
            }
            case ExrHeader.VERSION | ExrHeader.PARTS_FLAG, ExrHeader.VERSION | ExrHeader.PARTS_FLAG | ExrHeader.DEEP_FLAG -> choosePart();
            case ExrHeader.VERSION | ExrHeader.DEEP_FLAG -> throw onlyDeep();
            default ->
                    throw new IOException("has version " + (version & 0xff) + " of OpenEXR with flags " + Integer.toHexString(version >>> 8)
                            + ", which are not known; expected version 2");
        };
    }

    private ExrAttributeReader readAttributes() throws IOException {
        var attributes = new ExrAttributeReader(in);
        attributes.read();
        return attributes;
    }

    /** Reads the headers of all parts. Tables of chunks follow them, in the same order. */
    private ExrPart choosePart() throws IOException {
        List<ExrAttributeReader> parts = new ArrayList<>();
        while (!isEndOfParts()) {
            if (parts.size() == MAX_PARTS) {
                throw new IOException("has too many parts; expected at most " + MAX_PARTS);
            }
            parts.add(readAttributes());
        }
        List<ExrAttributeReader> flat = parts.stream().filter(part -> List.of(SCAN_LINES, TILES).contains(part.type())).toList();
        ExrAttributeReader chosen = flat.stream().filter(part -> part.hasChannels(ExrColorReader.COLORS)).findFirst()
                .or(() -> flat.stream().findFirst()).orElseThrow(ExrHeaderReader::onlyDeep);
        int number = parts.indexOf(chosen);
        long table = in.position();
        for (ExrAttributeReader part : parts.subList(0, number)) {
            if (part.chunkCount() < 0) {
                throw new IOException("has a damaged OpenEXR header: expected the number of chunks of each part");
            }
            table += (long) Long.BYTES * part.chunkCount();
        }
        return chosen.part(chosen.type().equals(TILES), number, table);
    }

    /** Skips the empty header after the last part; returns false if there is another part. */
    private boolean isEndOfParts() throws EOFException {
        if (in.peek() != 0) {
            return false;
        }
        in.getByte();
        return true;
    }

    private static IOException onlyDeep() {
        return new IOException("has only deep pixels; expected scan lines or tiles");
    }
}

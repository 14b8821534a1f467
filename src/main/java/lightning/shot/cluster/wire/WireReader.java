package lightning.shot.cluster.wire;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.UUID;
import lightning.base.file.ContentHash;

/** Reader of a message's bytes, with bounds checks. */
final class WireReader {
    private final ByteBuffer bytes;

    WireReader(byte[] message) {
        bytes = ByteBuffer.wrap(message);
    }

    int unsignedByte(String name) throws WireException {
        return require(name, Byte.BYTES).get() & 0xff;
    }

    boolean bool(String name) throws WireException {
        int offset = bytes.position();
        int value = unsignedByte(name);
        if (value > 1) {
            throw invalid(offset, name, "0 or 1", value);
        }
        return value == 1;
    }

    /** Reads a whole number from 0 to {@code max}. */
    int int32(String name, int max) throws WireException {
        int offset = bytes.position();
        int value = require(name, Integer.BYTES).getInt();
        if (value < 0 || value > max) {
            throw invalid(offset, name, "0 to " + max, value);
        }
        return value;
    }

    /** Reads a whole number from 0. */
    long int64(String name) throws WireException {
        int offset = bytes.position();
        long value = require(name, Long.BYTES).getLong();
        if (value < 0) {
            throw invalid(offset, name, "0 or more", value);
        }
        return value;
    }

    UUID uuid(String name) throws WireException {
        ByteBuffer from = require(name, 2 * Long.BYTES);
        return new UUID(from.getLong(), from.getLong());
    }

    ContentHash hash(String name) throws WireException {
        byte[] hash = new byte[ContentHash.BYTES];
        require(name, ContentHash.BYTES).get(hash);
        return ContentHash.ofBytes(hash);
    }

    /** Reads length-prefixed bytes; allocates only if they have arrived. */
    byte[] bytes(String name, int maxBytes) throws WireException {
        int length = int32("the length of " + name, maxBytes);
        ByteBuffer from = require(name, length);
        byte[] content = new byte[length];
        from.get(content);
        return content;
    }

    String text(String name, int maxBytes) throws WireException {
        int offset = bytes.position();
        byte[] content = bytes(name, maxBytes);
        try {
            return StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT).decode(ByteBuffer.wrap(content))
                    .toString();
        } catch (CharacterCodingException e) {
            throw new WireException("at byte " + offset + ": expected " + name + " in UTF-8, found other bytes");
        }
    }

    void requireEnd() throws WireException {
        if (bytes.hasRemaining()) {
            throw new WireException("at byte " + bytes.position() + ": expected the end of the message, found " + bytes.remaining()
                    + " more bytes");
        }
    }

    private ByteBuffer require(String name, int length) throws WireException {
        if (bytes.remaining() < length) {
            throw new WireException("at byte " + bytes.position() + ": expected " + name + " (" + length + " bytes), found "
                    + bytes.remaining() + " bytes");
        }
        return bytes;
    }

    static WireException invalid(int offset, String name, String expected, long found) {
        return new WireException("at byte " + offset + ": expected " + expected + " for " + name + ", found " + found);
    }
}

package lightning.shot.cluster.wire;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.UUID;

/** Reads a message's bytes from front to back; nothing is taken that is not there. */
final class WireSource {
    private final ByteBuffer bytes;

    WireSource(byte[] message) {
        bytes = ByteBuffer.wrap(message);
    }

    int octet(String what) throws WireException {
        return need(what, Byte.BYTES).get() & 0xff;
    }

    boolean flag(String what) throws WireException {
        int at = bytes.position();
        int value = octet(what);
        if (value > 1) {
            throw wrong(at, what, "0 or 1", value);
        }
        return value == 1;
    }

    /** A whole number from 0 to {@code most}. */
    int number(String what, int most) throws WireException {
        int at = bytes.position();
        int value = need(what, Integer.BYTES).getInt();
        if (value < 0 || value > most) {
            throw wrong(at, what, "0 to " + most, value);
        }
        return value;
    }

    /** A whole number from 0. */
    long large(String what) throws WireException {
        int at = bytes.position();
        long value = need(what, Long.BYTES).getLong();
        if (value < 0) {
            throw wrong(at, what, "0 or more", value);
        }
        return value;
    }

    UUID id(String what) throws WireException {
        ByteBuffer from = need(what, 2 * Long.BYTES);
        return new UUID(from.getLong(), from.getLong());
    }

    Hash hash(String what) throws WireException {
        byte[] hash = new byte[Hash.BYTES];
        need(what, Hash.BYTES).get(hash);
        return Hash.ofBytes(hash);
    }

    /** Bytes behind their number; memory is asked for once they are known to be there. */
    byte[] bytes(String what, int most) throws WireException {
        int length = number("the length of " + what, most);
        ByteBuffer from = need(what, length);
        byte[] content = new byte[length];
        from.get(content);
        return content;
    }

    String text(String what, int mostBytes) throws WireException {
        int at = bytes.position();
        byte[] content = bytes(what, mostBytes);
        try {
            return StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT).decode(ByteBuffer.wrap(content))
                    .toString();
        } catch (CharacterCodingException e) {
            throw new WireException("at byte " + at + ": expected " + what + " in UTF-8, found other bytes");
        }
    }

    void end() throws WireException {
        if (bytes.hasRemaining()) {
            throw new WireException("at byte " + bytes.position() + ": expected the end of the message, found " + bytes.remaining()
                    + " more bytes");
        }
    }

    private ByteBuffer need(String what, int length) throws WireException {
        if (bytes.remaining() < length) {
            throw new WireException("at byte " + bytes.position() + ": expected " + what + " (" + length + " bytes), found "
                    + bytes.remaining() + " bytes");
        }
        return bytes;
    }

    static WireException wrong(int at, String what, String expected, long found) {
        return new WireException("at byte " + at + ": expected " + expected + " for " + what + ", found " + found);
    }
}

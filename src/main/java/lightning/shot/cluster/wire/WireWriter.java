package lightning.shot.cluster.wire;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.UUID;

/** Writes a message's bytes, numbers with their highest byte first. */
final class WireWriter {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final DataOutputStream out = new DataOutputStream(bytes);

    private interface IoAction {
        void run() throws IOException;
    }

    private WireWriter write(IoAction step) {
        try {
            step.run();
            return this;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    WireWriter unsignedByte(int v) {
        return write(() -> out.writeByte(v));
    }

    WireWriter bool(boolean v) {
        return unsignedByte(v ? 1 : 0);
    }

    WireWriter int32(int v) {
        return write(() -> out.writeInt(v));
    }

    WireWriter int64(long v) {
        return write(() -> out.writeLong(v));
    }

    WireWriter uuid(UUID v) {
        return int64(v.getMostSignificantBits()).int64(v.getLeastSignificantBits());
    }

    WireWriter hash(ContentHash v) {
        return write(() -> out.write(v.bytes()));
    }

    WireWriter bytes(byte[] v) {
        return int32(v.length).write(() -> out.write(v));
    }

    /** Text of at most so many bytes; what is longer is cut. */
    WireWriter text(String v, int maxBytes) {
        // No character takes more than three bytes for each of its chars.
        String truncated = v.length() > maxBytes / 3 ? v.substring(0, maxBytes / 3) : v;
        return bytes(truncated.getBytes(StandardCharsets.UTF_8));
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}

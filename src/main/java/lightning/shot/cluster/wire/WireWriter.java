package lightning.shot.cluster.wire;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.UUID;
import lightning.base.file.ContentHash;

/** Big-endian writer of a message's bytes. */
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

    /** Writes text, truncated to a maximum of bytes. */
    WireWriter text(String v, int maxBytes) {
        // UTF-8 needs at most three bytes for each char.
        String truncated = v.length() > maxBytes / 3 ? v.substring(0, maxBytes / 3) : v;
        return bytes(truncated.getBytes(StandardCharsets.UTF_8));
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}

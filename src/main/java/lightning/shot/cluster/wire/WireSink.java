package lightning.shot.cluster.wire;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.UUID;

/** Writes a message's bytes, numbers with their highest byte first. */
final class WireSink {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final DataOutputStream out = new DataOutputStream(bytes);

    private interface Step {
        void run() throws IOException;
    }

    private WireSink put(Step step) {
        try {
            step.run();
            return this;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    WireSink octet(int v) {
        return put(() -> out.writeByte(v));
    }

    WireSink flag(boolean v) {
        return octet(v ? 1 : 0);
    }

    WireSink number(int v) {
        return put(() -> out.writeInt(v));
    }

    WireSink large(long v) {
        return put(() -> out.writeLong(v));
    }

    WireSink id(UUID v) {
        return large(v.getMostSignificantBits()).large(v.getLeastSignificantBits());
    }

    WireSink hash(Hash v) {
        return put(() -> out.write(v.bytes()));
    }

    WireSink bytes(byte[] v) {
        return number(v.length).put(() -> out.write(v));
    }

    /** Text of at most so many bytes; what is longer is cut. */
    WireSink text(String v, int mostBytes) {
        // No character takes more than three bytes for each of its chars.
        String shown = v.length() > mostBytes / 3 ? v.substring(0, mostBytes / 3) : v;
        return bytes(shown.getBytes(StandardCharsets.UTF_8));
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}

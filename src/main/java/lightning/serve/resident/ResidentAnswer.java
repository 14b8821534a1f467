package lightning.serve.resident;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/** A part of the answer of the resident process. */
sealed interface ResidentAnswer {
    /** Most bytes of one part. */
    int MAX_BYTES = 1 << 16;

    /** Bytes for the standard output, or for the standard error. */
    record Text(boolean error, byte[] bytes) implements ResidentAnswer {}

    /** Exit code of the command; the last part. */
    record Exit(int code) implements ResidentAnswer {}

    /** It runs another command; the only part. */
    record Busy() implements ResidentAnswer {}

    /** Reads the next part. */
    static ResidentAnswer read(DataInputStream in) throws IOException {
        byte kind = in.readByte();
        return switch (kind) {
            case 'x' -> new Exit(in.readInt());
            case 'b' -> new Busy();
            case 'o', 'e' -> {
                int length = in.readInt();
                if (length < 0 || length > MAX_BYTES) {
                    throw new IOException("expected at most " + MAX_BYTES + " bytes, found " + length);
                }
                yield new Text(kind == 'e', in.readNBytes(length));
            }
            default -> throw new IOException("unknown answer " + kind);
        };
    }

    /** Writes a part at once. Thread-safe for one stream. */
    static void write(DataOutputStream out, ResidentAnswer answer) throws IOException {
        synchronized (out) {
            switch (answer) {
                case Text(boolean error, byte[] bytes) -> {
                    out.writeByte(error ? 'e' : 'o');
                    out.writeInt(bytes.length);
                    out.write(bytes);
                }
                case Exit(int code) -> {
                    out.writeByte('x');
                    out.writeInt(code);
                }
                case Busy() -> out.writeByte('b');
            }
            out.flush();
        }
    }

    /** Returns a stream whose bytes become parts of the answer. */
    static OutputStream stream(DataOutputStream out, boolean error) {
        return new OutputStream() {
            @Override
            public void write(int value) throws IOException {
                write(new byte[] {(byte) value}, 0, 1);
            }

            @Override
            public void write(byte[] bytes, int offset, int length) throws IOException {
                for (int start = offset; start < offset + length; start += MAX_BYTES) {
                    byte[] part = new byte[Math.min(MAX_BYTES, offset + length - start)];
                    System.arraycopy(bytes, start, part, 0, part.length);
                    ResidentAnswer.write(out, new Text(error, part));
                }
            }
        };
    }
}

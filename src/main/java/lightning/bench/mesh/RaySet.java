package lightning.bench.mesh;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Many rays of one kind, as floats, so that every program traces the very same.
 *
 * @param kind   what they are
 * @param count  how many, a multiple of {@link #PACKET}; rays that go together are beside each other
 * @param columns x, y, z of origins, then of directions: {@code float[6][count]}; not to be written
 */
public record RaySet(Kind kind, int count, float[][] columns) {
    /** As many rays as go together in the narrowest form that programs trace. */
    public static final int PACKET = 16;

    /** Kinds of rays. */
    public enum Kind {
        /** From one point through a picture, in squares of 8×8 pixels that are four squares of 4×4. */
        EYE("eye"),
        /** From what the eye sees to a lamp, which is at distance 1: only whether anything is between. */
        SHADOW("shadow"),
        /** From what the eye sees, mirrored there. */
        MIRRORED("mirrored"),
        /** From what the eye sees in all directions, each ray by itself. */
        SINGLE("single");

        private final String label;

        Kind(String label) {
            this.label = label;
        }

        /** The word of tables. */
        public String label() {
            return label;
        }
    }

    /** Writes the number of rays and the columns, little endian. */
    void write(Path file) throws IOException {
        try (FileChannel to = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
                StandardOpenOption.TRUNCATE_EXISTING)) {
            to.write(ByteBuffer.allocate(Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN).putInt(count).flip());
            for (float[] c : columns) {
                ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
                bytes.asFloatBuffer().put(c, 0, count);
                while (bytes.hasRemaining()) {
                    to.write(bytes);
                }
            }
        }
    }
}

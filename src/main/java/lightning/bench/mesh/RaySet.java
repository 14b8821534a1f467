package lightning.bench.mesh;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Set of rays of one kind as floats, so that every program traces exactly the same rays.
 *
 * @param kind    kind of rays
 * @param count   number of rays, a multiple of {@link #PACKET}; coherent rays are adjacent
 * @param columns x, y, z of origins, then of directions: {@code float[6][count]}; read-only
 */
public record RaySet(Kind kind, int count, float[][] columns) {
    /** Number of rays per packet, the smallest packet size of all programs. */
    public static final int PACKET = 16;

    /** Kinds of rays. */
    public enum Kind {
        /** Rays from one point through an image, in squares of 8×8 pixels, each four squares of 4×4. */
        EYE("eye"),
        /** Occlusion rays from the eye's hits to a lamp at distance 1. */
        SHADOW("shadow"),
        /** Eye rays mirrored at their hits. */
        MIRRORED("mirrored"),
        /** Incoherent rays from the eye's hits in all directions. */
        SINGLE("single");

        private final String label;

        Kind(String label) {
            this.label = label;
        }

        /** Returns the label for tables. */
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

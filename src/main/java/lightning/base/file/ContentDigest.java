package lightning.base.file;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import org.jspecify.annotations.Nullable;

/** Hashes numbers and texts in memory. Each array is preceded by its length, so different sequences have different hashes. */
public final class ContentDigest {
    private static final int BUFFER = 1 << 16;

    private final MessageDigest digest = ContentHash.digest();
    private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER);

    /** Decoded content of a file, which may be large. */
    public interface Content {
        /** Adds all numbers that determine it. */
        void addTo(ContentDigest digest);
    }

    /** Returns the hash of a content. */
    public static ContentHash hash(Content content) {
        var digest = new ContentDigest();
        content.addTo(digest);
        return digest.hash();
    }

    public void add(int v) {
        require(Integer.BYTES).putInt(v);
    }

    public void add(double v) {
        require(Double.BYTES).putDouble(v);
    }

    public void add(String v) {
        add(v.getBytes(StandardCharsets.UTF_8));
    }

    public void add(byte @Nullable [] values) {
        add(values == null ? -1 : values.length);
        for (int i = 0, n; values != null && i < values.length; i += n) {
            n = Math.min(values.length - i, require(1).remaining());
            buffer.put(values, i, n);
        }
    }

    public void add(int @Nullable [] values) {
        add(values == null ? -1 : values.length);
        for (int i = 0, n; values != null && i < values.length; i += n) {
            n = Math.min(values.length - i, require(Integer.BYTES).remaining() / Integer.BYTES);
            buffer.asIntBuffer().put(values, i, n);
            buffer.position(buffer.position() + n * Integer.BYTES);
        }
    }

    public void add(float @Nullable [] values) {
        add(values == null ? -1 : values.length);
        for (int i = 0, n; values != null && i < values.length; i += n) {
            n = Math.min(values.length - i, require(Float.BYTES).remaining() / Float.BYTES);
            buffer.asFloatBuffer().put(values, i, n);
            buffer.position(buffer.position() + n * Float.BYTES);
        }
    }

    public void add(double[] values) {
        add(values.length);
        for (double v : values) {
            add(v);
        }
    }

    private ByteBuffer require(int bytes) {
        if (buffer.remaining() < bytes) {
            flush();
        }
        return buffer;
    }

    private void flush() {
        digest.update(buffer.flip());
        buffer.clear();
    }

    /** Returns the hash of all that was added, and starts again. */
    public ContentHash hash() {
        flush();
        return ContentHash.ofBytes(digest.digest());
    }
}

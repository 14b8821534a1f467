package lightning.render.trace.primitive;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.mesh.MeshSolid;
import org.jspecify.annotations.Nullable;

/**
 * Light buffers of an area light's sample points, for some meshes. Each is built for all threads by the one that requests it often
 * enough to pay off. Thread-safe.
 */
public final class LightBuffers {
    /** Maximum bytes of the buffers of one light. */
    private static final long MAX_BYTES = 32L << 20;
    /** Number of requests for which a buffer is built, relative to the leaves of its mesh. */
    private static final double REQUESTS_PER_LEAF = 1.0 / 16;

    private final PrimitiveTable primitives;
    /** Primitives with a mesh, ascending. */
    private final int[] meshes;
    private final double[] x;
    private final double[] y;
    private final double[] z;
    /** Buffer and number of requests of point p for mesh i at {@code i · points + p}. */
    private final AtomicReferenceArray<LightBuffer> buffers;
    private final AtomicIntegerArray requests;
    private final AtomicLong bytes = new AtomicLong();

    /**
     * @param meshes primitives, ascending, each a mesh
     * @param x      coordinates of the points in render space, with {@code y} and {@code z}
     */
    public LightBuffers(PrimitiveTable primitives, int[] meshes, double[] x, double[] y, double[] z) {
        this.primitives = primitives;
        this.meshes = meshes;
        this.x = x.clone();
        this.y = y.clone();
        this.z = z.clone();
        buffers = new AtomicReferenceArray<>(meshes.length * x.length);
        requests = new AtomicIntegerArray(meshes.length * x.length);
    }

    /** Returns the buffer of point {@code p} for primitive {@code s}; null if there is none yet, or if none is possible. */
    public @Nullable LightBuffer get(int s, int p) {
        int mesh = Arrays.binarySearch(meshes, s);
        if (mesh < 0) {
            return null;
        }
        int i = mesh * x.length + p;
        LightBuffer buffer = buffers.get(i);
        return buffer == null ? countRequest(s, p, i) : buffer;
    }

    /** Exactly one thread counts the request that builds the buffer. */
    private @Nullable LightBuffer countRequest(int s, int p, int i) {
        MeshSolid mesh = requireNonNull(primitives.mesh(s));
        if (requests.incrementAndGet(i) != (int) (REQUESTS_PER_LEAF * LightBuffer.leafCount(mesh)) + 1 || bytes.get() > MAX_BYTES) {
            return null;
        }
        double[] m = primitives.data;
        int at = primitives.dataStart[s];
        LightBuffer buffer = LightBuffer.of(mesh, m[at] * x[p] + m[at + 1] * y[p] + m[at + 2] * z[p] + m[at + 3],
                m[at + 4] * x[p] + m[at + 5] * y[p] + m[at + 6] * z[p] + m[at + 7],
                m[at + 8] * x[p] + m[at + 9] * y[p] + m[at + 10] * z[p] + m[at + 11]);
        if (buffer != null) {
            bytes.addAndGet(buffer.bytes());
            buffers.set(i, buffer);
        }
        return buffer;
    }
}

package lightning.render.trace.primitive;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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

    /** Number of times that the points are halved into groups of neighbors: 16 groups. */
    private static final int SPLITS = 4;
    private final PrimitiveTable primitives;
    /** Primitives with a mesh, ascending. */
    private final int[] meshes;
    private final double[] x;
    private final double[] y;
    private final double[] z;
    /** Group of each point. */
    private final int[] group;
    private final int groups;
    /** Buffer and number of requests of group g for mesh i at {@code i · groups + g}. */
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
        group = new int[x.length];
        groups = split(IntStream.range(0, x.length).toArray(), SPLITS, 0);
        buffers = new AtomicReferenceArray<>(meshes.length * groups);
        requests = new AtomicIntegerArray(meshes.length * groups);
    }

    /** Splits points into groups of neighbors, which are numbered from {@code first}; returns the next number. */
    private int split(int[] all, int splits, int first) {
        if (splits == 0 || all.length == 1) {
            Arrays.stream(all).forEach(p -> group[p] = first);
            return first + 1;
        }
        double[] longest = Stream.of(x, y, z).max(Comparator.comparingDouble(c -> range(all, c))).orElseThrow();
        int[] sorted = Arrays.stream(all).boxed().sorted(Comparator.comparingDouble(p -> longest[p])).mapToInt(p -> p).toArray();
        int half = sorted.length / 2;
        int next = split(Arrays.copyOf(sorted, half), splits - 1, first);
        return split(Arrays.copyOfRange(sorted, half, sorted.length), splits - 1, next);
    }

    private static double range(int[] all, double[] coordinates) {
        DoubleSummaryStatistics range = Arrays.stream(all).mapToDouble(p -> coordinates[p]).summaryStatistics();
        return range.getMax() - range.getMin();
    }

    /** Returns the buffer of point {@code p} for primitive {@code s}; null if there is none yet, or if none is possible. */
    public @Nullable LightBuffer get(int s, int p) {
        int mesh = Arrays.binarySearch(meshes, s);
        if (mesh < 0) {
            return null;
        }
        int i = mesh * groups + group[p];
        LightBuffer buffer = buffers.get(i);
        return buffer == null ? countRequest(s, group[p], i) : buffer;
    }

    /** Exactly one thread counts the request that builds the buffer. */
    private @Nullable LightBuffer countRequest(int s, int g, int i) {
        MeshSolid mesh = requireNonNull(primitives.mesh(s));
        if (requests.incrementAndGet(i) != (int) (REQUESTS_PER_LEAF * LightBuffer.leafCount(mesh)) + 1 || bytes.get() > MAX_BYTES) {
            return null;
        }
        LightBuffer buffer = LightBuffer.of(mesh, localBounds(s, g));
        if (buffer != null) {
            bytes.addAndGet(buffer.bytes());
            buffers.set(i, buffer);
        }
        return buffer;
    }

    /** Returns the bounds of the points of group {@code g} in the space of primitive {@code s}: min x y z, max x y z. */
    private double[] localBounds(int s, int g) {
        double[] m = primitives.data;
        double[] bounds = new double[6];
        Arrays.fill(bounds, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 3, 6, Double.NEGATIVE_INFINITY);
        for (int p = 0; p < x.length; p++) {
            for (int a = 0; a < 3 && group[p] == g; a++) {
                int at = primitives.dataStart[s] + 4 * a;
                double c = m[at] * x[p] + m[at + 1] * y[p] + m[at + 2] * z[p] + m[at + 3];
                bounds[a] = Math.min(bounds[a], c);
                bounds[a + 3] = Math.max(bounds[a + 3], c);
            }
        }
        return bounds;
    }
}

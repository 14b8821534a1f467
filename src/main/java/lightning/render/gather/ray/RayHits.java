package lightning.render.gather.ray;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** Rays of points, by ray: the keys of the cells that they hit while links are built, and their tints. */
public abstract class RayHits {
    /** Additional bytes of a ray while links are built if any is tinted: three floats, and half as many in reserve. */
    public static final int TINT_BUILD_BYTES = 18;
    /** Maximum number of rays: arrays are hardly longer. */
    private static final int MAX_RAYS = Integer.MAX_VALUE - 64;
    /** Kind of the hit of a ray that meets no surfel. */
    protected static final byte NOTHING = 0;

    private final int raysPerPoint;
    private final int buildBytes;
    private final @Nullable PathMemory memory;
    private int rays;
    /** Keys of the cells that rays hit, and the cells of the directions of those that hit nothing. */
    protected long[] keys = {};
    /** Kind of each ray's hit while links are built. */
    protected byte[] hit = {};
    /** Tint of each ray while links are built: red, green, blue; null if none is tinted. */
    private float @Nullable [][] tint;
    private boolean wasTinted;
    /** Tinted rays; null if there are none. */
    private @Nullable RayTints tints;

    /**
     * @param buildBytes bytes of a ray while links are built, without its tint
     * @param memory     null for links that are read
     */
    protected RayHits(int raysPerPoint, int buildBytes, @Nullable PathMemory memory) {
        this.raysPerPoint = raysPerPoint;
        this.buildBytes = buildBytes;
        this.memory = memory;
    }

    /** Sets what finished links have. @param wasTinted whether a ray was tinted while they were built, perhaps by white */
    protected void set(int newRays, @Nullable RayTints newTints, boolean wasTintedBefore) {
        rays = newRays;
        tints = newTints;
        wasTinted = wasTintedBefore;
    }

    /**
     * Makes room for the rays of {@code points} points.
     *
     * @throws PathsTooLargeException if there are too many
     */
    public void setPoints(int points) {
        long count = (long) points * raysPerPoint;
        // More rays than an array holds never fit.
        int bytes = buildBytes + (tint == null ? 0 : TINT_BUILD_BYTES);
        requireNonNull(memory).reserve(count - rays, count > MAX_RAYS ? Integer.MAX_VALUE : bytes);
        rays = (int) count;
        if (rays > keys.length) {
            grow((int) Math.min(MAX_RAYS, Math.max(rays, keys.length * 3L / 2)));
        }
    }

    /** Makes columns longer. @param length in rays */
    protected void grow(int length) {
        keys = Arrays.copyOf(keys, length);
        hit = Arrays.copyOf(hit, length);
        for (int c = 0; tint != null && c < 3; c++) {
            int known = tint[c].length;
            tint[c] = Arrays.copyOf(tint[c], length);
            Arrays.fill(tint[c], known, length, 1);
        }
    }

    public void clear(int from, int to) {
        Arrays.fill(hit, from, to, NOTHING);
    }

    /** Sets the tints of rays {@code from … from + count − 1} to those from {@code at} on. */
    public void setTints(int from, int count, float[][] itsTints, int at) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            System.arraycopy(itsTints[c], at, all[c], from, count);
        }
    }

    private synchronized float[][] allocateTints() {
        if (tint == null) {
            requireNonNull(memory).reserve(rays, TINT_BUILD_BYTES);
            float[][] all = new float[3][keys.length];
            for (float[] channel : all) {
                Arrays.fill(channel, 1);
            }
            tint = all;
        }
        return tint;
    }

    /** Drops what only building needs. */
    protected void finish() {
        keys = new long[0];
        hit = new byte[0];
        wasTinted = tint != null;
        tints = tint == null ? null : RayTints.of(tint, rays);
        tint = null;
    }

    /** Returns the finished tints; null if no ray is tinted. */
    protected @Nullable RayTints tints() {
        return tints;
    }

    /** Returns whether any ray had a tint while the links were built. */
    protected boolean wasTinted() {
        return wasTinted;
    }

    /** Reads the tints of rays {@code from … from + count − 1} into scratch memory; returns whether any is tinted. */
    protected boolean readTints(int from, int count, RaySums to) {
        return tints != null && tints.read(from, count, to.tints());
    }

    public long key(int ray) {
        return keys[ray];
    }

    /** Returns the number of points, with copies of their places. */
    public int points() {
        return raysPerPoint == 0 ? 0 : rays / raysPerPoint;
    }

    public int raysPerPoint() {
        return raysPerPoint;
    }

    /** Returns the number of rays of all points. */
    public int rayCount() {
        return rays;
    }

    /** Returns the bytes of the finished tints. */
    protected long tintBytes() {
        return tints == null ? 0 : tints.bytes();
    }

    /** Returns the bytes that the links took only while they were built. */
    public long buildBytes() {
        return (buildBytes + (wasTinted ? (long) TINT_BUILD_BYTES : 0)) * rays;
    }
}

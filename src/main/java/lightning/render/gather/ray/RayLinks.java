package lightning.render.gather.ray;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.DirectionCells;
import org.jspecify.annotations.Nullable;

/** Surfels that the rays of points hit, by ray. First they are known by the keys of their cells, later by their numbers. */
public final class RayLinks {
    /** Number of a ray that hits nothing. */
    public static final int MISS = -1;
    private static final byte NOTHING = 0;
    private static final byte SURFEL = 1;
    /** A surfel whose glow the ray does not count. */
    private static final byte DARK_SURFEL = 2;
    /** Bytes of a ray only while links are built: a key and a flag, half as many in reserve, and a copy of the key while they grow. */
    public static final int BUILD_BYTES = 22;
    /** Additional bytes of a ray while links are built if any is tinted: three floats, and half as many in reserve. */
    public static final int TINT_BUILD_BYTES = 18;
    /** Maximum number of rays: arrays are hardly longer. */
    private static final int MAX_RAYS = Integer.MAX_VALUE - 64;

    private final int raysPerPoint;
    /** Numbers of rays that hit nothing: one, or one for each cell of their directions. */
    private final int misses;
    private final @Nullable PathMemory memory;
    private int rays;
    /** Keys of the cells that rays hit, and the cells of the directions of those that hit nothing. */
    private long[] keys = {};
    /** Kind of each ray's hit while links are built. */
    private byte[] hit = {};
    /** Surfel of each ray; then come numbers of rays that hit nothing, and of surfels without glow. */
    private RayNumbers surfel = new RayNumbers(0, 1);
    /** First number of rays that hit nothing. */
    private int miss;
    /** Surfels of the numbers after those of rays that hit nothing: those without glow. */
    private int[] dark = {};
    /** Tint of each ray while links are built: red, green, blue; null if none is tinted. */
    private float @Nullable [][] tint;
    private boolean wasTinted;
    /** Tinted rays; null if there are none. */
    private @Nullable RayTints tints;

    /**
     * @param misses 1, or {@link DirectionCells#COUNT} if rays that hit nothing keep their direction
     * @param memory null for links that are read
     */
    public RayLinks(int raysPerPoint, int misses, @Nullable PathMemory memory) {
        this.raysPerPoint = raysPerPoint;
        this.misses = misses;
        this.memory = memory;
    }

    /**
     * Makes room for the rays of {@code points} points.
     *
     * @throws PathsTooLargeException if there are too many
     */
    public void setPoints(int points) {
        long count = (long) points * raysPerPoint;
        // More rays than an array holds never fit.
        int bytes = BUILD_BYTES + Integer.BYTES + (tint == null ? 0 : TINT_BUILD_BYTES);
        requireNonNull(memory).reserve(count - rays, count > MAX_RAYS ? Integer.MAX_VALUE : bytes);
        rays = (int) count;
        if (rays > keys.length) {
            int length = (int) Math.min(MAX_RAYS, Math.max(rays, keys.length * 3L / 2));
            keys = Arrays.copyOf(keys, length);
            hit = Arrays.copyOf(hit, length);
            for (int c = 0; tint != null && c < 3; c++) {
                int known = tint[c].length;
                tint[c] = Arrays.copyOf(tint[c], length);
                Arrays.fill(tint[c], known, length, 1);
            }
        }
    }

    public void clear(int from, int to) {
        Arrays.fill(hit, from, to, NOTHING);
    }

    /** @param isAimed whether other rays are aimed at the object that the ray hit, so that this one does not count its glow */
    public void setKey(int ray, long key, boolean isAimed) {
        keys[ray] = key;
        hit[ray] = isAimed ? DARK_SURFEL : SURFEL;
    }

    /**
     * Keeps the direction of a ray that hits nothing, if wanted.
     *
     * @param x direction, with {@code y} and {@code z}
     */
    public void setMiss(int ray, double x, double y, double z) {
        keys[ray] = missCell(x, y, z);
    }

    /** Sets the tints of rays {@code from … from + count − 1}. */
    public void setTints(int from, int count, float[][] tints) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            System.arraycopy(tints[c], 0, all[c], from, count);
        }
    }

    /** Sets the tint of a ray to element {@code from} of some tints. */
    public void setTint(int ray, float[][] tints, int from) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            all[c][ray] = tints[c][from];
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

    public boolean isHit(int ray) {
        return hit[ray] != NOTHING;
    }

    public long key(int ray) {
        return keys[ray];
    }

    /** Replaces keys by the numbers of the cells. Threads may resolve parts that start at multiples of {@link RayNumbers#ALIGNMENT}. */
    public void resolve(CellTable cells, int from, int to) {
        for (int ray = from; ray < to; ray++) {
            surfel.set(ray, hit[ray] == NOTHING ? miss + (int) keys[ray] : number(cells.number(keys[ray]), hit[ray] == DARK_SURFEL));
        }
    }

    /**
     * @param surfels number of surfels
     * @param glowing surfels whose glow some rays do not count, ascending
     */
    public void allocateNumbers(int surfels, int[] glowing) {
        miss = surfels;
        dark = glowing;
        surfel = new RayNumbers(rays, surfels + misses + dark.length);
    }

    /** Drops what only building needs. */
    public void finish() {
        keys = new long[0];
        hit = new byte[0];
        wasTinted = tint != null;
        tints = tint == null ? null : RayTints.of(tint, rays);
        tint = null;
    }

    /** Writes finished links. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(raysPerPoint);
        out.writeInt(misses);
        out.writeInt(rays);
        out.writeInt(miss);
        out.writeArray(dark);
        surfel.writeTo(out);
        RayTints.write(tints, out);
        out.writeInt(wasTinted ? 1 : 0);
    }

    public static RayLinks readFrom(ColumnReader in) throws IOException {
        var links = new RayLinks(in.readInt(), in.readInt(), null);
        links.rays = in.readInt();
        links.miss = in.readInt();
        links.dark = in.readInts();
        links.surfel = RayNumbers.readFrom(in);
        links.tints = RayTints.read(in);
        links.wasTinted = in.readInt() != 0;
        return links;
    }

    /** Returns the number of points. */
    public int points() {
        return rays / raysPerPoint;
    }

    /** Returns the numbers of rays that hit nothing: 1, or {@link DirectionCells#COUNT} if these keep their direction. */
    public int misses() {
        return misses;
    }

    public int raysPerPoint() {
        return raysPerPoint;
    }

    /** Returns the number of rays of all points. */
    public int rayCount() {
        return rays;
    }

    /** Returns the number of the hit of a ray, among those of {@link #sum(int, FilmLight, RaySums)}. */
    public int number(int ray) {
        return surfel.get(ray);
    }

    /** Returns the number of a surfel, as above; {@code isAimed} as in {@link #setKey}. */
    public int number(int itsSurfel, boolean isAimed) {
        return isAimed ? miss + misses + Arrays.binarySearch(dark, itsSurfel) : itsSurfel;
    }

    /** Returns the number of a ray that hits nothing, as above. */
    public int missNumber(double x, double y, double z) {
        return miss + missCell(x, y, z);
    }

    private int missCell(double x, double y, double z) {
        return misses == 1 ? 0 : DirectionCells.of(x, y, z);
    }

    /**
     * Returns links of other rays among the same numbers.
     *
     * @param numbers  number of each ray
     * @param itsTints red, green and blue tint of each; null if none is tinted
     */
    public RayLinks withRays(int[] numbers, float @Nullable [][] itsTints) {
        var links = new RayLinks(1, misses, null);
        links.rays = numbers.length;
        links.miss = miss;
        links.dark = dark;
        links.surfel = new RayNumbers(numbers.length, miss + misses + dark.length);
        for (int ray = 0; ray < numbers.length; ray++) {
            links.surfel.set(ray, numbers[ray]);
        }
        links.tints = itsTints == null ? null : RayTints.of(itsTints, numbers.length);
        return links;
    }

    /** Returns the surfel that a ray hit; {@link #MISS} for none. */
    public int surfel(int ray) {
        int number = surfel.get(ray);
        return number < miss ? number : number < miss + misses ? MISS : dark[number - miss - misses];
    }

    /**
     * Adds up the light that the rays of a point meet, in the order of the rays.
     *
     * @param light of each surfel, of the background or its cells, and of glowing surfels without their glow
     */
    public void sum(int point, FilmLight light, RaySums to) {
        sum(point * raysPerPoint, raysPerPoint, light, to);
    }

    /** Adds up the light that rays {@code from … from + count − 1} meet, as above. */
    public void sum(int from, int count, FilmLight light, RaySums to) {
        surfel.read(from, count, to.numbers(count));
        to.addUp(light, count, tints != null && tints.read(from, count, to.tints()));
    }

    /** Returns the bytes that the links took only while they were built. */
    public long buildBytes() {
        return (BUILD_BYTES + (wasTinted ? (long) TINT_BUILD_BYTES : 0)) * rays;
    }

    /** Returns the bytes of the links. */
    public long bytes() {
        return surfel.bytes() + (tints == null ? 0 : tints.bytes());
    }
}

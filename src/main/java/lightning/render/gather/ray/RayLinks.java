package lightning.render.gather.ray;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.DirectionCells;
import org.jspecify.annotations.Nullable;

/** Surfels that the rays of points hit, by ray. First they are known by the keys of their cells, later by their numbers. */
public final class RayLinks extends RayHits {
    /** Number of a ray that hits nothing. */
    public static final int MISS = -1;
    private static final byte SURFEL = 1;
    /** A surfel whose glow the ray does not count. */
    private static final byte DARK_SURFEL = 2;
    /** Bytes of a ray only while links are built: a key and a flag, half as many in reserve, and a copy of the key while they grow. */
    public static final int BUILD_BYTES = 22;

    /** Numbers of rays that hit nothing: one, or one for each cell of their directions. */
    private final int misses;
    /** Surfel of each ray; then come numbers of rays that hit nothing, and of surfels without glow. */
    private RayNumbers surfel = new RayNumbers(0, 1);
    /** First number of rays that hit nothing. */
    private int miss;
    /** Surfels of the numbers after those of rays that hit nothing: those without glow. */
    private int[] dark = {};
    /**
     * @param misses 1, or {@link DirectionCells#COUNT} if rays that hit nothing keep their direction
     * @param memory null for links that are read
     */
    public RayLinks(int raysPerPoint, int misses, @Nullable PathMemory memory) {
        super(raysPerPoint, BUILD_BYTES, memory);
        this.misses = misses;
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

    public boolean isHit(int ray) {
        return hit[ray] != NOTHING;
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
        surfel = new RayNumbers(rayCount(), surfels + misses + dark.length);
    }

    @Override
    public void finish() {
        super.finish();
    }

    /** Writes finished links. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(raysPerPoint());
        out.writeInt(misses);
        out.writeInt(rayCount());
        out.writeInt(miss);
        out.writeArray(dark);
        surfel.writeTo(out);
        RayTints.write(tints(), out);
        out.writeInt(wasTinted() ? 1 : 0);
    }

    public static RayLinks readFrom(ColumnReader in) throws IOException {
        var links = new RayLinks(in.readInt(), in.readInt(), null);
        int rays = in.readInt();
        links.miss = in.readInt();
        links.dark = in.readInts();
        links.surfel = RayNumbers.readFrom(in);
        links.set(rays, RayTints.read(in), in.readInt() != 0);
        return links;
    }

    /** Returns the numbers of rays that hit nothing: 1, or {@link DirectionCells#COUNT} if these keep their direction. */
    public int misses() {
        return misses;
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
        links.miss = miss;
        links.dark = dark;
        links.surfel = new RayNumbers(numbers.length, miss + misses + dark.length);
        for (int ray = 0; ray < numbers.length; ray++) {
            links.surfel.set(ray, numbers[ray]);
        }
        links.set(numbers.length, itsTints == null ? null : RayTints.of(itsTints, numbers.length), false);
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
        sum(point * raysPerPoint(), raysPerPoint(), light, to);
    }

    /** Adds up the light that rays {@code from … from + count − 1} meet, as above. */
    public void sum(int from, int count, FilmLight light, RaySums to) {
        surfel.read(from, count, to.numbers(count));
        to.addUp(light, count, readTints(from, count, to));
    }

    /** Returns the bytes of the links. */
    public long bytes() {
        return surfel.bytes() + tintBytes();
    }
}

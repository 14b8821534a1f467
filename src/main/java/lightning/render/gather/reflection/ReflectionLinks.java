package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySums;
import lightning.render.gather.ray.RayTints;
import org.jspecify.annotations.Nullable;

/**
 * What the rays of reflection points meet, by ray: a surfel, or a cell of the sky. First the surfels are known by the keys of their cells.
 * A ray has a weight that the reflectance at normal incidence multiplies, and one that no color multiplies; only their ratios count.
 */
public final class ReflectionLinks {
    /** Bytes of a ray while links are built: two keys, a flag, two weights and a number, half as many in reserve. */
    public static final int BUILD_BYTES = 38;
    /** Step of weights: they are at most 2, the sum of a surface and its coat. */
    private static final float STEP = 0x1p-15f;
    /** Rays whose numbers a thread finds together. */
    private static final int BATCH = 1 << 14;
    private static final byte MISS = 0;
    private static final byte SURFEL = 1;

    private final int raysPerPoint;
    private final @Nullable PathMemory memory;
    private int rays;
    private long[] keys = {};
    private long[] detailKeys = {};
    private byte[] hit = {};
    /** Surfel of each ray; then come the cells of the sky. */
    private int[] number = {};
    /** Weights in steps, unsigned: that of the color in the higher half. */
    private int[] weights = {};
    private float @Nullable [][] tint;
    private @Nullable RayTints tints;

    ReflectionLinks(int raysPerPoint, @Nullable PathMemory memory) {
        this.raysPerPoint = raysPerPoint;
        this.memory = memory;
    }

    /**
     * Makes room for the rays of {@code points} points.
     *
     * @throws lightning.render.gather.ray.PathsTooLargeException if there are too many
     */
    void setPoints(int points) {
        long count = (long) points * raysPerPoint;
        requireNonNull(memory).reserve(count - rays, count > Integer.MAX_VALUE / 2 ? Integer.MAX_VALUE : BUILD_BYTES);
        rays = (int) count;
        if (rays > keys.length) {
            int length = Math.max(rays, keys.length / 2 * 3);
            keys = Arrays.copyOf(keys, length);
            detailKeys = Arrays.copyOf(detailKeys, length);
            hit = Arrays.copyOf(hit, length);
            weights = Arrays.copyOf(weights, length);
            for (int c = 0; tint != null && c < 3; c++) {
                int known = tint[c].length;
                tint[c] = Arrays.copyOf(tint[c], length);
                Arrays.fill(tint[c], known, length, 1);
            }
        }
    }

    void clear(int from, int to) {
        Arrays.fill(hit, from, to, MISS);
    }

    void setKeys(int ray, long key, long detailKey) {
        keys[ray] = key;
        detailKeys[ray] = detailKey;
        hit[ray] = SURFEL;
    }

    void setMiss(int ray, int cell) {
        keys[ray] = cell;
    }

    void setWeights(int ray, double color, double white) {
        weights[ray] = steps(color) << 16 | steps(white);
    }

    private static int steps(double weight) {
        assert weight < 2.001;
        return Math.min(0xFFFF, (int) (weight / STEP + 0.5));
    }

    /** Sets the tints of rays {@code from … from + count − 1} to those from {@code at} on. */
    void setTints(int from, int count, float[][] itsTints, int at) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            System.arraycopy(itsTints[c], at, all[c], from, count);
        }
    }

    /**
     * Writes the rays of a point to those of a point of other links that are being built.
     *
     * @param memo keys of the surfels of these links
     */
    void copy(int point, ReflectionLinks to, int toPoint, ReflectionMemo memo) {
        int from = point * raysPerPoint;
        int next = tints == null ? 0 : tints.firstFrom(from);
        for (int k = 0; k < raysPerPoint; k++) {
            int ray = toPoint * raysPerPoint + k;
            int surfel = number[from + k];
            to.weights[ray] = weights[from + k];
            if (surfel < memo.surfelCount()) {
                to.setKeys(ray, memo.key(surfel), memo.partKey(surfel));
            } else {
                to.hit[ray] = MISS;
                to.setMiss(ray, surfel - memo.surfelCount());
            }
            if (tints != null && next < tints.count() && tints.ray()[next] == from + k) {
                float[][] all = to.allocateTints();
                for (int c = 0; c < 3; c++) {
                    all[c][ray] = tints.tint()[c][next];
                }
                next++;
            }
        }
    }

    private synchronized float[][] allocateTints() {
        if (tint == null) {
            requireNonNull(memory).reserve(rays, RayLinks.TINT_BUILD_BYTES);
            float[][] all = new float[3][keys.length];
            for (float[] channel : all) {
                Arrays.fill(channel, 1);
            }
            tint = all;
        }
        return tint;
    }

    /** Returns whether a ray meets a surfel and counts. */
    boolean isHit(int ray) {
        return hit[ray] == SURFEL && weights[ray] != 0;
    }

    public long key(int ray) {
        return keys[ray];
    }

    /** Returns the key of the part of the surfel's cell that the ray meets; that of the cell if it is not divided. */
    public long detailKey(int ray) {
        return detailKeys[ray];
    }

    /** Returns the number of points, with copies of their places. */
    public int points() {
        return raysPerPoint == 0 ? 0 : rays / raysPerPoint;
    }

    int raysPerPoint() {
        return raysPerPoint;
    }

    public int rayCount() {
        return rays;
    }

    /**
     * Replaces keys by numbers and drops what only building needs.
     *
     * @param cells    numbers of surfels
     * @param details  numbers of parts of surfels
     * @param surfels  number of all of them
     * @param repeated points of paths before an edit
     */
    void finish(CellTable cells, CellTable details, int surfels, RepeatedPoints repeated, WorkerPool workers, Progress progress) {
        number = new int[rays];
        weights = Arrays.copyOf(weights, rays);
        // Numbers of surfels of before the edit, and 1; many rays meet the same surfel. Threads may write one several times.
        int[] known = new int[repeated.surfelCount()];
        int batch = Math.max(1, BATCH / Math.max(1, raysPerPoint));
        workers.run(Math.ceilDiv(points(), batch), (_, job) -> {
            for (int p = job * batch; p < Math.min(points(), (job + 1) * batch); p++) {
                boolean isKnown = repeated.isKnown(p);
                for (int k = 0; k < raysPerPoint; k++) {
                    int ray = p * raysPerPoint + k;
                    if (hit[ray] == MISS) {
                        number[ray] = surfels + (int) keys[ray];
                    } else if (weights[ray] != 0) {
                        int old = isKnown ? repeated.number(p, k) : 0;
                        number[ray] = isKnown && known[old] > 0 ? known[old] - 1 : number(ray, cells, details);
                        if (isKnown) {
                            known[old] = number[ray] + 1;
                        }
                    }
                }
            }
        }, progress);
        keys = new long[0];
        detailKeys = new long[0];
        hit = new byte[0];
        tints = tint == null ? null : RayTints.of(tint, rays);
        tint = null;
    }

    private int number(int ray, CellTable cells, CellTable details) {
        return (keys[ray] == detailKeys[ray] ? cells : details).number(detailKeys[ray]);
    }

    /** Returns the surfel of a ray, or a number after all surfels if it meets the sky; 0 if the ray counts for nothing. */
    int surfel(int ray) {
        return number[ray];
    }

    /**
     * Writes the mean light that a point reflects, in the order of its rays.
     *
     * @param light of each surfel and of each cell of the sky
     * @param sums  scratch memory for reflections alone
     * @param color receives the means with the weights that the reflectance multiplies, as {@code white} with those that no color
     *              multiplies; 0 if all weights are 0
     */
    public void writeMean(int point, FilmLight light, RaySums sums, FilmLight color, FilmLight white) {
        int from = point * raysPerPoint;
        System.arraycopy(number, from, sums.numbers(raysPerPoint), 0, raysPerPoint);
        boolean isTinted = tints != null && tints.read(from, raysPerPoint, sums.tints());
        writeMean(point, 16, light, sums, isTinted, color);
        writeMean(point, 0, light, sums, isTinted, white);
    }

    /** @param shift of the weights in their words */
    private void writeMean(int point, int shift, FilmLight light, RaySums sums, boolean isTinted, FilmLight to) {
        int from = point * raysPerPoint;
        int total = 0;
        for (int ray = from; ray < from + raysPerPoint; ray++) {
            total += weights[ray] >>> shift & 0xFFFF;
        }
        float scale = total == 0 ? 0 : 1f / total;
        for (int k = 0; k < raysPerPoint; k++) {
            sums.weights()[k] = (weights[from + k] >>> shift & 0xFFFF) * scale;
        }
        sums.addUp(light, raysPerPoint, isTinted);
        sums.writeTo(to, point);
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(raysPerPoint);
        out.writeInt(rays);
        out.writeArray(number);
        out.writeArray(weights);
        RayTints.write(tints, out);
    }

    static ReflectionLinks readFrom(ColumnReader in) throws IOException {
        var links = new ReflectionLinks(in.readInt(), null);
        links.rays = in.readInt();
        links.number = in.readInts();
        links.weights = in.readInts();
        links.tints = RayTints.read(in);
        return links;
    }

    long bytes() {
        return 8L * rays + (tints == null ? 0 : tints.bytes());
    }
}

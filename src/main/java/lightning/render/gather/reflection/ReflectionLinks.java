package lightning.render.gather.reflection;

import java.io.IOException;
import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayHits;
import lightning.render.gather.ray.RaySums;
import lightning.render.gather.ray.RayTints;
import org.jspecify.annotations.Nullable;

/**
 * What the rays of reflection points meet, by ray: a surfel, or a cell of the sky. First the surfels are known by the keys of their cells.
 * A ray has a weight that the reflectance at normal incidence multiplies, and one that no color multiplies; only their ratios count.
 */
public final class ReflectionLinks extends RayHits {
    /** Bytes of a ray while links are built: two keys, a flag, two weights and a number, half as many in reserve. */
    public static final int BUILD_BYTES = 38;
    /** Step of weights: they are at most 2, the sum of a surface and its coat. */
    private static final float STEP = 0x1p-15f;
    /** Rays whose numbers a thread finds together. */
    private static final int BATCH = 1 << 14;
    private static final byte SURFEL = 1;

    private long[] detailKeys = {};
    /** Surfel of each ray; then come the cells of the sky. */
    private int[] number = {};
    /** Weights in steps, unsigned: that of the color in the higher half. */
    private int[] weights = {};

    ReflectionLinks(int raysPerPoint, @Nullable PathMemory memory) {
        super(raysPerPoint, BUILD_BYTES, memory);
    }

    @Override
    protected void grow(int length) {
        super.grow(length);
        detailKeys = Arrays.copyOf(detailKeys, length);
        weights = Arrays.copyOf(weights, length);
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

    /**
     * Writes the rays of a point to those of a point of other links that are being built.
     *
     * @param memo keys of the surfels of these links
     */
    void copy(int point, ReflectionLinks to, int toPoint, ReflectionMemo memo) {
        int from = point * raysPerPoint();
        RayTints tints = tints();
        int next = tints == null ? 0 : tints.firstFrom(from);
        for (int k = 0; k < raysPerPoint(); k++) {
            int ray = toPoint * raysPerPoint() + k;
            int surfel = number[from + k];
            to.weights[ray] = weights[from + k];
            if (surfel < memo.surfelCount()) {
                to.setKeys(ray, memo.key(surfel), memo.partKey(surfel));
            } else {
                to.hit[ray] = NOTHING;
                to.setMiss(ray, surfel - memo.surfelCount());
            }
            if (tints != null && next < tints.count() && tints.ray()[next] == from + k) {
                to.setTints(ray, 1, tints.tint(), next);
                next++;
            }
        }
    }

    /** Returns whether a ray meets a surfel and counts. */
    boolean isHit(int ray) {
        return hit[ray] == SURFEL && weights[ray] != 0;
    }

    /** Returns the key of the part of the surfel's cell that the ray meets; that of the cell if it is not divided. */
    public long detailKey(int ray) {
        return detailKeys[ray];
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
        int raysPerPoint = raysPerPoint();
        number = new int[rayCount()];
        weights = Arrays.copyOf(weights, rayCount());
        // Numbers of surfels of before the edit, and 1; many rays meet the same surfel. Threads may write one several times.
        int[] known = new int[repeated.surfelCount()];
        int batch = Math.max(1, BATCH / Math.max(1, raysPerPoint));
        workers.run(Math.ceilDiv(points(), batch), (_, job) -> {
            for (int p = job * batch; p < Math.min(points(), (job + 1) * batch); p++) {
                boolean isKnown = repeated.isKnown(p);
                for (int k = 0; k < raysPerPoint; k++) {
                    int ray = p * raysPerPoint + k;
                    if (hit[ray] == NOTHING) {
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
        detailKeys = new long[0];
        finish();
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
     * @param light of each surfel and of each cell of the sky, and last of the sky if it is the same everywhere
     * @param sky   light of the parts of the point's lobes; null if the sky is the same everywhere
     * @param sums  scratch memory for reflections alone
     * @param color receives the means with the weights that the reflectance multiplies, as {@code white} with those that no color
     *              multiplies; 0 if all weights are 0
     */
    void writeMean(int point, FilmLight light, @Nullable SkyParts sky, RaySums sums, FilmLight color, FilmLight white) {
        sums.numbers(raysPerPoint());
        boolean isTinted = readTints(point * raysPerPoint(), raysPerPoint(), sums);
        writeMean(point, 0, light, sky, sums, isTinted, color);
        writeMean(point, 1, light, sky, sums, isTinted, white);
    }

    /** @param kind 0 for the weights of the color, in the higher half of their words; 1 for the others */
    private void writeMean(int point, int kind, FilmLight light, @Nullable SkyParts sky, RaySums sums, boolean isTinted, FilmLight to) {
        int raysPerPoint = raysPerPoint();
        int from = point * raysPerPoint;
        int shift = kind == 0 ? 16 : 0;
        int total = 0;
        for (int ray = from; ray < from + raysPerPoint; ray++) {
            total += weights[ray] >>> shift & 0xFFFF;
        }
        float scale = total == 0 ? 0 : 1f / total;
        int[] numbers = sums.numbers(raysPerPoint);
        int parts = light.numbers() - SkyCells.NUMBERS + SkyCells.ABOVE;
        FilmLight met = sky == null ? light : sky.met();
        for (int k = 0; k < raysPerPoint; k++) {
            sums.weights()[k] = (weights[from + k] >>> shift & 0xFFFF) * scale;
            numbers[k] = sky == null ? number[from + k] : k;
            if (sky != null && number[from + k] >= parts) {
                sky.write(k, number[from + k] - parts, kind);
            } else if (sky != null) {
                met.copy(light, number[from + k], k);
            }
        }
        sums.addUp(met, raysPerPoint, isTinted);
        sums.writeTo(to, point);
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(raysPerPoint());
        out.writeInt(rayCount());
        out.writeArray(number);
        out.writeArray(weights);
        RayTints.write(tints(), out);
    }

    static ReflectionLinks readFrom(ColumnReader in) throws IOException {
        var links = new ReflectionLinks(in.readInt(), null);
        int rays = in.readInt();
        links.number = in.readInts();
        links.weights = in.readInts();
        RayTints tints = RayTints.read(in);
        links.set(rays, tints, tints != null);
        return links;
    }

    long bytes() {
        return 8L * rayCount() + tintBytes();
    }
}

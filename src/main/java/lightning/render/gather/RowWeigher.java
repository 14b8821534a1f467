package lightning.render.gather;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.TexelColumns;
import org.jspecify.annotations.Nullable;

/** Finds the gather points of rows. Holds scratch memory: use one instance per thread. */
public final class RowWeigher {
    private static final int BEST = RowWeights.PER_ROW;
    private static final int MAX_ROWS = 1024;

    private final GatherStructure structure;
    private final SurfaceColumns points;
    private final float[] radius;
    private final PointGroups groups;
    private final Barriers barriers;
    private final NearPoints near;
    private final @Nullable ReflectionWeigher reflections;
    /** Index of each point among those used by the present rows. */
    private final int[] indexOf;
    /** Number of the rows for which {@link #indexOf} holds. */
    private final int[] usedBy;
    private int call;
    private final int[] used = new int[BEST * MAX_ROWS];
    private int usedCount;
    /** Rows in an order in which neighbors are near each other. */
    private final int[] order = new int[MAX_ROWS];
    /** Point of the last row that is near none; probably not far from the next such row. */
    private int lastNearest;
    private final int[] best = new int[BEST + 1];
    private final float[] bestWeight = new float[BEST + 1];
    private final LinearWeights linear = new LinearWeights();

    public RowWeigher(GatherStructure structure) {
        this.structure = structure;
        points = structure.points().surface();
        radius = structure.points().radius();
        groups = structure.points().groups();
        barriers = structure.points().barriers();
        near = new NearPoints(points, radius, groups);
        reflections = structure.reflections() == null ? null : new ReflectionWeigher(structure, structure.reflections());
        indexOf = new int[points.count];
        usedBy = new int[points.count];
    }

    /** Returns the weights of one point: those of its row in any level. */
    public RowWeights weigh(SurfacePoint point) {
        float[] roughness = point.maps().get(ColumnGroup.ROUGHNESS_TEXEL);
        HitRows row = new HitRows(1, roughness == null ? TexelColumns.NONE : TexelColumns.ROUGHNESS);
        if (roughness != null) {
            requireNonNull(row.texel(ColumnGroup.ROUGHNESS_TEXEL, 0))[0] = roughness[0];
        }
        row.px[0] = point.px();
        row.py[0] = point.py();
        row.pz[0] = point.pz();
        row.nx[0] = point.nx();
        row.ny[0] = point.ny();
        row.nz[0] = point.nz();
        row.vx[0] = point.vx();
        row.vy[0] = point.vy();
        row.vz[0] = point.vz();
        row.count = 1;
        row.addRun(point.material(), 1);
        return weigh(row);
    }

    /** Returns the weights of up to 1024 rows. */
    public RowWeights weigh(HitRows rows) {
        call++;
        usedCount = 0;
        int count = points.count == 0 ? 0 : rows.count;
        short[] index = new short[BEST * rows.count];
        byte[] weight = new byte[BEST * rows.count];
        for (int row = 0; row < count; row++) {
            order[row] = row;
        }
        if (count > 0) {
            near.find(rows.px, rows.py, rows.pz, order, 0, count, (row, candidates) -> {
                findBest(rows, row, candidates);
                write(rows, row, index, weight);
            });
        }
        return new RowWeights(structure, Arrays.copyOf(used, usedCount), index, weight,
                reflections == null ? null : reflections.weigh(rows));
    }

    private void findBest(HitRows rows, int row, int count) {
        Arrays.fill(bestWeight, 0);
        for (int i = 0; i < count; i++) {
            int column = near.near[i];
            float w = PointWeight.at(near.columns, column, near.columnRadius[column], rows.px[row], rows.py[row], rows.pz[row],
                    rows.nx[row], rows.ny[row], rows.nz[row]);
            if (w > bestWeight[BEST]
                    && !barriers.separate(points, near.point(column), rows.px[row], rows.py[row], rows.pz[row])) {
                insert(near.point(column), w);
            }
        }
    }

    /** Inserts a point among the best, after those of equal weight. */
    private void insert(int p, float w) {
        int at = BEST;
        while (at > 0 && bestWeight[at - 1] < w) {
            bestWeight[at] = bestWeight[at - 1];
            best[at] = best[at - 1];
            at--;
        }
        bestWeight[at] = w;
        best[at] = p;
    }

    private void write(HitRows rows, int row, short[] index, byte[] weight) {
        int at = BEST * row;
        if (bestWeight[0] == 0) {
            lastNearest = groups.nearest(barriers, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row],
                    lastNearest);
            index[at] = index(lastNearest);
            weight[at] = (byte) WeightedPoints.MAX_WEIGHT;
            return;
        }
        adjust(rows, row);
        float scale = WeightedPoints.MAX_WEIGHT / linear.largest();
        for (int i = 0; i < linear.count(); i++) {
            int w = WeightedPoints.whole(linear.weight(i), scale);
            if (w > 0) {
                index[at] = index(best[i]);
                weight[at++] = (byte) w;
            }
        }
    }

    private void adjust(HitRows rows, int row) {
        linear.start(rows.nx[row], rows.ny[row], rows.nz[row], radius[best[0]]);
        for (int i = 0; i < BEST && bestWeight[i] > 0; i++) {
            // The weight of the next point is subtracted, so that nothing jumps where it replaces another.
            float w = bestWeight[0] > bestWeight[BEST] ? bestWeight[i] - bestWeight[BEST] : 1;
            int p = best[i];
            linear.add(w, points.px[p] - rows.px[row], points.py[p] - rows.py[row], points.pz[p] - rows.pz[row]);
        }
        linear.adjust();
    }

    private short index(int p) {
        if (usedBy[p] != call) {
            usedBy[p] = call;
            indexOf[p] = usedCount;
            used[usedCount++] = p;
        }
        return (short) indexOf[p];
    }
}

package lightning.render.gather;

import static java.util.Objects.requireNonNull;

import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.Barriers;
import lightning.render.gather.point.NearPoints;
import lightning.render.gather.point.PointGroups;
import lightning.render.gather.point.PointWeight;
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
    private final BestPoints best;
    /** Rows in an order in which neighbors are near each other. */
    private final int[] order = new int[MAX_ROWS];
    /** Point of the last row that is near none; probably not far from the next such row. */
    private int lastNearest;

    public RowWeigher(GatherStructure structure) {
        this.structure = structure;
        points = structure.points().surface();
        radius = structure.points().radius();
        groups = structure.points().groups();
        barriers = structure.points().barriers();
        near = new NearPoints(points, radius, groups);
        reflections = structure.reflections() == null ? null : new ReflectionWeigher(structure, structure.reflections());
        best = new BestPoints(points.count);
    }

    /** Returns the weights of one point: those of its row in any level. */
    public RowWeights weigh(SurfacePoint point) {
        float[] roughness = point.maps().get(ColumnGroup.ROUGHNESS_TEXEL);
        float[] tangent = point.maps().get(ColumnGroup.TANGENT);
        HitRows row = new HitRows(1, (roughness == null ? TexelColumns.NONE : TexelColumns.ROUGHNESS)
                .or(tangent == null ? TexelColumns.NONE : TexelColumns.TANGENTS));
        for (int c = 0; tangent != null && c < tangent.length; c++) {
            requireNonNull(row.texel(ColumnGroup.TANGENT, c))[0] = tangent[c];
        }
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
        best.startRows();
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
        return new RowWeights(structure, best.used(), index, weight, weighReflections(rows));
    }

    /** Returns the weights of the reflection points of up to 1024 rows; null if the structure has none. */
    @Nullable
    RowWeights weighReflections(HitRows rows) {
        return reflections == null ? null : reflections.weigh(rows);
    }

    private void findBest(HitRows rows, int row, int count) {
        best.startPlace();
        for (int i = 0; i < count; i++) {
            int column = near.near[i];
            float w = PointWeight.at(near.columns, column, near.columnRadius[column], rows.px[row], rows.py[row], rows.pz[row],
                    rows.nx[row], rows.ny[row], rows.nz[row]);
            if (best.isAmong(w)
                    && !barriers.separate(points, near.point(column), rows.px[row], rows.py[row], rows.pz[row])) {
                best.insert(near.point(column), w);
            }
        }
    }

    private void write(HitRows rows, int row, short[] index, byte[] weight) {
        if (best.isEmpty()) {
            lastNearest = groups.nearest(barriers, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row],
                    lastNearest);
            best.writeOnly(row, lastNearest, index, weight);
        } else {
            best.write(row, points, radius, null, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], index,
                    weight);
        }
    }
}

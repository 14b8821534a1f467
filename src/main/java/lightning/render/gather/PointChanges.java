package lightning.render.gather;

import java.util.Arrays;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.GatherPoints;
import lightning.render.gather.point.PointGroups;
import lightning.render.gather.ray.KnownRays;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Difference between the gather points before and after an edit. Points with the same place, normal, radius and barriers are unchanged if they
 * also keep their order, which breaks ties between equal weights. Rows that no changed point reaches keep their weights. Thread-safe.
 *
 * @param newNumber new number of each old point; −1 for a changed one
 * @param removed   changed points before
 * @param added     changed points after
 */
public record PointChanges(GatherStructure before, GatherStructure after, int[] newNumber, PointGroups removed, PointGroups added) {
    /** Returns the difference between two structures, whose pictures have the same camera and settings. */
    public static PointChanges between(GatherStructure before, GatherStructure after) {
        return between(before, after, new KnownRays(before.points().sources(), before.pointLinks()));
    }

    /** @param known rays of the gather points before */
    public static PointChanges between(GatherStructure before, GatherStructure after, KnownRays known) {
        GatherPoints old = before.points();
        GatherPoints now = after.points();
        int[] newNumber = new int[old.count()];
        Arrays.fill(newNumber, -1);
        boolean[] isKept = new boolean[now.count()];
        int last = -1;
        for (int p = 0; p < now.count(); p++) {
            int o = known.find(now.sources(), p);
            if (o > last && old.radius()[o] == now.radius()[p] && old.barriers().areSame(o, now.barriers(), p)) {
                newNumber[o] = p;
                isKept[p] = true;
                last = o;
            }
        }
        boolean[] isRemoved = new boolean[old.count()];
        boolean[] isAdded = new boolean[now.count()];
        for (int o = 0; o < isRemoved.length; o++) {
            isRemoved[o] = newNumber[o] < 0;
        }
        for (int p = 0; p < isAdded.length; p++) {
            isAdded[p] = !isKept[p];
        }
        return new PointChanges(before, after, newNumber, groups(old, isRemoved), groups(now, isAdded));
    }

    private static PointGroups groups(GatherPoints points, boolean[] selected) {
        SurfaceColumns surface = new SurfaceColumns();
        float[] radius = new float[points.count()];
        for (int p = 0; p < points.count(); p++) {
            if (selected[p]) {
                radius[surface.count] = points.radius()[p];
                surface.add(points.surface(), p);
            }
        }
        return new PointGroups(surface, radius);
    }

    /**
     * Returns the weights of rows after the edit, with those of reflection points found again.
     *
     * @param weights of the same rows before
     * @param weigher finds the points after the edit
     * @return null if those of gather points may differ
     */
    public @Nullable RowWeights keep(RowWeights weights, HitRows rows, RowWeigher weigher) {
        if (weights.structure() != before || before.pointCount() == 0 || rows.count == 0) {
            return null;
        }
        float[] box = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY,
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        for (int row = 0; row < rows.count; row++) {
            enlarge(box, 0, rows.px[row]);
            enlarge(box, 1, rows.py[row]);
            enlarge(box, 2, rows.pz[row]);
        }
        return removed.reaches(box) || added.reaches(box) || mayHaveOtherNearest(weights, rows) ? null
                : weights.renumbered(after, newNumber, rows, weigher);
    }

    private static void enlarge(float[] box, int axis, float place) {
        box[axis] = Math.min(box[axis], place);
        box[3 + axis] = Math.max(box[3 + axis], place);
    }

    /** Returns whether a row that no point reaches may take its light from another point than before. */
    private boolean mayHaveOtherNearest(RowWeights weights, HitRows rows) {
        int[] onlyPoints = weights.onlyPoints();
        for (int row = 0; row < rows.count; row++) {
            int only = onlyPoints[row];
            if (only >= 0 && (newNumber[only] < 0 || added.isAnyNearer(
                    before.points().distance(only, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row]),
                    rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row]))) {
                return true;
            }
        }
        return false;
    }
}

package lightning.render.gather.build;

import java.util.stream.IntStream;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.tree.BoxSet;
import org.jspecify.annotations.Nullable;

/** Finds where rays may meet something else than before an edit, or where they go on. */
final class PathChanges {
    /** With more boxes their tests cost as much as rays. */
    private static final int MAX_BOXES = 256;

    private PathChanges() {}

    /**
     * Returns the boxes of changed objects before and after an edit, and of those that rays pass; null if there are too many.
     *
     * @param geometry    geometry before the edit
     * @param shapes      edit of the shapes
     * @param after       geometry after the edit
     * @param followsRays whether rays go on at mirrors
     */
    static @Nullable BoxSet of(Geometry geometry, ShapeChange shapes, Geometry after, boolean followsRays) {
        BoxSet changes = shapes.visibleChanges().union(changedMaterials(geometry, geometry, after, followsRays))
                .union(changedMaterials(after, geometry, after, followsRays));
        return changes.count() > MAX_BOXES ? null : changes;
    }

    /** Returns whether rays pass all materials as before, and surfels have the same textures. */
    static boolean areNone(MaterialTable before, MaterialTable after) {
        return before.count() == after.count() && IntStream.range(0, after.count()).allMatch(m -> before.hasSamePaths(m, after));
    }

    /** Returns the boxes of the primitives of a geometry that rays pass, or whose materials changed in what rays and surfels read. */
    private static BoxSet changedMaterials(Geometry of, Geometry geometry, Geometry after, boolean followsRays) {
        MaterialTable old = geometry.materials();
        MaterialTable now = after.materials();
        boolean[] changed = new boolean[now.count()];
        for (int m = 0; m < changed.length; m++) {
            changed[m] = now.isTransparent(m) || followsRays && now.material(m).mirrorTint() != null
                    || m < old.count() && !old.hasSamePaths(m, now);
        }
        int[] primitives = new int[of.primitiveCount()];
        int count = 0;
        for (int p = 0; p < primitives.length && count <= MAX_BOXES; p++) {
            if (changed[of.materialIndex(p)] || of.isLightFace(p)) {
                primitives[count++] = p;
            }
        }
        return of.boxes(primitives, count);
    }
}

package lightning.render.trace;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveBoxes;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.Scene;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Difference between the primitives of two geometries seen from the same position. A ray that touches none of the boxes here
 * hits the same primitive in both. Immutable and thread-safe.
 *
 * <p>Shapes are matched by name. A primitive is unchanged if all values that rays read of it have the same bits; unchanged
 * primitives keep their order, which breaks ties between equal distances. Boxes contain every point at which a ray can hit a
 * primitive, including rounding errors ({@link PrimitiveBoxes}). So a ray that touches no box of a changed primitive, before or
 * after, misses all of these. Among the others it hits the same one at the same distance, whatever the topology of the BVHs.
 *
 * <p>A shadow ray to a light on a surface does not hit that surface at its end ({@link ShadowRayTarget}). This depends on the
 * primitive, the point, and the primitive's padded box, which depends on the extent of the whole scene. {@link #hasSameTarget}
 * checks that it is unchanged.
 *
 * @param before         old geometry; null if there is no difference
 * @param after          new geometry; null if there is no difference
 * @param newIndex       for each old primitive its new index, possibly with another material, other normals or without colors; −1 if it is
 *                       removed or changed
 * @param hasUnchanged   whether any primitive is completely unchanged, including its material
 * @param hasSameIndices whether every unchanged primitive keeps its index
 * @param visibleChanges boxes in which camera rays and reflected rays may have other hits
 * @param removedBoxes   boxes in which blocked shadow rays may become free; no others may
 * @param addedBoxes     boxes in which free shadow rays may become blocked; no others may
 * @param tintChanges    boxes in which the transmittance of free shadow rays may change
 */
public record ShapeChange(@Nullable Geometry before, @Nullable Geometry after, int[] newIndex, boolean hasUnchanged, boolean hasSameIndices,
        BoxSet visibleChanges, BoxSet removedBoxes, BoxSet addedBoxes, BoxSet tintChanges) {
    /** No difference. */
    public static final ShapeChange NONE =
            new ShapeChange(null, null, new int[0], true, true, BoxSet.NONE, BoxSet.NONE, BoxSet.NONE, BoxSet.NONE);

    /** @param before geometry whose materials keep their indices in {@code after} */
    static ShapeChange of(Geometry before, Geometry after) {
        Map<String, Integer> indexByName = new HashMap<>();
        int count = before.primitiveCount();
        int prefixLength = commonPrefix(before, after);
        for (int s = prefixLength; s < count; s++) {
            indexByName.put(before.shape(s).name(), s);
        }
        int[] newIndex = new int[count];
        Arrays.fill(newIndex, -1);
        int[] added = new int[after.primitiveCount()];
        int[] restyled = new int[after.primitiveCount()];
        int addedCount = 0;
        int restyledCount = 0;
        int last = -1;
        for (int t = 0; t < after.primitiveCount(); t++) {
            int s = t < prefixLength ? t : indexByName.getOrDefault(after.shape(t).name(), -1);
            boolean sameGeometry = s > last && before.primitives().hasSameGeometry(s, after.primitives(), t);
            if (sameGeometry) {
                last = s;
                newIndex[s] = t;
            } else if (after.isSeen(t)) {
                added[addedCount++] = t;
            }
            if (sameGeometry && (before.isSeen(s) != after.isSeen(t) || before.materialIndex(s) != after.materialIndex(t)
                    || before.primitives().hasVertexColors(s) != after.primitives().hasVertexColors(t)
                    || !before.primitives().hasSameNormals(s, after.primitives(), t)
                    || !before.primitives().refractsLike(s, after.primitives(), t))) {
                restyled[restyledCount++] = t;
            }
        }
        int[] removed = new int[count];
        int removedCount = 0;
        int changedCount = restyledCount;
        for (int s = 0; s < count; s++) {
            if (newIndex[s] < 0) {
                changedCount++;
                if (before.isSeen(s)) {
                    removed[removedCount++] = s;
                }
            }
        }
        BoxSet removedBoxes = before.boxes(removed, removedCount);
        BoxSet addedBoxes = after.boxes(added, addedCount);
        return new ShapeChange(before, after, newIndex, changedCount < count,
                IntStream.range(0, count).allMatch(s -> newIndex[s] < 0 || newIndex[s] == s),
                removedBoxes.union(addedBoxes).union(after.boxes(restyled, restyledCount)), removedBoxes, addedBoxes, BoxSet.NONE);
    }

    /**
     * Returns the difference for shadow rays to a light with shadow links. Primitives that cast no shadows count as absent,
     * which is exact: a BVH without them gives the same answers as one that skips them.
     *
     * @param previous old geometry
     * @param from old shadow links
     * @param to new shadow links
     */
    public ShapeChange shadowChange(Geometry previous, ShapeLinks from, ShapeLinks to) {
        Geometry next = after(previous);
        boolean unchanged = from.isAll() && to.isAll() && previous.shadowGeometry(from) == previous && next.shadowGeometry(to) == next;
        if (unchanged || before == null && from.equals(to)) {
            return this;
        }
        boolean[] oldCasters = previous.shadowCasters(from);
        boolean[] newCasters = next.shadowCasters(to);
        int[] removed = new int[oldCasters.length];
        int removedCount = 0;
        boolean[] kept = new boolean[newCasters.length];
        for (int s = 0; s < oldCasters.length; s++) {
            int t = before == null ? s : newIndex[s];
            if (oldCasters[s] && t >= 0 && newCasters[t]) {
                kept[t] = true;
            } else if (oldCasters[s]) {
                removed[removedCount++] = s;
            }
        }
        int[] added = IntStream.range(0, newCasters.length).filter(t -> newCasters[t] && !kept[t]).toArray();
        BoxSet oldBoxes = previous.boxes(removed, removedCount);
        BoxSet newBoxes = next.boxes(added, added.length);
        BoxSet tints = tintChanges(previous, next, from, to);
        return new ShapeChange(before, after, newIndex, hasUnchanged, hasSameIndices, oldBoxes.union(newBoxes).union(tints), oldBoxes,
                newBoxes, tints);
    }

    /** Returns the boxes in which the transmission of light through shapes starts, ends or changes. */
    private BoxSet tintChanges(Geometry previous, Geometry next, ShapeLinks from, ShapeLinks to) {
        boolean[] oldTints = previous.tintCasters(from);
        boolean[] newTints = next.tintCasters(to);
        int[] removed = new int[oldTints == null ? 0 : oldTints.length];
        int removedCount = 0;
        boolean[] kept = new boolean[next.primitiveCount()];
        for (int s = 0; oldTints != null && s < oldTints.length; s++) {
            int t = before == null ? s : newIndex[s];
            if (oldTints[s] && t >= 0 && newTints != null && newTints[t]
                    && previous.primitives().hasSameShadowTint(s, next.primitives(), t)) {
                kept[t] = true;
            } else if (oldTints[s]) {
                removed[removedCount++] = s;
            }
        }
        int[] added = newTints == null ? new int[0] : IntStream.range(0, newTints.length).filter(t -> newTints[t] && !kept[t]).toArray();
        return previous.boxes(removed, removedCount).union(next.boxes(added, added.length));
    }

    /** Returns the number of leading primitives with the same names. */
    private static int commonPrefix(Geometry before, Geometry after) {
        int minCount = Math.min(before.primitiveCount(), after.primitiveCount());
        int s = 0;
        while (s < minCount && before.shape(s).name().equals(after.shape(s).name())) {
            s++;
        }
        return s;
    }

    /**
     * Returns the new geometry.
     *
     * @param previous old geometry
     */
    public Geometry after(Geometry previous) {
        return after == null ? previous : after;
    }

    /** Returns whether all rays hit the same surfaces: only names of groups or invisible shapes differ. */
    public boolean isEmpty() {
        return visibleChanges.isEmpty();
    }

    /**
     * Returns the new indices of primitives, −1 for none. A ray that touches no box of {@link #visibleChanges} hit a primitive
     * that has one.
     */
    public int[] mapIndices(int[] primitives) {
        if (before == null) {
            return primitives;
        }
        int[] mapped = new int[primitives.length];
        for (int i = 0; i < mapped.length; i++) {
            mapped[i] = primitives[i] < 0 ? -1 : newIndex[primitives[i]];
        }
        return mapped;
    }

    /** Tests a pair of indices of a primitive, before and after. */
    public interface IndexPairTest {
        boolean test(int before, int after);
    }

    /**
     * Returns whether a test holds for the indices of all unchanged primitives.
     *
     * @param count number of primitives before
     */
    public boolean allKept(int count, IndexPairTest test) {
        return IntStream.range(0, count)
                .allMatch(s -> before == null ? test.test(s, s) : newIndex[s] < 0 || test.test(s, newIndex[s]));
    }

    /** Returns whether the unchanged primitives are linked as before. */
    public boolean hasSameLinks(Scene previous, Scene target, ShapeLinks links) {
        if (before == null || links.isAll()) {
            return true;
        }
        boolean[] oldLinks = previous.stage().linkMask(links);
        boolean[] newLinks = target.stage().linkMask(links);
        return IntStream.range(0, newIndex.length).allMatch(s -> newIndex[s] < 0 || oldLinks[s] == newLinks[newIndex[s]]);
    }

    /** Returns whether shadow rays to a point in render space end on the same unchanged primitives as before. */
    public boolean hasSameTarget(Vec3 point) {
        return before == null || after == null
                || before.shadowRayTarget(point).hasSameContacts(after.shadowRayTarget(point), s -> newIndex[s], this::existedBefore);
    }

    /** Returns whether a new primitive existed before. */
    private boolean existedBefore(int primitive) {
        for (int s : newIndex) {
            if (s == primitive) {
                return true;
            }
        }
        return false;
    }
}

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
import lightning.scene.ShapeLinks;

/**
 * Which primitives differ between two geometries that are seen from the same place, and where: what rays of the one met that
 * touch none of the boxes here, rays of the other meet too. Immutable; shared between threads.
 *
 * <p>Shapes are told by their names. A primitive is the same where all that rays read of it has the same bits, and where those
 * that are the same have the same order, which decides among equal distances. Let a ray touch no box of a primitive that is not the
 * same, neither here nor there: boxes hold all that rays can meet of a primitive, whatever rounds ({@link PrimitiveBoxes}), so it
 * meets none of these, and of the others the same one at the same distance, whatever form the trees have.
 *
 * <p>A way to a light on a surface does not meet that surface at its end ({@link ShadowRayTarget}). That is a matter of the primitive, the
 * point, and of its padded box, which depends on how far the whole scene reaches: {@link #hasSameTarget} tells whether it is as before.
 */
public final class ShapeChange {
    /** The same shapes before and after. */
    public static final ShapeChange NONE = new ShapeChange();

    private final Geometry before;
    private final Geometry after;
    /** Of each primitive before the index it has now, perhaps with another material, other normals or without its colors; −1 where it is gone or not the same. */
    private final int[] newIndex;
    private final boolean hasUnchanged;
    private final boolean hasSameIndices;
    private final BoxSet visibleChanges;
    private final BoxSet removedBoxes;
    private final BoxSet addedBoxes;
    private final BoxSet tintChanges;

    private ShapeChange() {
        before = null;
        after = null;
        newIndex = new int[0];
        hasUnchanged = true;
        hasSameIndices = true;
        visibleChanges = BoxSet.NONE;
        removedBoxes = BoxSet.NONE;
        addedBoxes = BoxSet.NONE;
        tintChanges = BoxSet.NONE;
    }

    /** @param before its materials keep their indices in {@code after} */
    ShapeChange(Geometry before, Geometry after) {
        this.before = before;
        this.after = after;
        Map<String, Integer> indexByName = new HashMap<>();
        int count = before.primitiveCount();
        int prefixLength = commonPrefix();
        for (int s = prefixLength; s < count; s++) {
            indexByName.put(before.shape(s).name(), s);
        }
        newIndex = new int[count];
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
            } else {
                added[addedCount++] = t;
            }
            if (sameGeometry && (before.materialIndex(s) != after.materialIndex(t)
                    || before.primitives().hasVertexColors(s) != after.primitives().hasVertexColors(t)
                    || !before.primitives().hasSameNormals(s, after.primitives(), t)
                    || !before.primitives().refractsLike(s, after.primitives(), t))) {
                restyled[restyledCount++] = t;
            }
        }
        int[] removed = new int[count];
        int removedCount = 0;
        for (int s = 0; s < count; s++) {
            if (newIndex[s] < 0) {
                removed[removedCount++] = s;
            }
        }
        hasUnchanged = removedCount + restyledCount < count;
        hasSameIndices = IntStream.range(0, count).allMatch(s -> newIndex[s] < 0 || newIndex[s] == s);
        this.removedBoxes = BoxSet.of(before.bvh(), removed, removedCount);
        this.addedBoxes = BoxSet.of(after.bvh(), added, addedCount);
        tintChanges = BoxSet.NONE;
        visibleChanges = this.removedBoxes.union(this.addedBoxes).union(BoxSet.of(after.bvh(), restyled, restyledCount));
    }

    /** The change of ways to a light alone. */
    private ShapeChange(ShapeChange source, BoxSet removed, BoxSet added, BoxSet tintBoxes) {
        before = source.before;
        after = source.after;
        newIndex = source.newIndex;
        hasUnchanged = source.hasUnchanged;
        hasSameIndices = source.hasSameIndices;
        this.removedBoxes = removed;
        this.addedBoxes = added;
        this.tintChanges = tintBoxes;
        visibleChanges = removed.union(added).union(tintBoxes);
    }

    /**
     * What becomes of the ways to a light that only some shapes shadow: the same where a primitive that throws no shadow counts as
     * none. Of a tree that lacks it, rays find what this one's would if it were not there.
     *
     * @param previous what rays could meet before
     * @param from  the shapes that threw shadows
     * @param to    those that throw them now
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
        return new ShapeChange(this, BoxSet.of(previous.bvh(), removed, removedCount), BoxSet.of(next.bvh(), added, added.length),
                tintChanges(previous, next, from, to));
    }

    /** Where light passes shapes as it did not, or passes no more, or otherwise. */
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
        return BoxSet.of(previous.bvh(), removed, removedCount).union(BoxSet.of(next.bvh(), added, added.length));
    }

    /** How many primitives, the first ones, have the same names. */
    private int commonPrefix() {
        int minCount = Math.min(before.primitiveCount(), after.primitiveCount());
        int s = 0;
        while (s < minCount && before.shape(s).name().equals(after.shape(s).name())) {
            s++;
        }
        return s;
    }

    /**
     * What rays can meet afterwards.
     *
     * @param previous what they could meet before
     */
    public Geometry after(Geometry previous) {
        return after == null ? previous : after;
    }

    /** Whether any primitive stays as it is, its material too. */
    public boolean hasUnchanged() {
        return hasUnchanged;
    }

    /** Whether rays meet what they met: only names of groups are others, or shapes that nobody sees. */
    public boolean isEmpty() {
        return visibleChanges.isEmpty();
    }

    /** Where eye rays and mirrored rays may find something else than before. */
    public BoxSet visibleChanges() {
        return visibleChanges;
    }

    /** Where ways to lights that were blocked may be free: no other may. */
    public BoxSet removedBoxes() {
        return removedBoxes;
    }

    /** Where ways to lights that were free may be blocked: no other may. */
    public BoxSet addedBoxes() {
        return addedBoxes;
    }

    /** Where what passes of the light of free ways may be another. */
    public BoxSet tintChanges() {
        return tintChanges;
    }

    /** Whether every primitive that is the same has the index that it had. */
    public boolean hasSameIndices() {
        return hasSameIndices;
    }

    /** The indices that primitives have now, −1 for none; a ray that touches no box of {@link #visibleChanges} met one that has one. */
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

    /** Whether the primitives that are the same are linked as they were. */
    public boolean hasSameLinks(Scene previous, Scene target, ShapeLinks links) {
        if (before == null || links.isAll()) {
            return true;
        }
        boolean[] oldLinks = previous.stage().linkMask(links);
        boolean[] newLinks = target.stage().linkMask(links);
        return IntStream.range(0, newIndex.length).allMatch(s -> newIndex[s] < 0 || oldLinks[s] == newLinks[newIndex[s]]);
    }

    /** Whether ways to a point in render space pass the same ends of those primitives that cast the same shadows. */
    public boolean hasSameTarget(Vec3 point) {
        return before == null
                || before.shadowRayTarget(point).hasSameContacts(after.shadowRayTarget(point), s -> newIndex[s], this::existedBefore);
    }

    /** Whether a primitive of now was there before. */
    private boolean existedBefore(int primitive) {
        for (int s : newIndex) {
            if (s == primitive) {
                return true;
            }
        }
        return false;
    }
}

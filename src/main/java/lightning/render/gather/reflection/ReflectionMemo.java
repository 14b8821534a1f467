package lightning.render.gather.reflection;

import java.util.Arrays;
import java.util.Objects;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.RayLinks;
import lightning.render.lobe.RoughLobes;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Paths of reflections before an edit of materials or objects. Rays of points whose own material reflects as before meet what they met, unless they may
 * meet a changed object, and are not cast again. Immutable.
 */
public final class ReflectionMemo {
    /** No point. */
    static final int NONE = -1;

    private final ReflectionPaths before;
    private final ReflectionOrigins origins;
    /** Key of the cell of each surfel; that of a part is unused. */
    private final long[] surfelKeys;
    /** Boxes of what rays may meet otherwise than before. */
    private final BoxSet changes;
    /** Open hash table of the points whose materials reflect as before; {@link #NONE} in an empty slot. */
    private final int[] slots;

    private ReflectionMemo(ReflectionPaths before, long[] surfelKeys, BoxSet changes) {
        this.before = before;
        origins = before.origins();
        this.surfelKeys = surfelKeys;
        this.changes = changes;
        slots = new int[Integer.highestOneBit(Math.max(1, origins.seed().length)) * 4];
        Arrays.fill(slots, NONE);
    }

    /**
     * Returns the paths of a picture with the same settings and the same indices of shapes; null if rays of all materials may meet something else.
     *
     * @param surfelKeys key of the cell of each surfel
     * @param changes    boxes of changed objects, before and after, and of those where rays go on
     * @param shapes     edit of the shapes
     * @param after      materials after the edit
     * @param glows      objects that are shown glowing after it
     */
    public static @Nullable ReflectionMemo of(@Nullable ReflectionPaths before, long[] surfelKeys, BoxSet changes, ShapeChange shapes,
            MaterialTable materials, MaterialTable after, GlowShapes glows) {
        if (before == null || materials.count() != after.count() || !before.glows().areSame(glows) || before.glows().haveChanged(shapes)) {
            return null;
        }
        var memo = new ReflectionMemo(before, surfelKeys, changes);
        for (int m = 0; m < after.count(); m++) {
            Material old = materials.material(m);
            Material now = after.material(m);
            if (!areMetAlike(old, now) || !materials.hasSamePaths(m, after)) {
                return null;
            }
            ReflectionGroup group = before.group(m);
            if (group != null && castAlike(old, now)) {
                memo.add(group.number);
            }
        }
        return memo;
    }

    private void add(int[] points) {
        for (int p : points) {
            int slot = slot(before.points(), origins.seed()[p], p);
            slots[slot] = slots[slot] == NONE ? p : slots[slot];
        }
    }

    /** Returns the slot of a point that is equal to one of some points, or the empty one where it belongs. */
    private int slot(ReflectionPoints of, long seed, int p) {
        SurfaceColumns s = of.surface();
        int slot = CellKeys.rank(seed, s.px[p], s.py[p], s.pz[p], 0) & slots.length - 1;
        while (slots[slot] != NONE && !isSame(slots[slot], of, seed, p)) {
            slot = slot + 1 & slots.length - 1;
        }
        return slot;
    }

    /** Returns the known point at the place of another, with its view and its directions; {@link #NONE} if there is none. */
    int find(ReflectionPoints now, int p) {
        return slots[slot(now, now.seed[p], p)];
    }

    /** Returns whether rays may meet something else than before. */
    boolean hasChanges() {
        return !changes.isEmpty();
    }

    /** Returns whether a ray may meet something else than before. */
    boolean mayChange(BoxRay ray) {
        return changes.intersects(ray, Double.POSITIVE_INFINITY);
    }

    /** Returns whether rays of blurred reflections start from and end at both materials in the same way. */
    public static boolean reflectAlike(Material a, Material b) {
        return a == b || castAlike(a, b) && areMetAlike(a, b);
    }

    private static boolean castAlike(Material a, Material b) {
        return a == b || Objects.equals(RoughLobes.of(a), RoughLobes.of(b)) && a.roughness() == b.roughness()
                && a.surfaceMaps().hasSameRoughness(b.surfaceMaps());
    }

    private static boolean areMetAlike(Material a, Material b) {
        return a == b || Objects.equals(a.mirrorTint(), b.mirrorTint()) && a.isFrosted() == b.isFrosted();
    }

    private boolean isSame(int known, ReflectionPoints now, long seed, int p) {
        ReflectionPoints old = before.points();
        SurfaceColumns s = old.surface();
        SurfaceColumns t = now.surface();
        return origins.seed()[known] == seed && s.px[known] == t.px[p] && s.py[known] == t.py[p] && s.pz[known] == t.pz[p]
                && s.nx[known] == t.nx[p] && s.ny[known] == t.ny[p] && s.nz[known] == t.nz[p] && s.primitive[known] == t.primitive[p]
                && old.seen.vx[known] == now.seen.vx[p] && old.seen.vy[known] == now.seen.vy[p] && old.seen.vz[known] == now.seen.vz[p]
                && old.seen.roughness[known] == now.seen.roughness[p];
    }

    /**
     * Returns a copy of a known point.
     *
     * @param k number of the copy, 1 or more
     * @return {@link #NONE} if there were fewer
     */
    int copy(int known, int k) {
        int copy = origins.firstCopy()[known] + k - 1;
        int end = known + 1 < origins.firstCopy().length ? origins.firstCopy()[known + 1] : before.links().points();
        return copy < end ? copy : NONE;
    }

    /** Returns the sum of {@link lightning.render.gather.ray.InverseLengths} of a known point. */
    long inverseLengths(int known) {
        return origins.inverseLengths()[known];
    }

    /** Writes the rays of a known point or copy as those of a point. */
    void write(int known, ReflectionLinks to, int p) {
        before.links().copy(known, to, p, this);
    }

    /** Returns the number of surfels before the edit, with their parts. */
    int surfelCount() {
        return surfelKeys.length;
    }

    /** Returns the number of the surfel of which one is a part, or its own. */
    private int whole(int surfel) {
        int first = surfelCount() - before.surfelOfDetail().length;
        return surfel < first ? surfel : before.surfelOfDetail()[surfel - first];
    }

    /** Returns the key of the cell of a surfel or of that of which it is a part. */
    long key(int surfel) {
        return surfelKeys[whole(surfel)];
    }

    /** Returns the key of a surfel's own part. */
    long partKey(int surfel) {
        int first = surfelCount() - before.surfelOfDetail().length;
        return surfel < first ? surfelKeys[surfel] : origins.partKeys()[surfel - first];
    }

    /**
     * Returns the surfel before the edit that a ray met.
     *
     * @param isPart whether parts of surfels are wanted
     * @return {@link RayLinks#MISS} if it met none
     */
    int surfel(int ray, boolean isPart) {
        int number = number(ray);
        return number >= surfelCount() ? RayLinks.MISS : isPart ? number : whole(number);
    }

    /** Returns the number of what a ray met: a surfel or, after all surfels, a cell of the sky. */
    int number(int ray) {
        return before.links().surfel(ray);
    }

    /** Returns the ray whose hit a surfel was; −1 for none. */
    int firstRay(int surfel) {
        return origins.firstRay()[surfel];
    }

    /** Returns the number of points with their copies. */
    int pointCount() {
        return before.links().points();
    }
}

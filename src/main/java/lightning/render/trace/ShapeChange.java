package lightning.render.trace;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveBoxes;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.Links;
import lightning.scene.Scene;

/**
 * Which primitives differ between two geometries that are seen from the same place, and where: what rays of the one met that
 * touch none of the boxes here, rays of the other meet too. Immutable; shared between threads.
 *
 * <p>Shapes are told by their names. A primitive is the same where all that rays read of it has the same bits, and where those
 * that are the same have the same order, which decides among equal distances. Let a ray touch no box of a primitive that is not the
 * same, neither here nor there: boxes hold all that rays can meet of a primitive, whatever rounds ({@link PrimitiveBoxes}), so it
 * meets none of these, and of the others the same one at the same distance, whatever form the trees have.
 *
 * <p>A way to a light on a surface does not meet that surface at its end ({@link WayEnd}). That is a matter of the primitive, the
 * point, and of its padded box, which depends on how far the whole scene reaches: {@link #keepsEnd} tells whether it is as before.
 */
public final class ShapeChange {
    /** The same shapes before and after. */
    public static final ShapeChange NONE = new ShapeChange();

    private final Geometry before;
    private final Geometry after;
    /** Of each primitive before the index it has now, perhaps with another material, other normals or without its colours; −1 where it is gone or not the same. */
    private final int[] now;
    private final boolean keepsAny;
    private final boolean keepsIndices;
    private final BoxSet seen;
    private final BoxSet gone;
    private final BoxSet come;
    private final BoxSet tints;

    private ShapeChange() {
        before = null;
        after = null;
        now = new int[0];
        keepsAny = true;
        keepsIndices = true;
        seen = BoxSet.NONE;
        gone = BoxSet.NONE;
        come = BoxSet.NONE;
        tints = BoxSet.NONE;
    }

    /** @param before its materials keep their indices in {@code after} */
    ShapeChange(Geometry before, Geometry after) {
        this.before = before;
        this.after = after;
        Map<String, Integer> places = new HashMap<>();
        int count = before.primitiveCount();
        int same = prefix();
        for (int s = same; s < count; s++) {
            places.put(before.shape(s).name(), s);
        }
        now = new int[count];
        Arrays.fill(now, -1);
        int[] come = new int[after.primitiveCount()];
        int[] painted = new int[after.primitiveCount()];
        int comeCount = 0;
        int paintedCount = 0;
        int last = -1;
        for (int t = 0; t < after.primitiveCount(); t++) {
            int s = t < same ? t : places.getOrDefault(after.shape(t).name(), -1);
            boolean form = s > last && before.primitives().isAlike(s, after.primitives(), t);
            if (form) {
                last = s;
                now[s] = t;
            } else {
                come[comeCount++] = t;
            }
            if (form && (before.materialOf(s) != after.materialOf(t)
                    || before.primitives().isTinted(s) != after.primitives().isTinted(t)
                    || !before.primitives().isBentAs(s, after.primitives(), t)
                    || !before.primitives().leadsRaysAs(s, after.primitives(), t))) {
                painted[paintedCount++] = t;
            }
        }
        int[] gone = new int[count];
        int goneCount = 0;
        for (int s = 0; s < count; s++) {
            if (now[s] < 0) {
                gone[goneCount++] = s;
            }
        }
        keepsAny = goneCount + paintedCount < count;
        keepsIndices = IntStream.range(0, count).allMatch(s -> now[s] < 0 || now[s] == s);
        this.gone = BoxSet.of(before.bvh(), gone, goneCount);
        this.come = BoxSet.of(after.bvh(), come, comeCount);
        tints = BoxSet.NONE;
        seen = this.gone.and(this.come).and(BoxSet.of(after.bvh(), painted, paintedCount));
    }

    /** The change of ways to a light alone. */
    private ShapeChange(ShapeChange of, BoxSet gone, BoxSet come, BoxSet tints) {
        before = of.before;
        after = of.after;
        now = of.now;
        keepsAny = of.keepsAny;
        keepsIndices = of.keepsIndices;
        this.gone = gone;
        this.come = come;
        this.tints = tints;
        seen = gone.and(come).and(tints);
    }

    /**
     * What becomes of the ways to a light that only some shapes shadow: the same where a primitive that throws no shadow counts as
     * none. Of a tree that lacks it, rays find what this one's would if it were not there.
     *
     * @param known what rays could meet before
     * @param from  the shapes that threw shadows
     * @param to    those that throw them now
     */
    public ShapeChange shadows(Geometry known, Links from, Links to) {
        Geometry later = after(known);
        boolean all = from.isAll() && to.isAll() && known.casting(from) == known && later.casting(to) == later;
        if (all || before == null && from.equals(to)) {
            return this;
        }
        boolean[] cast = known.casters(from);
        boolean[] casts = later.casters(to);
        int[] gone = new int[cast.length];
        int goneCount = 0;
        boolean[] stays = new boolean[casts.length];
        for (int s = 0; s < cast.length; s++) {
            int t = before == null ? s : now[s];
            if (cast[s] && t >= 0 && casts[t]) {
                stays[t] = true;
            } else if (cast[s]) {
                gone[goneCount++] = s;
            }
        }
        int[] come = IntStream.range(0, casts.length).filter(t -> casts[t] && !stays[t]).toArray();
        return new ShapeChange(this, BoxSet.of(known.bvh(), gone, goneCount), BoxSet.of(later.bvh(), come, come.length),
                tints(known, later, from, to));
    }

    /** Where light passes shapes as it did not, or passes no more, or otherwise. */
    private BoxSet tints(Geometry known, Geometry later, Links from, Links to) {
        boolean[] tint = known.tinters(from);
        boolean[] tints = later.tinters(to);
        int[] lost = new int[tint == null ? 0 : tint.length];
        int lostCount = 0;
        boolean[] stays = new boolean[later.primitiveCount()];
        for (int s = 0; tint != null && s < tint.length; s++) {
            int t = before == null ? s : now[s];
            if (tint[s] && t >= 0 && tints != null && tints[t] && known.primitives().passesLightAs(s, later.primitives(), t)) {
                stays[t] = true;
            } else if (tint[s]) {
                lost[lostCount++] = s;
            }
        }
        int[] got = tints == null ? new int[0] : IntStream.range(0, tints.length).filter(t -> tints[t] && !stays[t]).toArray();
        return BoxSet.of(known.bvh(), lost, lostCount).and(BoxSet.of(later.bvh(), got, got.length));
    }

    /** How many primitives, the first ones, have the same names. */
    private int prefix() {
        int least = Math.min(before.primitiveCount(), after.primitiveCount());
        int s = 0;
        while (s < least && before.shape(s).name().equals(after.shape(s).name())) {
            s++;
        }
        return s;
    }

    /**
     * What rays can meet afterwards.
     *
     * @param known what they could meet before
     */
    public Geometry after(Geometry known) {
        return after == null ? known : after;
    }

    /** Whether any primitive stays as it is, its material too. */
    public boolean keepsAny() {
        return keepsAny;
    }

    /** Whether rays meet what they met: only names of groups are others, or shapes that nobody sees. */
    public boolean isEmpty() {
        return seen.isEmpty();
    }

    /** Where eye rays and mirrored rays may find something else than before. */
    public BoxSet seen() {
        return seen;
    }

    /** Where ways to lights that were blocked may be free: no other may. */
    public BoxSet gone() {
        return gone;
    }

    /** Where ways to lights that were free may be blocked: no other may. */
    public BoxSet come() {
        return come;
    }

    /** Where what passes of the light of free ways may be another. */
    public BoxSet tints() {
        return tints;
    }

    /** Whether every primitive that is the same has the index that it had. */
    public boolean keepsIndices() {
        return keepsIndices;
    }

    /** The indices that primitives have now, −1 for none; a ray that touches no box of {@link #seen} met one that has one. */
    public int[] now(int[] primitives) {
        if (before == null) {
            return primitives;
        }
        int[] found = new int[primitives.length];
        for (int i = 0; i < found.length; i++) {
            found[i] = primitives[i] < 0 ? -1 : now[primitives[i]];
        }
        return found;
    }

    /** Whether the primitives that are the same are linked as they were. */
    public boolean keepsLinks(Scene known, Scene wanted, Links links) {
        if (before == null || links.isAll()) {
            return true;
        }
        boolean[] was = known.stage().linked(links);
        boolean[] is = wanted.stage().linked(links);
        return IntStream.range(0, now.length).allMatch(s -> now[s] < 0 || was[s] == is[now[s]]);
    }

    /** Whether ways to a point in render space pass the same ends of those primitives that cast the same shadows. */
    public boolean keepsEnd(Vec3 point) {
        return before == null || before.end(point).isAlike(after.end(point), s -> now[s], this::isOld);
    }

    /** Whether a primitive of now was there before. */
    private boolean isOld(int primitive) {
        for (int s : now) {
            if (s == primitive) {
                return true;
            }
        }
        return false;
    }
}

package lightning.render.gather.reflection;

import java.util.Objects;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.RayLinks;
import lightning.render.lobe.RoughLobes;
import lightning.render.trace.MaterialTable;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Paths of reflections before an edit of materials. Rays of points whose own material reflects as before meet what they met, and are not cast again.
 * Immutable.
 */
public final class ReflectionMemo {
    /** No point. */
    static final int NONE = -1;

    private final ReflectionPaths before;
    private final ReflectionOrigins origins;
    /** Key of the cell of each surfel; that of a part is unused. */
    private final long[] surfelKeys;
    /** Points of each material, ascending; none if it does not reflect as before. */
    private final int[][] points;

    private ReflectionMemo(ReflectionPaths before, long[] surfelKeys, int[][] points) {
        this.before = before;
        origins = before.origins();
        this.surfelKeys = surfelKeys;
        this.points = points;
    }

    /**
     * Returns the paths of a picture with the same shapes and settings; null if rays of other materials may meet something else as well.
     *
     * @param surfelKeys key of the cell of each surfel
     * @param after      materials after the edit
     * @param glows      objects that are shown glowing after it
     */
    public static @Nullable ReflectionMemo of(@Nullable ReflectionPaths before, long[] surfelKeys, MaterialTable materials,
            MaterialTable after,
            GlowShapes glows) {
        if (before == null || materials.count() != after.count() || !before.glows().areSame(glows)) {
            return null;
        }
        int[][] points = new int[after.count()][];
        for (int m = 0; m < points.length; m++) {
            Material old = materials.material(m);
            Material now = after.material(m);
            if (!areMetAlike(old, now) || !materials.hasSamePaths(m, after)) {
                return null;
            }
            ReflectionGroup group = before.group(m);
            points[m] = group == null || !castAlike(old, now) ? new int[0] : group.number;
        }
        return new ReflectionMemo(before, surfelKeys, points);
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

    /** Returns the number of points of a material that are known. */
    int count(int material) {
        return points[material].length;
    }

    /** Returns a known point of a material. */
    int point(int material, int number) {
        return points[material][number];
    }

    /** Returns whether a point is at the place of a known one, with its view and its directions. */
    boolean isSame(int known, ReflectionPoints now, int p) {
        ReflectionPoints old = before.points();
        SurfaceColumns s = old.surface();
        SurfaceColumns t = now.surface();
        return origins.seed()[known] == now.seed[p] && s.px[known] == t.px[p] && s.py[known] == t.py[p] && s.pz[known] == t.pz[p]
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

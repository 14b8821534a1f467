package lightning.render.gather.build;

import java.util.Arrays;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowPaths;
import lightning.render.gather.point.GatherPoints;
import lightning.render.gather.ray.KnownRays;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.rim.RimLinks;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import org.jspecify.annotations.Nullable;

/**
 * Paths of indirect light before an edit of objects or materials. A ray that meets no changed object, before or after, hits what it hit,
 * so a repetition takes its surfel from here. Immutable.
 *
 * <p>Rays that may pass a transparent object or the face of a light are cast again: their segments do not lie exactly on one line.
 */
public final class PathMemo {
    private final Geometry geometry;
    private final BoxSet changes;
    /** True if no shape changed, and no material in what rays and surfels read. */
    private final boolean unchanged;
    private final GatherPoints gatherPoints;
    private final GlowPaths glow;
    private final KnownRays points;
    private final KnownRays surfels;
    private final RimLinks rims;
    private final long[] inverseLengths;
    private final KnownSurfels known;
    /** For each surfel its first ray among those of gather points, or {@code ~ray} among those of surfels. */
    private final int[] firstRay;

    private PathMemo(GatherStructure before, KnownSurfels known, Geometry geometry, CellKeys cells, BoxSet changes,
            boolean unchanged) {
        this.geometry = geometry;
        this.changes = changes;
        this.unchanged = unchanged;
        gatherPoints = before.points();
        glow = before.glow();
        rims = before.rims();
        inverseLengths = before.points().inverseLengths();
        int count = before.surfelCount();
        this.known = known;
        points = new KnownRays(before.points().sources(), before.pointLinks());
        surfels = new KnownRays(before.surfelSources(cells, known.places()), before.surfelLinks());
        firstRay = new int[count];
        Arrays.fill(firstRay, Integer.MAX_VALUE);
        int found = setFirstRays(before.points().sources(), before.pointLinks(), 0, before.pointCount(), 0, 0);
        RaySources surfelSources = before.surfelSources(cells, known.places());
        ReflectionPaths reflections = before.reflections();
        // Rays of reflections find surfels after those of gather points.
        found = reflections == null ? found : Math.max(found, reflections.foundSurfels(count));
        for (int from = 0, to = found; from < before.surfelLinks().points();) {
            found = setFirstRays(surfelSources, before.surfelLinks(), from, to, to, -1);
            from = to;
            to = found;
        }
    }

    /**
     * Finds the first ray of each surfel that the rays of some points found.
     *
     * @param first  first of these surfels; the others were found before or after
     * @param flip   −1 for the rays of surfels, 0 for those of gather points
     * @return number of surfels found so far
     */
    private int setFirstRays(RaySources sources, RayLinks links, int from, int to, int first, int flip) {
        int found = first;
        int[] lowest = new int[firstRay.length - first];
        for (int p = from; p < to; p++) {
            long seed = sources.seed(p);
            for (int k = 0; k < links.raysPerPoint(); k++) {
                int ray = p * links.raysPerPoint() + k;
                int surfel = links.surfel(ray);
                if (surfel >= first) {
                    int rank = sources.rank(p, seed, k);
                    if (firstRay[surfel] == Integer.MAX_VALUE || rank < lowest[surfel - first]) {
                        firstRay[surfel] = ray ^ flip;
                        lowest[surfel - first] = rank;
                    }
                    found = Math.max(found, surfel + 1);
                }
            }
        }
        return found;
    }

    /**
     * Returns the paths of a picture with the same camera and the same settings; null if too many objects changed.
     *
     * @param known    its surfels
     * @param geometry geometry before the edit
     * @param shapes   edit of the shapes
     * @param after    geometry after the edit
     */
    static @Nullable PathMemo of(GatherStructure before, KnownSurfels known, Geometry geometry, ShapeChange shapes, Geometry after,
            CellKeys cells) {
        BoxSet changes = PathChanges.of(geometry, shapes, after, false);
        return changes == null ? null
                : new PathMemo(before, known, geometry, cells, changes,
                        shapes == ShapeChange.NONE && PathChanges.areNone(geometry.materials(), after.materials()));
    }

    /** Returns whether every ray meets what it met: no shape changed, and no material in what rays and surfels read. */
    boolean isUnchanged() {
        return unchanged;
    }

    /** Returns the paths from small glowing objects. */
    GlowPaths glow() {
        return glow;
    }

    /** Returns the gather points if those after the edit are the same in the same order, and their rays meet what they met; otherwise null. */
    @Nullable
    GatherPoints samePoints(RaySources now) {
        boolean isSame = unchanged && now.surface.count == gatherPoints.count();
        for (int p = 0; isSame && p < gatherPoints.count(); p++) {
            isSame = points.find(now, p) == p;
        }
        return isSame ? gatherPoints : null;
    }

    /** Returns the geometry before the edit. */
    public Geometry geometry() {
        return geometry;
    }

    KnownRays points() {
        return points;
    }

    KnownRays surfels() {
        return surfels;
    }

    /** Returns the additional rays of the points. */
    RimLinks rims() {
        return rims;
    }

    /** Returns the sum of {@link lightning.render.gather.ray.InverseLengths} of a gather point. */
    long inverseLengths(int point) {
        return inverseLengths[point];
    }

    /** Returns whether a ray may hit another surface than before, or pass a transparent one. */
    boolean mayChange(BoxRay ray) {
        return changes.intersects(ray, Double.POSITIVE_INFINITY);
    }

    /** Returns the places of the surfels, by number. */
    SurfaceColumns places() {
        return known.places();
    }

    /** Returns the key of a surfel's cell after the edit. */
    long key(int surfel) {
        return known.keys()[surfel];
    }

    /** Returns whether a surfel is the hit of a ray of a gather point. */
    boolean isFirstOfPoints(int surfel, int ray) {
        return firstRay[surfel] == ray;
    }

    /** Returns whether a surfel is the hit of a ray of a surfel. */
    boolean isFirstOfSurfels(int surfel, int ray) {
        return firstRay[surfel] == ~ray;
    }
}

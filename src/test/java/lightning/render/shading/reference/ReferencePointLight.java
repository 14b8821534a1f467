package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.BarrierFinder;
import lightning.render.gather.point.Barriers;
import lightning.render.gather.point.LinearWeights;
import lightning.render.gather.point.PointWeight;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;

/** Spreads the light of gather points over the surfaces between them, for {@link ReferenceTracer}. */
final class ReferencePointLight {
    private static final float FILTER_CELLS = 8;
    private static final float FILTER_SHARE = 0.25f;
    private static final float FILTER_RADII = 2;
    private static final float FLAT_FILTER_RADII = 4;
    private static final int BEST = 8;
    private static final int MAX_WEIGHT = 255;
    private static final int MIN_WEIGHT = 4;
    private static final float NO_OVERFLOW = 0x1p-24f;

    private final List<ReferenceGatherPoints.GatherPoint> points;
    private final SurfaceColumns surfaces = new SurfaceColumns();
    /** Light of each point after the filter: red, green, blue. */
    private final float[][] light;

    private record Weighted(int point, float weight) {}

    /** Barriers of each point. */
    private final List<Barriers> barriers = new ArrayList<>();

    /**
     * @param targets  surfel that each ray of each point hits; null for none
     * @param gathered light at each point: red, green, blue
     */
    ReferencePointLight(List<ReferenceGatherPoints.GatherPoint> points, List<List<SurfacePoint>> targets, Geometry geometry,
            float[][] gathered) {
        this.points = points;
        for (ReferenceGatherPoints.GatherPoint point : points) {
            SurfacePoint at = point.at();
            surfaces.add(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), at.primitive());
        }
        for (int p = 0; p < points.size(); p++) {
            barriers.add(barriers(p, targets.get(p), geometry));
        }
        light = new float[points.size()][];
        for (int p = 0; p < light.length; p++) {
            light[p] = mean(neighbors(p), gathered);
        }
    }

    private Barriers barriers(int p, List<SurfacePoint> targets, Geometry geometry) {
        BarrierFinder finder = new BarrierFinder(targets.size());
        for (int k = 0; k < targets.size(); k++) {
            SurfacePoint target = targets.get(k);
            if (target != null && !geometry.hasBentNormals(target.primitive())) {
                Vec3 direction = points.get(p).rays().get(k).direction();
                finder.dx[k] = direction.x();
                finder.dy[k] = direction.y();
                finder.dz[k] = direction.z();
                finder.setHit(k, target.px(), target.py(), target.pz(), target.nx(), target.ny(), target.nz());
            }
        }
        return Barriers.ofPoint(finder, surfaces, p, points.get(p).radius());
    }

    private boolean isSeparate(int p, SurfacePoint place) {
        return barriers.get(p).separate(surfaces, p, place.px(), place.py(), place.pz());
    }

    /** Returns the weighted mean of some points' values: red, green, blue. */
    private static float[] mean(List<Weighted> points, float[][] values) {
        float total = 0;
        float[] sum = new float[values.length == 0 ? 0 : values[0].length];
        for (Weighted point : points) {
            total += point.weight;
            for (int c = 0; c < sum.length; c++) {
                sum[c] += point.weight * NO_OVERFLOW * values[point.point][c];
            }
        }
        float share = total == 0 ? 0 : 1 / (total * NO_OVERFLOW);
        for (int c = 0; c < sum.length; c++) {
            sum[c] *= share;
        }
        return sum;
    }

    private float reach(int p, boolean isFlat) {
        ReferenceGatherPoints.GatherPoint point = points.get(p);
        float open = FILTER_CELLS * point.side();
        float reach = Math.max(FILTER_RADII * point.radius(), Math.min(open, FILTER_SHARE * point.harmonic()));
        return isFlat ? Math.max(reach, Math.min(FLAT_FILTER_RADII * point.radius(), open)) : reach;
    }

    /** Returns the points whose mean is a point's light, with whole weights up to 255. */
    private List<Weighted> neighbors(int p) {
        SurfacePoint at = points.get(p).at();
        List<Weighted> found = new ArrayList<>();
        for (int n = 0; n < points.size(); n++) {
            float share = points.get(n).radius() / points.get(p).radius();
            boolean isFlat = PointWeight.areOnOnePlane(surfaces, p, n, points.get(p).radius());
            float weight = PointWeight.flat(surfaces, n, Math.min(reach(p, isFlat), reach(n, isFlat)), at.px(), at.py(), at.pz(), at.nx(),
                    at.ny(), at.nz())
                    * (share * share);
            if (weight > 0 && !isSeparate(n, at) && !isSeparate(p, points.get(n).at())) {
                found.add(new Weighted(n, weight));
            }
        }
        List<Weighted> adjusted = adjusted(found, at, reach(p, true));
        boolean isValid = adjusted.stream().anyMatch(w -> w.weight > 0) && adjusted.stream().allMatch(w -> Float.isFinite(w.weight));
        return isValid ? whole(adjusted) : List.of(new Weighted(p, MAX_WEIGHT));
    }

    private List<Weighted> adjusted(List<Weighted> weighted, SurfacePoint at, float unit) {
        LinearWeights linear = new LinearWeights();
        linear.start(at.nx(), at.ny(), at.nz(), unit);
        for (Weighted w : weighted) {
            SurfacePoint to = points.get(w.point).at();
            linear.add(w.weight, to.px() - at.px(), to.py() - at.py(), to.pz() - at.pz());
        }
        linear.adjust();
        return IntStream.range(0, weighted.size()).mapToObj(i -> new Weighted(weighted.get(i).point, linear.weight(i))).toList();
    }

    /** Returns whole weights: the largest is 255, and those below 4 are left out. */
    private static List<Weighted> whole(List<Weighted> weighted) {
        float scale = MAX_WEIGHT / weighted.stream().map(Weighted::weight).max(Comparator.naturalOrder()).get();
        return weighted.stream().map(w -> new Weighted(w.point, Math.min(MAX_WEIGHT, (int) (w.weight * scale + 0.5f))))
                .filter(w -> w.weight >= MIN_WEIGHT).toList();
    }

    private float weight(int p, float radius, SurfacePoint at) {
        return PointWeight.at(surfaces, p, radius, at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
    }

    /** Returns the light at a surface: the weighted mean of the eight best points. */
    float[] at(SurfacePoint hit) {
        return mean(best(hit), light);
    }

    /** Returns the best points with whole weights up to 255, best first. */
    private List<Weighted> best(SurfacePoint hit) {
        List<Weighted> found = new ArrayList<>();
        for (int p = 0; p < points.size(); p++) {
            float weight = weight(p, points.get(p).radius(), hit);
            if (weight > 0 && !isSeparate(p, hit)) {
                found.add(new Weighted(p, weight));
            }
        }
        if (found.isEmpty()) {
            return points.isEmpty() ? List.of() : List.of(new Weighted(nearest(hit), MAX_WEIGHT));
        }
        // Points of equal weight keep their order.
        found.sort(Comparator.comparing(Weighted::weight).reversed());
        float next = found.size() > BEST ? found.get(BEST).weight : 0;
        float range = found.getFirst().weight - next;
        List<Weighted> best = found.stream().limit(BEST).map(w -> new Weighted(w.point, range > 0 ? w.weight - next : 1)).toList();
        return whole(adjusted(best, hit, points.get(best.getFirst().point).radius()));
    }

    private int nearest(SurfacePoint hit) {
        int nearest = 0;
        for (int p = 1; p < points.size(); p++) {
            nearest = distance(p, hit) < distance(nearest, hit) ? p : nearest;
        }
        return nearest;
    }

    private float distance(int p, SurfacePoint hit) {
        return PointWeight.distance(surfaces, p, barriers.get(p), hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
    }
}

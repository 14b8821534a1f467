package lightning.render.shading;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.render.gather.PointWeight;
import lightning.render.gather.SurfaceColumns;
import lightning.render.trace.SurfacePoint;

/** Spreads the light of gather points over the surfaces between them, for {@link ReferenceTracer}. */
final class ReferencePointLight {
    private static final float FILTER_CELLS = 4;
    private static final float FILTER_SHARE = 0.25f;
    private static final float FILTER_RADII = 2;
    private static final int BEST = 8;
    private static final int MAX_WEIGHT = 255;
    private static final float NO_OVERFLOW = 0x1p-24f;

    private final List<ReferenceGatherPoints.GatherPoint> points;
    private final SurfaceColumns surfaces = new SurfaceColumns();
    /** Light of each point after the filter: red, green, blue. */
    private final float[][] light;

    private record Weighted(int point, float weight) {}

    /** @param gathered light at each point: red, green, blue */
    ReferencePointLight(List<ReferenceGatherPoints.GatherPoint> points, float[][] gathered) {
        this.points = points;
        for (ReferenceGatherPoints.GatherPoint point : points) {
            SurfacePoint at = point.at();
            surfaces.add(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), at.primitive());
        }
        light = new float[points.size()][3];
        for (int p = 0; p < light.length; p++) {
            light[p] = mean(neighbors(p), gathered);
        }
    }

    /** Returns the weighted mean of some points' values: red, green, blue. */
    private static float[] mean(List<Weighted> points, float[][] values) {
        float total = 0;
        float[] sum = new float[3];
        for (Weighted point : points) {
            total += point.weight;
            for (int c = 0; c < 3; c++) {
                sum[c] += point.weight * NO_OVERFLOW * values[point.point][c];
            }
        }
        float share = total == 0 ? 0 : 1 / (total * NO_OVERFLOW);
        return new float[] {sum[0] * share, sum[1] * share, sum[2] * share};
    }

    private float reach(int p) {
        ReferenceGatherPoints.GatherPoint point = points.get(p);
        return Math.max(FILTER_RADII * point.radius(), Math.min(FILTER_CELLS * point.side(), FILTER_SHARE * point.harmonic()));
    }

    /** Returns the points whose mean is a point's light, with whole weights up to 255. */
    private List<Weighted> neighbors(int p) {
        List<Weighted> found = new ArrayList<>();
        float sum = 0;
        for (int n = 0; n < points.size(); n++) {
            float share = points.get(n).radius() / points.get(p).radius();
            SurfacePoint at = points.get(p).at();
            float weight = PointWeight.flat(surfaces, n, Math.min(reach(p), reach(n)), at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz())
                    * (share * share);
            if (weight > 0) {
                found.add(new Weighted(n, weight));
                sum += weight;
            }
        }
        if (!(sum > 0) || sum == Float.POSITIVE_INFINITY) {
            return List.of(new Weighted(p, MAX_WEIGHT));
        }
        float total = sum;
        float scale = MAX_WEIGHT / found.stream().map(w -> w.weight / total).max(Comparator.naturalOrder()).get();
        return found.stream().map(w -> new Weighted(w.point, Math.min(MAX_WEIGHT, (int) (w.weight / total * scale + 0.5f))))
                .filter(w -> w.weight > 0).toList();
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
            if (weight > 0) {
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
        float scale = MAX_WEIGHT / range;
        List<Weighted> best = new ArrayList<>();
        for (Weighted point : found.subList(0, Math.min(BEST, found.size()))) {
            int weight = range > 0 ? Math.min(MAX_WEIGHT, (int) ((point.weight - next) * scale + 0.5f)) : MAX_WEIGHT;
            if (weight > 0) {
                best.add(new Weighted(point.point, weight));
            }
        }
        return best;
    }

    private int nearest(SurfacePoint hit) {
        int nearest = 0;
        for (int p = 1; p < points.size(); p++) {
            nearest = distance(p, hit) < distance(nearest, hit) ? p : nearest;
        }
        return nearest;
    }

    private float distance(int p, SurfacePoint hit) {
        return PointWeight.distance(surfaces, p, hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
    }
}

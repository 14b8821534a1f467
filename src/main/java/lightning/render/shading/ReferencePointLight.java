package lightning.render.shading;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.render.gather.PointWeight;
import lightning.render.gather.SurfaceColumns;
import lightning.render.trace.SurfacePoint;

/** Spreads the light of gather points over the surfaces between them, for {@link ReferenceTracer}. */
final class ReferencePointLight {
    private static final float FILTER_CELLS = 6;
    private static final float FILTER_SHARE = 0.4f;
    private static final int BEST = 8;
    private static final int MAX_WEIGHT = 255;

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
            for (Weighted neighbor : neighbors(p)) {
                for (int c = 0; c < 3; c++) {
                    light[p][c] += neighbor.weight * gathered[neighbor.point][c];
                }
            }
        }
    }

    private float reach(int p) {
        ReferenceGatherPoints.GatherPoint point = points.get(p);
        return Math.max(point.radius(), Math.min(FILTER_CELLS * point.side(), FILTER_SHARE * point.harmonic()));
    }

    /** Returns the points whose mean is a point's light; their weights add up to 1. */
    private List<Weighted> neighbors(int p) {
        List<Weighted> found = new ArrayList<>();
        float sum = 0;
        for (int n = 0; n < points.size(); n++) {
            float share = points.get(n).radius() / points.get(p).radius();
            float weight = weight(n, Math.min(reach(p), reach(n)), points.get(p).at()) * (share * share);
            if (weight > 0) {
                found.add(new Weighted(n, weight));
                sum += weight;
            }
        }
        if (!(sum > 0) || sum == Float.POSITIVE_INFINITY) {
            return List.of(new Weighted(p, 1));
        }
        float total = sum;
        return found.stream().map(w -> new Weighted(w.point, w.weight / total)).toList();
    }

    private float weight(int p, float radius, SurfacePoint at) {
        return PointWeight.at(surfaces, p, radius, at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
    }

    /** Returns the light at a surface: the weighted mean of the eight best points. */
    float[] at(SurfacePoint hit) {
        double[] sum = new double[3];
        int total = 0;
        for (Weighted best : best(hit)) {
            for (int c = 0; c < 3; c++) {
                sum[c] += (double) best.weight * light[best.point][c];
            }
            total += (int) best.weight;
        }
        double scale = total == 0 ? 0 : 1.0 / total;
        return new float[] {(float) (sum[0] * scale), (float) (sum[1] * scale), (float) (sum[2] * scale)};
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

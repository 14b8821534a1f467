package lightning.meshes;

/**
 * Catmull-Rom spline (1974) in the plane.
 *
 * @param closed true if the last point continues to the first
 * @param points two coordinates of each point
 */
record Spline(boolean closed, double... points) {
    /** Returns a coordinate, 0 or 1, of the point at {@code v} from 0 to 1. */
    double at(double v, int coordinate) {
        int spans = points.length / 2 - (closed ? 0 : 1);
        double along = Math.clamp(v, 0, 1) * spans;
        int span = Math.min((int) along, spans - 1);
        double t = along - span;
        double a = point(span - 1, coordinate);
        double b = point(span, coordinate);
        double c = point(span + 1, coordinate);
        double d = point(span + 2, coordinate);
        return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
    }

    /** Returns {@code count} points at equal steps, without the end of an open spline. */
    double[] sampled(int count) {
        double[] sampled = new double[2 * count];
        for (int i = 0; i < sampled.length; i++) {
            sampled[i] = at((double) (i / 2) / count, i % 2);
        }
        return sampled;
    }

    private double point(int i, int coordinate) {
        int count = points.length / 2;
        return points[2 * (closed ? Math.floorMod(i, count) : Math.clamp(i, 0, count - 1)) + coordinate];
    }
}

package lightning.format.mesh.subdivision;

/**
 * Points on the limit surface of quadrilaterals (Halstead, Kass and DeRose, Efficient, fair interpolation using Catmull-Clark surfaces,
 * 1993). Where a crease is still sharp, the limit is that of one of infinite sharpness.
 */
final class LimitSurface {
    private static final double CREASE_WEIGHT = 1 / 6.0;

    private LimitSurface() {}

    static double[] project(PolygonTopology t, double[] points, int stride) {
        double[] diagonals = new double[points.length];
        for (int c = 0; c < t.corners.length; c++) {
            int across = t.corners[t.next(t.next(c))];
            for (int i = 0; i < stride; i++) {
                diagonals[stride * t.corners[c] + i] += points[stride * across + i];
            }
        }
        double[] limit = new double[points.length];
        new PointRules(t, points, stride).apply(diagonals, LimitSurface::weight, CREASE_WEIGHT, limit);
        return limit;
    }

    private static double weight(int n, int kind) {
        return (kind == 0 ? (double) n : kind == 1 ? 4.0 / n : 1.0 / n) / (n + 5);
    }
}

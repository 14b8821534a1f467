package lightning.render.trace.solid;

/** Frustum with a vertical side: both bases have radius 1. */
final class Cylinder extends Frustum {
    /** Below this ratio of (sideways / along)² a ray through a cylinder counts as parallel to the axis. */
    static final double PARALLEL = 0x1p-200;

    /** Computes the sphere's formula in two dimensions. */
    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin) {
        double a = dx * dx + dz * dz;
        double b = -(ox * dx + oz * dz);
        double c = ox * ox + oz * oz - 1;
        double w = ox * dz - oz * dx;
        double root = Math.sqrt(a - w * w);
        double q = b >= 0 ? b + root : b - root;
        double t0 = c / q;
        double t1 = q / a;
        boolean parallel = a <= dy * dy * PARALLEL;
        boolean touches = Math.abs(c * a) > 2 * q * q;
        double far = c <= 0 ? MISS : -MISS;
        double sideIn = parallel ? -far : touches ? MISS : t0 < t1 ? t0 : t1;
        double sideOut = parallel ? far : t0 < t1 ? t1 : t0;
        return hitDistance(data, at, sideIn, sideOut, oy, dy, touch, margin);
    }

    @Override
    public double chordMidpoint(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        double bottom = -oy / dy;
        double top = (1 - oy) / dy;
        double a = dx * dx + dz * dz;
        double w = ox * dz - oz * dx;
        double nearest = -(ox * dx + oz * dz) / a;
        double half = Math.sqrt(a - w * w) / a;
        double in = a > 0 ? Math.max(nearest - half, Math.min(bottom, top)) : bottom;
        double out = a > 0 ? Math.min(nearest + half, Math.max(bottom, top)) : top;
        return 0.5 * (in + out);
    }

    /** Returns −∞ for a cylinder without caps, which has no inside. */
    @Override
    public double insideDepth(double[] data, int at, double x, double y, double z) {
        return data[at + CAPS] == 0 ? -MISS : Math.min(1 - Math.sqrt(x * x + z * z), Math.min(y, 1 - y));
    }
}

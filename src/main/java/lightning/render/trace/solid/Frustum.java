package lightning.render.trace.solid;

/**
 * Cone cut parallel to its base: radius 1 at y = 0; radius at y = 1 from its first parameter; closed by two caps if its second
 * parameter is not 0. A cone's top has radius 0. With h = 1 − lean·y, the radius at height y, its side is x² + z² = h².
 */
class Frustum extends SolidGeometry {
    /** Index of the radius at y = 1. */
    static final int TOP_RADIUS = MAP_SIZE;
    /** Index of the flag for caps: 1 or 0. */
    static final int CAPS = MAP_SIZE + 1;

    @Override
    public final void extent(double[] data, int at, double mx, double my, double mz, double t, double[] box, int i) {
        double base = Math.sqrt(mx * mx + mz * mz);
        double middle = t + my;
        double top = data[at + TOP_RADIUS] * base;
        box[i] = Math.min(t - base, middle - top);
        box[i + 3] = Math.max(t + base, middle + top);
    }

    /**
     * Returns true for rays above y = 1 that do not descend, or below y = 0 that do not ascend. Then both ends of the interval
     * with 0 ≤ y ≤ 1, −oy / dy and (1 − oy) / dy, are at most 0, or −∞ for dy = 0. The hit cannot be beyond them
     * ({@link IntervalHit}).
     */
    @Override
    public final boolean isCertainMiss(double minY, double maxY, double minDirectionY, double maxDirectionY) {
        return minY > 1 && minDirectionY >= 0 || maxY < 0 && maxDirectionY <= 0;
    }

    @Override
    public final double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(data, at, ox, oy, oz, dx, dy, dz, SurfaceContact.NONE, 0);
    }

    /**
     * Intersects the side as a cone in x, z and h, for any lean.
     *
     * <p>The origin is first moved along the ray to its point nearest to the apex. Otherwise the terms of a distant ray along a
     * generator cancel, and the error grows with the square of the distance (Haines et al., Ray Tracing Gems, ch. 7, do so for
     * the sphere).
     *
     * <p>The discriminant uses Lagrange's identity for that form. A ray steeper than the side always crosses the double cone.
     * For a point perpendicular to the ray, this discriminant is a sum of squares, including w²·(dh²/side − 1); b² − ac rounds
     * to either side of 0 at the apex.
     */
    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin) {
        double taper = 1 - data[at + TOP_RADIUS];
        double top = 1 - taper * oy;
        double dh = -(taper * dy);
        double side = dx * dx + dz * dz;
        double up = dh * dh;
        double shift = -(ox * dx + oz * dz + top * dh) / (side + up);
        double x = ox + shift * dx;
        double h = top + shift * dh;
        double z = oz + shift * dz;
        double a = side - up;
        double b = h * dh - (x * dx + z * dz);
        double c = x * x + z * z - h * h;
        double u = x * dh - h * dx;
        double v = z * dh - h * dz;
        double w = x * dz - z * dx;
        double root = Math.sqrt(u * u + v * v - w * w);
        double q = b >= 0 ? b + root : b - root;
        double t1 = shift + q / a;
        double t0 = q == 0 ? t1 : shift + c / q;
        double low = t0 < t1 ? t0 : t1;
        double high = t0 < t1 ? t1 : t0;
        // Steeper than the side (a < 0): the ray enters the half of the double cone with h > 0 once and stays inside. Along a
        // generator (a = 0) only one root remains.
        boolean steep = a < 0;
        boolean generator = a == 0;
        boolean forward = steep ? dh > 0 : b >= 0;
        double bound = steep ? (dh > 0 ? high : low) : t0;
        double sideIn = steep || generator ? (forward ? bound : -MISS) : low;
        double sideOut = steep || generator ? (forward ? MISS : bound) : high;
        // Without a real root, at least one end of the interval is NaN: a miss.
        boolean miss = Math.abs(c * a) > 2 * q * q;
        return hitDistance(data, at, miss ? MISS : sideIn, miss ? -MISS : sideOut, oy, dy, touch, margin);
    }

    /** Returns the hit within the interval inside the infinite side. */
    static double hitDistance(double[] data, int at, double sideIn, double sideOut, double oy, double dy, SurfaceContact touch,
            double margin) {
        return data[at + CAPS] != 0 ? IntervalHit.hitWithCaps(sideIn, sideOut, oy, dy, touch, margin)
                : IntervalHit.hitWithoutCaps(sideIn, sideOut, oy, dy, touch, margin);
    }

    /** Returns the factor of the rim at the wider end, which is sharper the more the side leans. */
    @Override
    public final double edgeMarginFactor(double[] data, int at) {
        return 4 * steepness(data[at + TOP_RADIUS]);
    }

    /**
     * Returns the smaller of the distances to the side within its height and to a cap. Neither changes by more than the point
     * moves.
     */
    @Override
    public final double surfaceDistance(double[] data, int at, double x, double y, double z, double maxScale) {
        double top = data[at + TOP_RADIUS];
        double taper = 1 - top;
        double ring = Math.sqrt(x * x + z * z);
        double sideDistance = Math.abs(ring - (1 - taper * y)) * Math.sqrt(1 / (1 + taper * taper));
        double base = Math.max(Math.abs(y), ring - 1);
        double side = Math.max(sideDistance, Math.max(-y, y - 1));
        if (data[at + CAPS] == 0) {
            return side / maxScale;
        }
        if (top == 0) {
            return Math.min(Math.max(sideDistance, -y), base) / maxScale;
        }
        return Math.min(side, Math.min(base, Math.max(Math.abs(1 - y), ring - top))) / maxScale;
    }

    @Override
    public final void outwardNormal(double[] data, int at, double x, double y, double z, double[] out) {
        double taper = 1 - data[at + TOP_RADIUS];
        boolean side = isSide(data, at, x, y, z);
        out[0] = side ? x : 0;
        out[1] = side ? taper * (1 - taper * y) : data[at + TOP_RADIUS] > 0 && y > 0.5 ? 1 : -1;
        out[2] = side ? z : 0;
    }

    /** Returns whether a point of the surface belongs to the side instead of a cap, by the nearest of them. */
    private static boolean isSide(double[] data, int at, double x, double y, double z) {
        double top = data[at + TOP_RADIUS];
        if (data[at + CAPS] == 0) {
            return true;
        }
        double disc = top > 0 && Math.abs(1 - y) <= Math.abs(y) ? Math.abs(1 - y) : Math.abs(y);
        return Math.abs(Math.sqrt(x * x + z * z) - (1 - (1 - top) * y)) <= disc * steepness(top);
    }

    /**
     * Returns the bound on the distance from the side along x and z, per unit of error perpendicular to it. It is 1 up to a
     * cone's lean.
     */
    static double steepness(double top) {
        return Math.max(1, Math.abs(1 - top));
    }

    @Override
    public final void textureCoordinates(double[] data, int at, double x, double y, double z, double[] uv) {
        boolean side = isSide(data, at, x, y, z);
        uv[0] = side ? longitude(x, z) : 0.5 * (x + 1);
        uv[1] = side ? y : 0.5 * (z + 1);
    }

    @Override
    public final void textureGradients(double[] data, int at, double x, double y, double z, double[] to) {
        boolean side = isSide(data, at, x, y, z);
        if (side) {
            longitudeGradient(x, z, to);
        } else {
            to[0] = 0.5;
            to[1] = 0;
            to[2] = 0;
        }
        to[3] = 0;
        to[4] = side ? 1 : 0;
        to[5] = side ? 0 : 0.5;
    }
}

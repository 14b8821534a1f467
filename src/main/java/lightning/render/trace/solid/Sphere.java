package lightning.render.trace.solid;

/** Sphere of radius 1 around the origin. Texture coordinates are longitude and latitude. */
final class Sphere extends SolidGeometry {
    @Override
    public void extent(double[] data, int at, double mx, double my, double mz, double t, double[] box, int i) {
        double radius = Math.sqrt(mx * mx + my * my + mz * mz);
        box[i] = t - radius;
        box[i + 3] = t + radius;
    }

    /**
     * Intersects a ray.
     *
     * <p>The discriminant b² − ac is |d|² − |o × d|² by Lagrange's identity, without cancellation far from the sphere. Each
     * root is computed by the quotient without cancellation near it (after Haines et al., Ray Tracing Gems, ch. 7). Only the
     * nearest root ahead is divided: the second one for a ray that starts inside, otherwise the first.
     *
     * <p>|c·a| ≤ q² holds exactly. Where it fails by far, c and q are rounding errors of a tangent to the surface that the ray
     * leaves: a miss.
     */
    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double c = ox * ox + oy * oy + oz * oz - 1;
        double u = oy * dz - oz * dy;
        double v = oz * dx - ox * dz;
        double w = ox * dy - oy * dx;
        double root = Math.sqrt(a - (u * u + v * v + w * w));
        double q = b >= 0 ? b + root : b - root;
        boolean leaves = c <= 0 && b >= 0;
        double t = (leaves ? q : c) / (leaves ? a : q);
        return t > 0 && t < MISS && Math.abs(c * a) <= 2 * q * q ? t : MISS;
    }

    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double c = ox * ox + oy * oy + oz * oz - 1;
        double u = oy * dz - oz * dy;
        double v = oz * dx - ox * dz;
        double w = ox * dy - oy * dx;
        double root = Math.sqrt(a - (u * u + v * v + w * w));
        double q = b >= 0 ? b + root : b - root;
        double t0 = c / q;
        double t1 = q / a;
        return Math.abs(c * a) <= 2 * q * q ? IntervalHit.hitDistance(t0 < t1 ? t0 : t1, t0 < t1 ? t1 : t0, touch, margin) : MISS;
    }

    /** Returns false: rounding may invalidate any conclusion from heights alone. */
    @Override
    public boolean isCertainMiss(double minY, double maxY, double minDirectionY, double maxDirectionY) {
        return false;
    }

    @Override
    public double chordMidpoint(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        return -(ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz);
    }

    @Override
    public double insideDepth(double[] data, int at, double x, double y, double z) {
        return 1 - Math.sqrt(x * x + y * y + z * z);
    }

    /** Returns the value for a solid without edges. */
    @Override
    public double edgeMarginFactor(double[] data, int at) {
        return 4;
    }

    @Override
    public double surfaceDistance(double[] data, int at, double x, double y, double z, double maxScale) {
        return Math.abs(Math.sqrt(x * x + y * y + z * z) - 1) / maxScale;
    }

    @Override
    public void outwardNormal(double[] data, int at, double x, double y, double z, double[] out) {
        out[0] = x;
        out[1] = y;
        out[2] = z;
    }

    @Override
    public void textureCoordinates(double[] data, int at, double x, double y, double z, double[] uv) {
        uv[0] = longitude(x, z);
        uv[1] = StrictMath.asin(y < -1 ? -1 : y > 1 ? 1 : y) / Math.PI + 0.5;
    }

    /** Writes the gradients; along the surface, latitude grows like y / (π·cosine of the latitude). */
    @Override
    public void textureGradients(double[] data, int at, double x, double y, double z, double[] to) {
        double ring = Math.PI * Math.sqrt(x * x + z * z);
        longitudeGradient(x, z, to);
        to[3] = 0;
        to[4] = ring > 0 ? 1 / ring : 0;
        to[5] = 0;
    }
}

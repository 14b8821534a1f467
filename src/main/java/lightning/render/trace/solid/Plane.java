package lightning.render.trace.solid;

/** Unit square around the origin in the plane y = 0, without an inside. */
final class Plane extends SolidGeometry {
    @Override
    public void extent(double[] data, int at, double mx, double my, double mz, double t, double[] box, int i) {
        double half = 0.5 * (Math.abs(mx) + Math.abs(mz));
        box[i] = t - half;
        box[i + 3] = t + half;
    }

    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        double t = -oy / dy;
        double x = ox + t * dx;
        double z = oz + t * dz;
        boolean hit = t > 0 && t < MISS && Math.abs(x) <= 0.5 && Math.abs(z) <= 0.5;
        return hit ? t : MISS;
    }

    /** Returns the crossing. A ray that ends on the plane has no other crossing. */
    @Override
    public double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin) {
        return touch == SurfaceContact.NONE ? distance(data, at, ox, oy, oz, dx, dy, dz) : MISS;
    }

    /**
     * Returns true unless origin and direction can have opposite signs of y: otherwise the distance −oy / dy is at most 0, or
     * NaN.
     */
    @Override
    public boolean isCertainMiss(double minY, double maxY, double minDirectionY, double maxDirectionY) {
        return minY >= 0 && minDirectionY >= 0 || maxY <= 0 && maxDirectionY <= 0;
    }

    @Override
    public double edgeMarginFactor(double[] data, int at) {
        return 4;
    }

    /** Returns the largest of the distances per axis: along y from the square, along x and z from its edges. */
    @Override
    public double surfaceDistance(double[] m, int i, double x, double y, double z, double maxScale) {
        return Math.max(Math.abs(y) / (Math.abs(m[i + 4]) + Math.abs(m[i + 5]) + Math.abs(m[i + 6])),
                Math.max((Math.abs(x) - 0.5) / (Math.abs(m[i]) + Math.abs(m[i + 1]) + Math.abs(m[i + 2])),
                        (Math.abs(z) - 0.5) / (Math.abs(m[i + 8]) + Math.abs(m[i + 9]) + Math.abs(m[i + 10]))));
    }

    @Override
    public void outwardNormal(double[] data, int at, double x, double y, double z, double[] out) {
        out[0] = 0;
        out[1] = 1;
        out[2] = 0;
    }

    @Override
    public void textureCoordinates(double[] data, int at, double x, double y, double z, double[] uv) {
        uv[0] = x + 0.5;
        uv[1] = z + 0.5;
    }

    @Override
    public void textureGradients(double[] data, int at, double x, double y, double z, double[] to) {
        to[0] = 1;
        to[1] = 0;
        to[2] = 0;
        to[3] = 0;
        to[4] = 0;
        to[5] = 1;
    }
}

package lightning.render.trace.mesh;

/**
 * A ray in the space of a mesh, and how it meets a triangle. Reused for ray after ray.
 *
 * <p><b>The test</b> is that of Woop, Benthin and Wald (2013, Watertight Ray/Triangle Intersection), in doubles. The vertices are
 * moved so that the ray begins at 0, then sheared so that it runs along an axis; the ray meets the triangle where 0 lies in it as
 * seen along that axis, which the signs of three products' differences tell. A vertex is moved and sheared by the same operations
 * in whichever triangle it stands, and the difference for an edge that runs the other way is the exact opposite. Rounding keeps order,
 * so the sign of a difference of rounded products is never wrong, only perhaps 0, and 0 counts as inside. Nothing is fused: a
 * fused product would not be the other's opposite. So what a mesh covers has no gap, at edges and at vertices.
 *
 * <p><b>The distance</b> is the mean of the vertices' depths with those differences as weights: all have one sign, so it lies between
 * the vertices' depths, up to rounding, even where a triangle is seen from its side and the weights are noise.
 *
 * <p><b>Boxes</b> are exact and the ray is made wide by {@code padding}, 16u·R with u = 2⁻⁵³ and R a bound on any |coordinate| of the
 * ray's origin plus any of the mesh. Moving and shearing are off by u·R + 2u·R + u·R, so a ray that the test lets in passes within
 * 4u·R of a point of the triangle, and of its box, on the two axes that are sheared, and at its very depth on the third. Where it
 * enters and leaves a box, (b − (o ± pad))·(1/d), is rounded by no more than 6u·R/|d|. So the wide ray crosses the triangle's own box
 * at the depth of that point, and the interval in which it does is never empty. A distance is put into that interval, which
 * moves it by less than the errors just named except where weights are noise. As all of this is monotone in b, the interval of a box lies within
 * that of any box around it, bit by bit: the tree can lose nothing and changes no distance.
 */
final class MeshRay {
    /** The distance to what a ray does not meet. */
    static final double MISS = Double.POSITIVE_INFINITY;
    /** 16u. */
    static final double PADDING_SHARE = 0x1p-49;
    /** Finite, so that a ray within a box's plane makes no NaN. */
    static final double MAX_INVERSE = 0x1p900;

    private double ox;
    private double oy;
    private double oz;
    /** Origin plus and minus the padding: what least and greatest coordinates of boxes are seen from. */
    private double lowX;
    private double lowY;
    private double lowZ;
    private double highX;
    private double highY;
    private double highZ;
    private double padding;
    private double inverseX;
    private double inverseY;
    private double inverseZ;
    /** The axis along which the direction is longest, 0 1 2, and the two others. */
    private int axisX;
    private int axisY;
    private int axisZ;
    private double originX;
    private double originY;
    private double originZ;
    private double shearX;
    private double shearY;
    private double inverseDepth;
    /** A point, and how near to it triangles are that the ray does not meet; negative for none. */
    private double ignoredX;
    private double ignoredY;
    private double ignoredZ;
    private double ignoredRadius;
    /** Where the ray enters the box that {@link #entersBox} was asked for. */
    double entryDistance;

    /**
     * Takes a ray.
     *
     * @param maxCoordinate the largest absolute coordinate of the mesh
     */
    void setRay(double x, double y, double z, double dx, double dy, double dz, double maxCoordinate) {
        ox = x;
        oy = y;
        oz = z;
        padding = PADDING_SHARE * (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) + maxCoordinate);
        lowX = x + padding;
        lowY = y + padding;
        lowZ = z + padding;
        highX = x - padding;
        highY = y - padding;
        highZ = z - padding;
        inverseX = inverse(dx);
        inverseY = inverse(dy);
        inverseZ = inverse(dz);
        double absX = Math.abs(dx);
        double absY = Math.abs(dy);
        double absZ = Math.abs(dz);
        axisZ = absX >= absY && absX >= absZ ? 0 : absY >= absZ ? 1 : 2;
        axisX = axisZ == 2 ? 0 : axisZ + 1;
        axisY = axisX == 2 ? 0 : axisX + 1;
        originX = component(axisX, x, y, z);
        originY = component(axisY, x, y, z);
        originZ = component(axisZ, x, y, z);
        inverseDepth = 1 / component(axisZ, dx, dy, dz);
        shearX = component(axisX, dx, dy, dz) * inverseDepth;
        shearY = component(axisY, dx, dy, dz) * inverseDepth;
        ignoredRadius = -1;
    }

    /** Lets the ray, once taken, pass all triangles that are this near to a point of it, as far as {@link #triangleDistance} knows. */
    void ignoreNear(double x, double y, double z, double radius) {
        ignoredX = x;
        ignoredY = y;
        ignoredZ = z;
        ignoredRadius = radius;
    }

    private static double inverse(double d) {
        double inverse = 1 / d;
        return inverse < -MAX_INVERSE ? -MAX_INVERSE : inverse > MAX_INVERSE ? MAX_INVERSE : inverse;
    }

    private static double component(int axis, double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /**
     * The distance to a triangle, or {@code +∞}. Coordinate {@code k} of its vertices is {@code v[a + k * step]}, {@code v[b + k * step]}
     * and {@code v[c + k * step]}.
     */
    double distance(float[] v, int a, int b, int c, int step) {
        double t = planeDistance(v, a, b, c, axisX * step, axisY * step, axisZ * step, originX, originY, originZ, shearX, shearY,
                inverseDepth);
        return t > 0 ? acceptedDistance(t, v, a, b, c, step) : MISS;
    }

    /**
     * The distance to a triangle's plane where a ray meets the triangle by the signs, NaN where it does not or sees it as a line. Coordinates
     * {@code x}, {@code y} and {@code z} of its vertices, which are added to {@code a}, {@code b} and {@code c}, and of the origin are those across
     * the ray's axis and along it.
     */
    static double planeDistance(float[] v, int a, int b, int c, int x, int y, int z, double originX, double originY, double originZ,
            double shearX,
            double shearY, double inverseDepth) {
        double az = v[a + z] - originZ;
        double ax = v[a + x] - originX - shearX * az;
        double ay = v[a + y] - originY - shearY * az;
        double bz = v[b + z] - originZ;
        double bx = v[b + x] - originX - shearX * bz;
        double by = v[b + y] - originY - shearY * bz;
        double cz = v[c + z] - originZ;
        double cx = v[c + x] - originX - shearX * cz;
        double cy = v[c + y] - originY - shearY * cz;
        double weightA = cx * by - cy * bx;
        double weightB = ax * cy - ay * cx;
        double weightC = bx * ay - by * ax;
        boolean allPositive = weightA >= 0 && weightB >= 0 && weightC >= 0;
        boolean allNegative = weightA <= 0 && weightB <= 0 && weightC <= 0;
        // NaN where all weights are 0: the triangle is seen as a line, and its neighbors cover what it does.
        return allPositive || allNegative ? (weightA * az + weightB * bz + weightC * cz) / (weightA + weightB + weightC) * inverseDepth
                : Double.NaN;
    }

    private double acceptedDistance(double t, float[] v, int a, int b, int c, int step) {
        double clamped = clampToBox(t, v, a, b, c, step, ox, oy, oz, padding, inverseX, inverseY, inverseZ);
        return clamped < MISS && ignoredRadius >= 0 && triangleDistance(v, a, b, c, step, ignoredX, ignoredY, ignoredZ) <= ignoredRadius
                ? MISS : clamped;
    }

    /** Puts a distance into the interval in which a ray, made wide, crosses the triangle's box; {@code +∞} where that is behind it. */
    static double clampToBox(double t, float[] v, int a, int b, int c, int step, double ox, double oy, double oz, double pad,
            double inverseX, double inverseY, double inverseZ) {
        double p = (min(v[a], v[b], v[c]) - (ox + pad)) * inverseX;
        double q = (max(v[a], v[b], v[c]) - (ox - pad)) * inverseX;
        double enters = p < q ? p : q;
        double leaves = p < q ? q : p;
        p = (min(v[a + step], v[b + step], v[c + step]) - (oy + pad)) * inverseY;
        q = (max(v[a + step], v[b + step], v[c + step]) - (oy - pad)) * inverseY;
        enters = Math.max(enters, p < q ? p : q);
        leaves = Math.min(leaves, p < q ? q : p);
        p = (min(v[a + 2 * step], v[b + 2 * step], v[c + 2 * step]) - (oz + pad)) * inverseZ;
        q = (max(v[a + 2 * step], v[b + 2 * step], v[c + 2 * step]) - (oz - pad)) * inverseZ;
        enters = Math.max(Math.max(enters, p < q ? p : q), 0);
        leaves = Math.min(leaves, p < q ? q : p);
        double clamped = t < enters ? enters : t > leaves ? leaves : t;
        return enters <= leaves && clamped > 0 && clamped < MISS ? clamped : MISS;
    }

    private static float min(float a, float b, float c) {
        return Math.min(Math.min(a, b), c);
    }

    private static float max(float a, float b, float c) {
        return Math.max(Math.max(a, b), c);
    }

    /** Whether the wide ray may meet the box of child {@code i} at a distance up to {@code limit}; writes {@link #entryDistance}. */
    boolean entersBox(float[] box, int i, double limit) {
        double p = (box[i] - lowX) * inverseX;
        double q = (box[i + 8] - highX) * inverseX;
        double enters = p < q ? p : q;
        double leaves = p < q ? q : p;
        enters = enters > 0 ? enters : 0;
        leaves = leaves < limit ? leaves : limit;
        p = (box[i + 16] - lowY) * inverseY;
        q = (box[i + 24] - highY) * inverseY;
        double near = p < q ? p : q;
        double far = p < q ? q : p;
        enters = near > enters ? near : enters;
        leaves = far < leaves ? far : leaves;
        p = (box[i + 32] - lowZ) * inverseZ;
        q = (box[i + 40] - highZ) * inverseZ;
        near = p < q ? p : q;
        far = p < q ? q : p;
        enters = near > enters ? near : enters;
        leaves = far < leaves ? far : leaves;
        entryDistance = enters;
        return enters <= leaves;
    }

    /**
     * How far a point lies off a triangle at least: from its box along an axis, or from its plane. No more than the distance, and
     * 0 on it, up to rounding.
     */
    static double triangleDistance(float[] v, int a, int b, int c, int step, double x, double y, double z) {
        double minDistance = 0;
        for (int axis = 0; axis < 3; axis++) {
            int k = axis * step;
            double p = component(axis, x, y, z);
            minDistance = Math.max(minDistance, Math.max(Math.min(v[a + k], Math.min(v[b + k], v[c + k])) - p,
                    p - Math.max(v[a + k], Math.max(v[b + k], v[c + k]))));
        }
        double ex = (double) v[b] - v[a];
        double ey = (double) v[b + step] - v[a + step];
        double ez = (double) v[b + 2 * step] - v[a + 2 * step];
        double fx = (double) v[c] - v[a];
        double fy = (double) v[c + step] - v[a + step];
        double fz = (double) v[c + 2 * step] - v[a + 2 * step];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double plane = Math.abs((x - v[a]) * nx + (y - v[a + step]) * ny + (z - v[a + 2 * step]) * nz);
        return length > 0 ? Math.max(minDistance, plane / length) : minDistance;
    }
}

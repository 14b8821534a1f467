package lightning.render.trace.mesh;

/**
 * Ray in the space of a mesh and its watertight triangle test. Reused for many rays.
 *
 * <p><b>Test:</b> Woop, Benthin and Wald (2013, Watertight Ray/Triangle Intersection), in doubles. Vertices are translated so
 * that the ray starts at 0, then sheared so that it runs along an axis. The signs of three differences of products decide if 0
 * is inside the triangle seen along that axis. Each vertex goes through the same operations in every triangle, and the
 * difference for a reversed edge is the exact opposite. Rounding is monotone, so the sign of a difference of rounded products
 * is never wrong, only possibly 0, and 0 counts as inside. Nothing is fused: a fused product would break this antisymmetry. So
 * a mesh has no gaps at edges and vertices.
 *
 * <p><b>Distance:</b> mean of the vertices' depths with those differences as weights. All weights have one sign, so it lies
 * between the depths, up to rounding, even where a triangle is seen edge-on and the weights are noise. It is then clamped to
 * the interval in which the padded ray crosses the triangle's box.
 *
 * <p><b>Padding:</b> 16u·R with u = 2⁻⁵³, where R bounds any |coordinate| of the ray's origin plus any of the mesh. The BVH
 * then loses no hit and changes no distance. Proof: docs/numerics.md, "Proof: boxes of mesh triangles".
 */
final class MeshRay {
    /** Distance for a miss. */
    static final double MISS = Double.POSITIVE_INFINITY;
    /** 16u. */
    static final double PADDING_SHARE = 0x1p-49;
    /** Finite, so that a ray within a box's plane produces no NaN. */
    static final double MAX_INVERSE = 0x1p900;

    private double ox;
    private double oy;
    private double oz;
    /**
     * Origin of the padded ray for the sides of boxes that it reaches first, and for the others: the origin plus the padding for
     * minimum sides, minus the padding for maximum sides.
     */
    double nearX;
    double nearY;
    double nearZ;
    double farX;
    double farY;
    double farZ;
    private double padding;
    double inverseX;
    double inverseY;
    double inverseZ;
    /** Axis of the largest direction component, 0 1 2, and the two others. */
    int axisX;
    int axisY;
    int axisZ;
    double originX;
    double originY;
    double originZ;
    double shearX;
    double shearY;
    private double inverseDepth;
    /** Point around which triangles are ignored, and the radius; negative for none. */
    private double ignoredX;
    private double ignoredY;
    private double ignoredZ;
    private double ignoredRadius;

    /**
     * Sets the ray.
     *
     * @param maxCoordinate largest absolute coordinate of the mesh
     */
    void setRay(double x, double y, double z, double dx, double dy, double dz, double maxCoordinate) {
        ox = x;
        oy = y;
        oz = z;
        padding = PADDING_SHARE * (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) + maxCoordinate);
        inverseX = inverse(dx);
        inverseY = inverse(dy);
        inverseZ = inverse(dz);
        nearX = inverseX > 0 ? x + padding : x - padding;
        nearY = inverseY > 0 ? y + padding : y - padding;
        nearZ = inverseZ > 0 ? z + padding : z - padding;
        farX = inverseX > 0 ? x - padding : x + padding;
        farY = inverseY > 0 ? y - padding : y + padding;
        farZ = inverseZ > 0 ? z - padding : z + padding;
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

    /**
     * Makes the ray ignore all triangles within a radius of a point, by {@link #triangleDistance}. Call after setting the ray.
     */
    void ignoreNear(double x, double y, double z, double radius) {
        ignoredX = x;
        ignoredY = y;
        ignoredZ = z;
        ignoredRadius = radius;
    }

    static double inverse(double d) {
        double inverse = 1 / d;
        return inverse < -MAX_INVERSE ? -MAX_INVERSE : inverse > MAX_INVERSE ? MAX_INVERSE : inverse;
    }

    private static double component(int axis, double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /**
     * Returns the distance to a triangle, or {@code +∞}. Coordinate {@code k} of its vertices is {@code v[a + k * step]},
     * {@code v[b + k * step]} and {@code v[c + k * step]}.
     */
    double distance(float[] v, int a, int b, int c, int step) {
        double t = planeDistance(v, a, b, c, axisX * step, axisY * step, axisZ * step, originX, originY, originZ, shearX, shearY,
                inverseDepth);
        return t > 0 ? acceptedDistance(t, v, a, b, c, step) : MISS;
    }

    /**
     * Returns the distance to a triangle's plane if the signs indicate a hit; NaN for a miss or a triangle seen edge-on.
     * Coordinates {@code x}, {@code y} and {@code z} of its vertices, added to {@code a}, {@code b} and {@code c}, and of the
     * origin are in order of the ray's axes: across, across, along.
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
        // NaN if all weights are 0: the triangle is seen edge-on, and its neighbors cover the same points.
        return allPositive || allNegative ? (weightA * az + weightB * bz + weightC * cz) / (weightA + weightB + weightC) * inverseDepth
                : Double.NaN;
    }

    private double acceptedDistance(double t, float[] v, int a, int b, int c, int step) {
        double clamped = clampToBox(t, v, a, b, c, step, ox, oy, oz, padding, inverseX, inverseY, inverseZ);
        return clamped < MISS && ignoredRadius >= 0 && triangleDistance(v, a, b, c, step, ignoredX, ignoredY, ignoredZ) <= ignoredRadius
                ? MISS : clamped;
    }

    /**
     * Clamps a distance to the interval in which the padded ray crosses the triangle's box; {@code +∞} if that interval is
     * behind the origin.
     */
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

    /**
     * Returns the slots of a leaf, one bit each, in which no two weights of {@link #planeDistance} have opposite signs: those that
     * are hit, seen edge-on or empty. The others need no {@link #distance}.
     *
     * <p>A loop without calls, because the first compiler does not inline methods of this size, and without branches, which would
     * be mispredicted.
     *
     * @param at index of the leaf's first coordinate
     */
    int hitSlots(float[] v, int at) {
        double startX = originX;
        double startY = originY;
        double startZ = originZ;
        double slopeX = shearX;
        double slopeY = shearY;
        int x = at + MeshTree.AXIS_FLOATS * axisX;
        int y = at + MeshTree.AXIS_FLOATS * axisY;
        int z = at + MeshTree.AXIS_FLOATS * axisZ;
        int slots = 0;
        for (int s = 0; s < MeshTree.WIDTH; s++) {
            double az = v[z + s] - startZ;
            double ax = v[x + s] - startX - slopeX * az;
            double ay = v[y + s] - startY - slopeY * az;
            double bz = v[z + s + MeshTree.CORNER_FLOATS] - startZ;
            double bx = v[x + s + MeshTree.CORNER_FLOATS] - startX - slopeX * bz;
            double by = v[y + s + MeshTree.CORNER_FLOATS] - startY - slopeY * bz;
            double cz = v[z + s + 2 * MeshTree.CORNER_FLOATS] - startZ;
            double cx = v[x + s + 2 * MeshTree.CORNER_FLOATS] - startX - slopeX * cz;
            double cy = v[y + s + 2 * MeshTree.CORNER_FLOATS] - startY - slopeY * cz;
            double weightA = cx * by - cy * bx;
            double weightB = ax * cy - ay * cx;
            double weightC = bx * ay - by * ax;
            // The highest bit tells that a weight is below 0, or above 0. Adding 0 makes −0 positive.
            long below = Double.doubleToRawLongBits(weightA + 0.0) | Double.doubleToRawLongBits(weightB + 0.0)
                    | Double.doubleToRawLongBits(weightC + 0.0);
            long above = Double.doubleToRawLongBits(0.0 - weightA) | Double.doubleToRawLongBits(0.0 - weightB)
                    | Double.doubleToRawLongBits(0.0 - weightC);
            slots |= (int) (~(below & above) >>> 63) << s;
        }
        return slots;
    }

    /**
     * Returns a lower bound on the distance of a point from a triangle: the larger of the distances from its box along an axis
     * and from its plane. 0 on the triangle, up to rounding.
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

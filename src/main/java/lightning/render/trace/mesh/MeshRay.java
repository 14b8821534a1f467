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
 * <p><b>Boxes</b> are exact and the ray is made wide by {@code pad}, 16u·R with u = 2⁻⁵³ and R a bound on any |coordinate| of the
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
    static final double PAD = 0x1p-49;
    /** Finite, so that a ray within a box's plane makes no NaN. */
    static final double STEEPEST = 0x1p900;

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
    private double pad;
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
    private double perDepth;
    /** A point, and how near to it triangles are that the ray does not meet; negative for none. */
    private double freeX;
    private double freeY;
    private double freeZ;
    private double free;
    /** Where the ray enters the box that {@link #enters} was asked for. */
    double in;

    /**
     * Takes a ray.
     *
     * @param reach the largest absolute coordinate of the mesh
     */
    void enter(double x, double y, double z, double dx, double dy, double dz, double reach) {
        ox = x;
        oy = y;
        oz = z;
        pad = PAD * (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) + reach);
        lowX = x + pad;
        lowY = y + pad;
        lowZ = z + pad;
        highX = x - pad;
        highY = y - pad;
        highZ = z - pad;
        inverseX = inverse(dx);
        inverseY = inverse(dy);
        inverseZ = inverse(dz);
        double absX = Math.abs(dx);
        double absY = Math.abs(dy);
        double absZ = Math.abs(dz);
        axisZ = absX >= absY && absX >= absZ ? 0 : absY >= absZ ? 1 : 2;
        axisX = axisZ == 2 ? 0 : axisZ + 1;
        axisY = axisX == 2 ? 0 : axisX + 1;
        originX = of(axisX, x, y, z);
        originY = of(axisY, x, y, z);
        originZ = of(axisZ, x, y, z);
        perDepth = 1 / of(axisZ, dx, dy, dz);
        shearX = of(axisX, dx, dy, dz) * perDepth;
        shearY = of(axisY, dx, dy, dz) * perDepth;
        free = -1;
    }

    /** Lets the ray, once taken, pass all triangles that are this near to a point of it, as far as {@link #gap} knows. */
    void pass(double x, double y, double z, double near) {
        freeX = x;
        freeY = y;
        freeZ = z;
        free = near;
    }

    private static double inverse(double d) {
        double inverse = 1 / d;
        return inverse < -STEEPEST ? -STEEPEST : inverse > STEEPEST ? STEEPEST : inverse;
    }

    private static double of(int axis, double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /**
     * The distance to a triangle, or {@code +∞}. Coordinate {@code k} of its vertices is {@code v[a + k * step]}, {@code v[b + k * step]}
     * and {@code v[c + k * step]}.
     */
    double distance(float[] v, int a, int b, int c, int step) {
        double t = depth(v, a, b, c, axisX * step, axisY * step, axisZ * step, originX, originY, originZ, shearX, shearY, perDepth);
        return t > 0 ? within(t, v, a, b, c, step) : MISS;
    }

    /**
     * The distance to a triangle's plane where a ray meets the triangle by the signs, NaN where it does not or sees it as a line. Coordinates
     * {@code x}, {@code y} and {@code z} of its vertices, which are added to {@code a}, {@code b} and {@code c}, and of the origin are those across
     * the ray's axis and along it.
     */
    static double depth(float[] v, int a, int b, int c, int x, int y, int z, double originX, double originY, double originZ, double shearX,
            double shearY, double perDepth) {
        double az = v[a + z] - originZ;
        double ax = v[a + x] - originX - shearX * az;
        double ay = v[a + y] - originY - shearY * az;
        double bz = v[b + z] - originZ;
        double bx = v[b + x] - originX - shearX * bz;
        double by = v[b + y] - originY - shearY * bz;
        double cz = v[c + z] - originZ;
        double cx = v[c + x] - originX - shearX * cz;
        double cy = v[c + y] - originY - shearY * cz;
        double atA = cx * by - cy * bx;
        double atB = ax * cy - ay * cx;
        double atC = bx * ay - by * ax;
        boolean one = atA >= 0 && atB >= 0 && atC >= 0;
        boolean other = atA <= 0 && atB <= 0 && atC <= 0;
        // NaN where all weights are 0: the triangle is seen as a line, and its neighbours cover what it does.
        return one || other ? (atA * az + atB * bz + atC * cz) / (atA + atB + atC) * perDepth : Double.NaN;
    }

    private double within(double t, float[] v, int a, int b, int c, int step) {
        double put = put(t, v, a, b, c, step, ox, oy, oz, pad, inverseX, inverseY, inverseZ);
        return put < MISS && free >= 0 && gap(v, a, b, c, step, freeX, freeY, freeZ) <= free ? MISS : put;
    }

    /** Puts a distance into the interval in which a ray, made wide, crosses the triangle's box; {@code +∞} where that is behind it. */
    static double put(double t, float[] v, int a, int b, int c, int step, double ox, double oy, double oz, double pad,
            double inverseX, double inverseY, double inverseZ) {
        double p = (least(v[a], v[b], v[c]) - (ox + pad)) * inverseX;
        double q = (most(v[a], v[b], v[c]) - (ox - pad)) * inverseX;
        double enters = p < q ? p : q;
        double leaves = p < q ? q : p;
        p = (least(v[a + step], v[b + step], v[c + step]) - (oy + pad)) * inverseY;
        q = (most(v[a + step], v[b + step], v[c + step]) - (oy - pad)) * inverseY;
        enters = Math.max(enters, p < q ? p : q);
        leaves = Math.min(leaves, p < q ? q : p);
        p = (least(v[a + 2 * step], v[b + 2 * step], v[c + 2 * step]) - (oz + pad)) * inverseZ;
        q = (most(v[a + 2 * step], v[b + 2 * step], v[c + 2 * step]) - (oz - pad)) * inverseZ;
        enters = Math.max(Math.max(enters, p < q ? p : q), 0);
        leaves = Math.min(leaves, p < q ? q : p);
        double put = t < enters ? enters : t > leaves ? leaves : t;
        return enters <= leaves && put > 0 && put < MISS ? put : MISS;
    }

    private static float least(float a, float b, float c) {
        return Math.min(Math.min(a, b), c);
    }

    private static float most(float a, float b, float c) {
        return Math.max(Math.max(a, b), c);
    }

    /** Whether the wide ray may meet the box of child {@code i} at a distance up to {@code limit}; writes {@link #in}. */
    boolean enters(float[] box, int i, double limit) {
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
        in = enters;
        return enters <= leaves;
    }

    /**
     * How far a point lies off a triangle at least: from its box along an axis, or from its plane. No more than the distance, and
     * 0 on it, up to rounding.
     */
    static double gap(float[] v, int a, int b, int c, int step, double x, double y, double z) {
        double gap = 0;
        for (int axis = 0; axis < 3; axis++) {
            int k = axis * step;
            double p = of(axis, x, y, z);
            gap = Math.max(gap, Math.max(Math.min(v[a + k], Math.min(v[b + k], v[c + k])) - p,
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
        return length > 0 ? Math.max(gap, plane / length) : gap;
    }
}

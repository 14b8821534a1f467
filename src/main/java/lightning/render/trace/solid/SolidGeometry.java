package lightning.render.trace.solid;

/**
 * Scalar intersection code of one kind of canonical solid; lane versions repeat it operation by operation.
 *
 * <p>The data of a solid begins at {@code data[at]}. First come the {@value #MAP_SIZE} numbers of the transform from render
 * space to local space, row by row, m00 m01 m02 t0 m10 … t2; then the solid's parameters, if any. Points and rays are in local
 * space unless stated otherwise. Directions have any length.
 */
public abstract class SolidGeometry {
    /** Distance for a ray that misses the solid. */
    public static final double MISS = Double.POSITIVE_INFINITY;
    /** Number of values of a solid's transform. */
    public static final int MAP_SIZE = 12;

    SolidGeometry() {}

    /** Writes the minimum of mx·x + my·y + mz·z + t over the solid to {@code box[i]} and the maximum to {@code box[i + 3]}. */
    public abstract void extent(double[] data, int at, double mx, double my, double mz, double t, double[] box, int i);

    /** Returns the smallest distance {@code t > 0} at which a ray hits the surface, or {@code +∞}. */
    public abstract double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz);

    /**
     * Returns the distance to the surface for a ray with one end on it, or {@code +∞}.
     *
     * @param margin twice the distance from that end within which the side of the surface is undecidable
     */
    public abstract double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin);

    /**
     * Returns whether {@link #distance} is certain to be a miss for all rays within a range of heights.
     *
     * @param minY minimum y of their origins
     * @param maxY maximum y of their origins
     * @param minDirectionY minimum y of their directions
     * @param maxDirectionY maximum y of their directions
     */
    public abstract boolean isCertainMiss(double minY, double maxY, double minDirectionY, double maxDirectionY);

    /**
     * Returns approximately the midpoint of the ray's interval inside a convex solid, at which to evaluate
     * {@link #insideDepth}. Any number, or NaN, if the ray is never inside.
     */
    public double chordMidpoint(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        return Double.NaN;
    }

    /**
     * Returns the depth of a point inside a convex solid: the ball around it with this radius is inside. Below 0, the ball with
     * the negated radius is outside. Local units; exact except for a few roundings.
     *
     * @return −∞ for a solid without an inside, and for one whose distances
     *     {@code lightning.render.trace.tree.FullOcclusionTest} has no proof for
     */
    public double insideDepth(double[] data, int at, double x, double y, double z) {
        return -MISS;
    }

    /**
     * Returns the maximum ratio of the length of a tip that a ray cuts off an edge or apex to the distance of the ray's end
     * from the surface.
     */
    public abstract double edgeMarginFactor(double[] data, int at);

    /**
     * Returns a lower bound on the distance of a point from the surface, scene units.
     *
     * @param maxScale maximum local length of a step of at most 1 along each axis of the scene
     */
    public abstract double surfaceDistance(double[] data, int at, double x, double y, double z, double maxScale);

    /** Writes an outward direction of any length at a point on the surface to {@code out[0 … 2]}; 0 at an apex. */
    public abstract void outwardNormal(double[] data, int at, double x, double y, double z, double[] out);

    /** Writes the texture coordinates, horizontal and upward, at a point on the surface to {@code uv[0]} and {@code uv[1]}. */
    public abstract void textureCoordinates(double[] data, int at, double x, double y, double z, double[] uv);

    /**
     * Writes the gradients of the texture coordinates at a point on the surface to {@code to[0 … 2]} and {@code to[3 … 5]}.
     * Their components perpendicular to the surface are undefined. 0 where there is no gradient.
     */
    public abstract void textureGradients(double[] data, int at, double x, double y, double z, double[] to);

    /** Writes the gradient of {@link #longitude} to {@code to[0 … 2]}; 0 on the axis, where it is undefined. */
    static void longitudeGradient(double x, double z, double[] to) {
        double square = 2 * Math.PI * (x * x + z * z);
        boolean offAxis = square > 0;
        to[0] = offAxis ? z / square : 0;
        to[1] = 0;
        to[2] = offAxis ? -x / square : 0;
    }

    /** Returns the longitude of a point, from 0 to 1. */
    static double longitude(double x, double z) {
        return StrictMath.atan2(x, z) / (2 * Math.PI) + 0.5;
    }
}

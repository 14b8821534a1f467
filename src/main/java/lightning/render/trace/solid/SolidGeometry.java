package lightning.render.trace.solid;

/**
 * What tracing must know of one kind of canonical solid, in the readable form that lanes repeat operation by operation.
 *
 * <p>A solid's data begin at {@code data[at]}: first the {@value #MAP_SIZE} numbers of the map from the scene to its own space, row by
 * row, m00 m01 m02 t0 m10 … t2; then numbers of its own, if it has any. Points and rays are in its own space, where not said
 * otherwise. Directions have any length.
 */
public abstract class SolidGeometry {
    /** The distance to a solid that a ray does not meet. */
    public static final double MISS = Double.POSITIVE_INFINITY;
    /** How many numbers of a solid are its map. */
    public static final int MAP_SIZE = 12;

    SolidGeometry() {}

    /** Writes the least of mx·x + my·y + mz·z + t over the solid to {@code box[i]}, the greatest to {@code box[i + 3]}. */
    public abstract void extent(double[] data, int at, double mx, double my, double mz, double t, double[] box, int i);

    /** The least distance {@code t > 0} at which a ray meets the surface, or {@code +∞}. */
    public abstract double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz);

    /**
     * The distance to the surface for a way of which an end lies on it, or {@code +∞}.
     *
     * @param margin twice the distance from that end up to which it cannot be told which side of the surface a point is on
     */
    public abstract double distance(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact touch, double margin);

    /**
     * Whether {@link #distance} is a miss for certain: what it tells of some rays, of which only heights are known.
     *
     * @param minY     the least y of their origins
     * @param maxY    the greatest
     * @param minDirectionY the least y of their directions
     * @param maxDirectionY  the greatest
     */
    public abstract boolean isCertainMiss(double minY, double maxY, double minDirectionY, double maxDirectionY);

    /**
     * About the middle of the times at which a ray is inside a convex solid: where to ask for {@link #insideDepth}. Any number, or NaN, where it is
     * never inside.
     */
    public double chordMidpoint(double[] data, int at, double ox, double oy, double oz, double dx, double dy, double dz) {
        return Double.NaN;
    }

    /**
     * How far a point lies inside a convex solid: the ball about it of that radius is inside; where it is below 0, the ball of minus that radius
     * is outside. Own units; exact but for a few roundings.
     *
     * @return −∞ for a solid without an inside, and for one whose distances {@code lightning.render.trace.tree.FullOcclusionTest} has no proof about
     */
    public double insideDepth(double[] data, int at, double x, double y, double z) {
        return -MISS;
    }

    /** How many times as long as its end lies off the surface a tip can be that a way cuts off an edge or an apex. */
    public abstract double edgeMarginFactor(double[] data, int at);

    /**
     * How far a point lies off the surface at least, scene units.
     *
     * @param maxScale how long a step of at most 1 along each axis of the scene can be in own units
     */
    public abstract double surfaceDistance(double[] data, int at, double x, double y, double z, double maxScale);

    /** Writes a direction of any length that leads out of the surface at a point on it to {@code out[0 … 2]}; 0 at an apex. */
    public abstract void outwardNormal(double[] data, int at, double x, double y, double z, double[] out);

    /** Writes the texture coordinates at a point on the surface, across and upwards, to {@code uv[0]} and {@code uv[1]}. */
    public abstract void textureCoordinates(double[] data, int at, double x, double y, double z, double[] uv);

    /**
     * Writes the gradients of the texture coordinates at a point on the surface to {@code to[0 … 2]} and {@code to[3 … 5]}; what they
     * have at a right angle to the surface means nothing. 0 where there is none.
     */
    public abstract void textureGradients(double[] data, int at, double x, double y, double z, double[] to);

    /** Writes the gradient of {@link #longitude} to {@code to[0 … 2]}; 0 on the axis, which has none. */
    static void longitudeGradient(double x, double z, double[] to) {
        double square = 2 * Math.PI * (x * x + z * z);
        boolean offAxis = square > 0;
        to[0] = offAxis ? z / square : 0;
        to[1] = 0;
        to[2] = offAxis ? -x / square : 0;
    }

    /** The longitude of a point, from 0 to 1. */
    static double longitude(double x, double z) {
        return StrictMath.atan2(x, z) / (2 * Math.PI) + 0.5;
    }
}

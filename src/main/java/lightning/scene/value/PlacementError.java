package lightning.scene.value;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Error bounds of a placed shape's maps against exact arithmetic, accumulated over its groups: a running error analysis (Higham, Accuracy
 * and Stability of Numerical Algorithms, §3.3).
 *
 * @param toWorld           error bound of each number of the map to the scene
 * @param directionsToLocal error bound of each number of the inverse map of directions
 */
public record PlacementError(Transform toWorld, Transform directionsToLocal) {
    private static final Transform ZERO = Transform.IDENTITY.times(0);
    public static final PlacementError NONE = new PlacementError(ZERO, ZERO);

    /** Relative error of a decimal stored as a double, or of a product. */
    private static final double UNIT_ROUNDOFF = 0x1p-53;
    /** Error of a sum of three products and a fourth term, relative to the sum of their sizes: 4 units and second-order terms. */
    private static final double SUM_ERROR = 4.125 * UNIT_ROUNDOFF;
    /** Error of a sum of two products, as in a rotation about an axis: 2 units and second-order terms. */
    private static final double TURN_ERROR = 2.125 * UNIT_ROUNDOFF;
    /** Error of a factor: a decimal, its inverse, the product with it, and second-order terms. */
    private static final double FACTOR_ERROR = 3.125 * UNIT_ROUNDOFF;

    /**
     * Returns the bounds for a placement within groups.
     *
     * @param outer        product of the maps of the enclosing groups
     * @param outerInverse product of their inverses
     */
    public PlacementError compose(Transform outer, Transform outerInverse, Placement placement) {
        Transform rotationError = rotationError(placement.rotation());
        Vec3 s = placement.scale();
        Transform scaling = Transform.scaling(s).absolute();
        Transform inverseScaling = Transform.scaling(new Vec3(1 / s.x(), 1 / s.y(), 1 / s.z())).absolute();
        Transform map = placement.transform();
        Transform inverse = placement.directionsToLocal();
        Transform mapError = rotationError.times(scaling).plus(map.absolute().linearPart().times(FACTOR_ERROR))
                .plus(map.absolute().plus(map.absolute().linearPart().times(-1)).times(UNIT_ROUNDOFF));
        Transform inverseError = inverseScaling.times(rotationError.transposed()).plus(inverse.absolute().times(FACTOR_ERROR));
        return this == NONE ? new PlacementError(mapError, inverseError)
                : new PlacementError(productError(outer, toWorld, map, mapError, SUM_ERROR),
                        productError(inverse, inverseError, outerInverse, directionsToLocal, SUM_ERROR));
    }

    /** Returns an error bound of the shape's origin, scene units. */
    public double positionError() {
        return Math.max(Math.max(toWorld.t0(), toWorld.t1()), toWorld.t2());
    }

    /** Returns the error of a·b, given the errors {@code ea} and {@code eb} and the rounding of each sum. */
    private static Transform productError(Transform a, Transform ea, Transform b, Transform eb, double rounding) {
        return a.absolute().linearPart().times(eb).plus(ea.times(b.absolute().plus(eb)))
                .plus(a.absolute().times(b.absolute()).times(rounding));
    }

    /** Returns the error of {@link Transform#rotation}. */
    private static Transform rotationError(Vec3 degrees) {
        if (degrees.maxAbs() == 0) {
            return ZERO;
        }
        double[] x = trigError(degrees.x());
        double[] y = trigError(degrees.y());
        double[] z = trigError(degrees.z());
        Transform rx = Transform.rotation(new Vec3(degrees.x(), 0, 0));
        Transform ry = Transform.rotation(new Vec3(0, degrees.y(), 0));
        Transform rz = Transform.rotation(new Vec3(0, 0, degrees.z()));
        Transform zy = productError(rz, new Transform(z[0], z[1], 0, 0, z[1], z[0], 0, 0, 0, 0, 0, 0),
                ry, new Transform(y[0], 0, y[1], 0, 0, 0, 0, 0, y[1], 0, y[0], 0), TURN_ERROR);
        return productError(rz.times(ry), zy, rx, new Transform(0, 0, 0, 0, 0, x[0], x[1], 0, 0, x[1], x[0], 0), TURN_ERROR);
    }

    /**
     * Returns the errors of the cosine and the sine of an angle. The angle in radians has a relative error of one unit each for the decimal
     * (including whole turns), the quarter turn that makes a cosine of a sine, π/180, and the product. The functions have an error of one
     * unit in the last place.
     */
    private static double[] trigError(double degrees) {
        if (degrees % 90 == 0) {
            return new double[] {0, 0};
        }
        double decimal = Math.toRadians(Math.abs(degrees));
        double angle = Math.toRadians(Math.abs(degrees % 360));
        double cosine = Math.abs(Transform.cosDegrees(degrees));
        double sine = Math.abs(Transform.sinDegrees(degrees));
        // The square of the error bounds the terms beyond first order.
        double first = UNIT_ROUNDOFF * (decimal + 3 * (angle + Math.PI / 2));
        return new double[] {UNIT_ROUNDOFF * ((decimal + 3 * angle) * sine + 2 * cosine) + first * first,
            first * cosine + UNIT_ROUNDOFF * 2 * sine + first * first};
    }
}

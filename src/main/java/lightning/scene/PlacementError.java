package lightning.scene;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Bounds on the error of a placed shape's maps against those that its numbers mean, group by group: a running error
 * analysis (Higham, Accuracy and Stability of Numerical Algorithms, §3.3).
 *
 * @param toWorld        how far each number of the map to the scene may be off
 * @param directionsToLocal how far each number of the map of directions back may be off
 */
public record PlacementError(Transform toWorld, Transform directionsToLocal) {
    private static final Transform ZERO = Transform.IDENTITY.times(0);
    static final PlacementError NONE = new PlacementError(ZERO, ZERO);

    /** How far a decimal may be off as a double, as a share of itself, or a product. */
    private static final double UNIT_ROUNDOFF = 0x1p-53;
    /** Of a sum of three products and a fourth term, as a share of the sizes of all: 4 units, and a little for the units' units. */
    private static final double SUM_ERROR = 4.125 * UNIT_ROUNDOFF;
    /** Of a sum of two products, as about an axis: 2 units and a little. */
    private static final double TURN_ERROR = 2.125 * UNIT_ROUNDOFF;
    /** Of a factor: a decimal, its inverse, and the product with it, and a little. */
    private static final double FACTOR_ERROR = 3.125 * UNIT_ROUNDOFF;

    /**
     * The bounds for something placed within groups.
     *
     * @param outer the product of the maps of the groups around it
     * @param outerInverse   the product of their inverses
     */
    PlacementError compose(Transform outer, Transform outerInverse, Placement placement) {
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

    /** A bound on how far the shape's own origin may be off, scene units. */
    public double positionError() {
        return Math.max(Math.max(toWorld.t0(), toWorld.t1()), toWorld.t2());
    }

    /** The error of a·b where that of a is {@code ea}, that of b is {@code eb}, and each of its sums is rounded. */
    private static Transform productError(Transform a, Transform ea, Transform b, Transform eb, double rounding) {
        return a.absolute().linearPart().times(eb).plus(ea.times(b.absolute().plus(eb)))
                .plus(a.absolute().times(b.absolute()).times(rounding));
    }

    /** That of {@link Transform#rotation}. */
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
     * The errors of the cosine and the sine of an angle. In radians it is off by a unit of itself for each of: the decimal,
     * whole turns included; the quarter turn that makes a cosine of a sine; π/180, and the product with it. The functions are
     * off by a unit in their last place.
     */
    private static double[] trigError(double degrees) {
        if (degrees % 90 == 0) {
            return new double[] {0, 0};
        }
        double decimal = Math.toRadians(Math.abs(degrees));
        double angle = Math.toRadians(Math.abs(degrees % 360));
        double cosine = Math.abs(Transform.cosDegrees(degrees));
        double sine = Math.abs(Transform.sinDegrees(degrees));
        // The square of the error is more than what its first order leaves out.
        double first = UNIT_ROUNDOFF * (decimal + 3 * (angle + Math.PI / 2));
        return new double[] {UNIT_ROUNDOFF * ((decimal + 3 * angle) * sine + 2 * cosine) + first * first,
            first * cosine + UNIT_ROUNDOFF * 2 * sine + first * first};
    }
}

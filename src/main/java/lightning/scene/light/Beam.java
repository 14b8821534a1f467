package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.SceneLimits;

/**
 * Directions in which a rectangle or disc shines, by the angle from its own direction. Both factors act at each point of the face, so the edge of
 * the light is soft at a distance that is not large compared with the face.
 *
 * <p>The cone is that of UsdLux ({@code ShapingAPI}): full light up to (1 − softness)·cone, then 1 − t²(3 − 2t) to the cone's edge.
 *
 * <p>The spread is that of Cycles, of a softbox behind a grid: at angle θ its slats pass max(0, 1 − tan θ / tan spread) (Blender, source of Cycles,
 * {@code area_light_spread_attenuation}). Cycles also makes the light brighter so that its power stays, by tan a / (tan a − a).
 *
 * @param cone     half-angle beyond which there is no light, degrees; 90 is open
 * @param softness width of the cone's soft edge, as a share of its angle
 * @param spread   half-angle at which the slats pass no more light, degrees; 90 is no grid
 */
@RecordBuilder
public record Beam(double cone, double softness, double spread) implements BeamBuilder.With {
    /** Cone and spread that hold nothing back, in degrees. */
    public static final double OPEN_ANGLE = 90;
    static final NumericKind<Double> CONES = NumericKind.degrees(0, OPEN_ANGLE, 1);
    static final NumericKind<Double> SOFTNESSES = NumericKind.number(0, 1, 0.1);
    static final NumericKind<Double> SPREADS = NumericKind.degrees(SceneLimits.MIN_BEAM_SPREAD, OPEN_ANGLE, 1);
    /** All light of a face. */
    public static final Beam OPEN = new Beam(OPEN_ANGLE, 0, OPEN_ANGLE);
    /** Intervals of Simpson's rule on each side of the beginning of the soft edge. */
    private static final int INTERVALS = 128;
    /** Natural logarithm of a share of the light that does not count. */
    private static final double NEGLIGIBLE = -40;

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Beam {
        CONES.check("cone", cone);
        SOFTNESSES.check("cone_softness", softness);
        SPREADS.check("beam_spread", spread);
    }

    /** Returns whether the factor is 1 everywhere in front of the face. */
    public boolean isOpen() {
        return !hasCone() && !hasSpread();
    }

    private boolean hasCone() {
        return cone < OPEN_ANGLE || softness > 0;
    }

    private boolean hasSpread() {
        return spread < OPEN_ANGLE;
    }

    /** Returns the largest angle at which it passes light, in degrees. */
    public double outerAngle() {
        return Math.min(cone, spread);
    }

    /**
     * Returns the factor at a point, 0…1. Uses StrictMath for the same result on every machine.
     *
     * @param across  distance from the axis, ≥ 0
     * @param forward distance along the axis
     */
    public double factor(double across, double forward) {
        return (hasCone() ? coneFactor(Math.toDegrees(StrictMath.atan2(across, forward))) : 1)
                * (hasSpread() ? spreadFactor(across, forward) : 1);
    }

    private double coneFactor(double angle) {
        double start = (1 - softness) * cone;
        if (angle <= start) {
            return 1;
        }
        if (angle >= cone) {
            return 0;
        }
        double t = (angle - start) / (cone - start);
        return 1 - t * t * (3 - 2 * t);
    }

    private double spreadFactor(double across, double forward) {
        if (across == 0) {
            return 1;
        }
        return forward > 0 ? Math.max(0, 1 - across / (forward * StrictMath.tan(Math.toRadians(spread)))) : 0;
    }

    /**
     * Returns the flux of a face of 1 candela along its axis, in lumens: 2π times the integral of cosⁿ θ·factor·sin θ.
     *
     * @param exponent n, 1 for a face without focus
     */
    double flux(double exponent) {
        if (isOpen()) {
            return exponent == 1 ? Math.PI : 2 * Math.PI / (exponent + 1);
        }
        // Beyond this angle, a narrow focus leaves no light.
        double end = Math.min(Math.toRadians(outerAngle()), StrictMath.acos(StrictMath.exp(NEGLIGIBLE / (exponent + 1))));
        double start = Math.min(end, Math.toRadians((1 - softness) * cone));
        return 2 * Math.PI * (integral(0, start, exponent) + integral(start, end, exponent));
    }

    private double integral(double from, double to, double exponent) {
        double sum = 0;
        for (int i = 0; i <= INTERVALS && to > from; i++) {
            double angle = from + (to - from) * i / INTERVALS;
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            // The end of a hard cone is inside.
            double value = StrictMath.pow(Math.max(cos, 0), exponent) * sin
                    * (softness > 0 ? coneFactor(Math.toDegrees(angle)) : 1) * (hasSpread() ? spreadFactor(sin, cos) : 1);
            sum += value * (i == 0 || i == INTERVALS ? 1 : i % 2 == 0 ? 2 : 4);
        }
        return sum * (to - from) / INTERVALS / 3;
    }
}

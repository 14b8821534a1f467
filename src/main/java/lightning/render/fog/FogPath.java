package lightning.render.fog;

/**
 * Places along a whole ray at which fog is sampled for one light. They depend on the ray and the light's position only, so that they
 * stay where they are if anything else changes.
 *
 * <p>For a light at a point they are dense near it, as its falloff is: with x the distance along the ray from the point next to the light
 * and D the distance of that point from the light, equal steps of w = tan(θ/2), where tan θ = x/D. Steps of θ itself would be equiangular
 * (Kulla and Fajardo, Importance sampling techniques for path tracing in participating media, 2012); their density differs by a factor of two
 * at most, and this one needs no arctangent: x = D·2w/(1 − w²) and w = x/(√(x² + D²) + D).
 *
 * <p>For a directional light, t = s·u/(1 − u) where s is the distance to the point that the camera looks at. Not thread-safe.
 */
public final class FogPath {
    /** Smallest distance of a ray from a light, relative to the light's distance from the origin and to the scale. */
    private static final double MIN_OFFSET = 1e-3;
    private static final double MIN_SHARE_OF_SCALE = 1e-6;

    private boolean isPoint;
    private double scale;
    /** Distance along the ray of the point next to the light. */
    private double nearest;
    private double offset;
    private double start;

    /**
     * Sets a ray and the position of a light.
     *
     * @param lx    x of the light relative to the ray's origin, scene units, as {@code ly} and {@code lz}
     * @param dx    x of the ray's unit direction, as {@code dy} and {@code dz}
     * @param scale distance to the point that the camera looks at
     */
    public void aimAtPoint(double lx, double ly, double lz, double dx, double dy, double dz, double scale) {
        isPoint = true;
        double squared = lx * lx + ly * ly + lz * lz;
        nearest = lx * dx + ly * dy + lz * dz;
        double distance = Math.sqrt(squared);
        double perpendicular = squared - nearest * nearest;
        offset = Math.max(Math.sqrt(perpendicular > 0 ? perpendicular : 0), Math.max(MIN_OFFSET * distance, MIN_SHARE_OF_SCALE * scale));
        start = halfTangent(-nearest);
    }

    /** Sets a directional light. */
    public void aimAlong(double toScale) {
        isPoint = false;
        scale = toScale;
    }

    private double halfTangent(double x) {
        return x / (Math.sqrt(x * x + offset * offset) + offset);
    }

    /** Returns the distance along the ray of a place, 0…1; ≥ 0, infinite for 1. */
    public double distance(double place) {
        if (place >= 1) {
            return Double.POSITIVE_INFINITY;
        }
        if (!isPoint) {
            return scale * place / (1 - place);
        }
        double w = start + (1 - start) * place;
        double distance = nearest + offset * (2 * w / ((1 - w) * (1 + w)));
        return distance > 0 ? distance : 0;
    }

    /** Returns whether the light is at a point, so that its samples are dense near it. */
    public boolean isPoint() {
        return isPoint;
    }

    /** Returns the derivative of the distance to a point light's place, 0…1, exclusive. */
    public double slope(double place) {
        double w = start + (1 - start) * place;
        double product = (1 - w) * (1 + w);
        return (1 - start) * offset * (2 * (1 + w * w) / (product * product));
    }

    /** Returns the place of a distance along the ray, 0…1. */
    public double place(double distance) {
        if (distance == Double.POSITIVE_INFINITY) {
            return 1;
        }
        double place = isPoint ? (halfTangent(distance - nearest) - start) / (1 - start) : distance / (scale + distance);
        return place > 0 ? place < 1 ? place : 1 : 0;
    }
}

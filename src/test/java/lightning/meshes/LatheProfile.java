package lightning.meshes;

import lightning.base.math.Vec3;
import lightning.meshes.ParametricSurface.SurfaceFunction;

/**
 * A curve through points in the half plane of radius and height, by Catmull and Rom's splines (1974): what a lathe follows.
 *
 * @param points radius, height, radius, height …; at least two points
 */
record LatheProfile(double... points) {
    /** The body that a lathe makes. */
    SurfaceFunction revolve() {
        return fluted(0, 0, 0);
    }

    /**
     * The body whose cross-section is a flower.
     *
     * @param petals how many; {@code depth} is how far they go in and out, as a part of the radius
     * @param turns  how often a petal goes round from the bottom to the top
     */
    SurfaceFunction fluted(int petals, double depth, double turns) {
        return (u, v) -> {
            double angle = 2 * Math.PI * (u - Math.floor(u));
            double r = interpolate(v, 0) * (1 + depth * StrictMath.cos(petals * angle + 2 * Math.PI * petals * turns * v));
            return new Vec3(r * StrictMath.cos(angle), interpolate(v, 1), -r * StrictMath.sin(angle));
        };
    }

    private double interpolate(double v, int coordinate) {
        int spans = points.length / 2 - 1;
        double along = Math.clamp(v, 0, 1) * spans;
        int span = Math.min((int) along, spans - 1);
        double t = along - span;
        double a = point(span - 1, coordinate);
        double b = point(span, coordinate);
        double c = point(span + 1, coordinate);
        double d = point(span + 2, coordinate);
        double value = b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
        return coordinate == 0 ? Math.max(0, value) : value;
    }

    private double point(int i, int coordinate) {
        return points[2 * Math.clamp(i, 0, points.length / 2 - 1) + coordinate];
    }
}

package lightning.meshes;

import lightning.base.math.Vec3;
import lightning.meshes.ParametricSurface.SurfaceFunction;

/**
 * Profile curve of a lathe: a {@link Spline} in the half plane of radius and height.
 *
 * @param points radius, height, radius, height …; at least two points
 */
record LatheProfile(double... points) {
    /** Returns the surface of revolution. */
    SurfaceFunction revolve() {
        return fluted(0, 0, 0);
    }

    /**
     * Returns a surface with a flower-shaped cross-section.
     *
     * @param petals number of petals
     * @param depth  depth of the petals, relative to the radius
     * @param turns  turns of a petal from bottom to top
     */
    SurfaceFunction fluted(int petals, double depth, double turns) {
        return (u, v) -> {
            double angle = 2 * Math.PI * (u - Math.floor(u));
            double r = interpolate(v, 0) * (1 + depth * StrictMath.cos(petals * angle + 2 * Math.PI * petals * turns * v));
            return new Vec3(r * StrictMath.cos(angle), interpolate(v, 1), -r * StrictMath.sin(angle));
        };
    }

    private double interpolate(double v, int coordinate) {
        double value = new Spline(false, points).at(v, coordinate);
        return coordinate == 0 ? Math.max(0, value) : value;
    }
}

package lightning.format.exchange.usd;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Factors by which the transforms of lights scale their sizes. A round light that becomes an ellipse gets the round size of the same area, and so
 * the same power.
 */
final class LightScales {
    private static final double SHARE = 1e-4;
    private static final int STEPS = 256;

    private LightScales() {}

    /** Returns the lengths of the axes of a transform. */
    static Vec3 of(Transform m) {
        return UsdNumbers.rounded(new Vec3(m.transformVector(new Vec3(1, 0, 0)).length(), m.transformVector(Vec3.Y).length(),
                m.transformVector(new Vec3(0, 0, 1)).length()));
    }

    /** Returns whether two factors leave a circle round. */
    static boolean isRound(double a, double b) {
        return Math.abs(a - b) <= SHARE * Math.max(a, b);
    }

    /** Returns the factor of a sphere's radius: that of the sphere with the surface of the ellipsoid. */
    static double sphere(Vec3 scale) {
        if (isRound(scale.x(), scale.y()) && isRound(scale.x(), scale.z())) {
            return (scale.x() + scale.y() + scale.z()) / 3;
        }
        // The mean, over the unit sphere, of how much the surface is enlarged there.
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double z = (i + 0.5) / STEPS;
            for (int j = 0; j < STEPS; j++) {
                double angle = (j + 0.5) / STEPS * Math.PI / 2;
                double x = Math.sqrt(1 - z * z) * Math.cos(angle);
                double y = Math.sqrt(1 - z * z) * Math.sin(angle);
                sum += new Vec3(scale.y() * scale.z() * x, scale.x() * scale.z() * y, scale.x() * scale.y() * z).length();
            }
        }
        return Math.sqrt(sum / (STEPS * STEPS));
    }

    /** Returns the factor of a disk's radius: that of the disk with the area of the ellipse. */
    static double disk(Vec3 scale) {
        return isRound(scale.x(), scale.y()) ? (scale.x() + scale.y()) / 2 : Math.sqrt(scale.x() * scale.y());
    }

    /** Returns the factor of a cylinder's radius, whose length is along x: that of the circle with the circumference of the ellipse. */
    static double tube(Vec3 scale) {
        if (isRound(scale.y(), scale.z())) {
            return (scale.y() + scale.z()) / 2;
        }
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double angle = (i + 0.5) / STEPS * Math.PI / 2;
            sum += Math.hypot(scale.y() * Math.cos(angle), scale.z() * Math.sin(angle));
        }
        return sum / STEPS;
    }
}

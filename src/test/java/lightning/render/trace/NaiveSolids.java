package lightning.render.trace;

import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.node.Solid;

/**
 * Textbook intersection formulas, for comparison with {@link lightning.render.trace.solid.SolidGeometry}: the plain quadratic
 * formula, the smallest positive root, side and caps separately.
 */
final class NaiveSolids {
    private NaiveSolids() {}

    static double distance(Solid.Canonical solid, double ox, double oy, double oz, double dx, double dy, double dz) {
        return switch (solid) {
            case Solid.Sphere _ -> sphere(ox, oy, oz, dx, dy, dz);
            case Solid.Cone _ -> cone(ox, oy, oz, dx, dy, dz);
            case Solid.Cylinder _ -> cylinder(ox, oy, oz, dx, dy, dz);
            case Solid.Frustum _ -> throw new IllegalArgumentException("no textbook has a frustum");
            case Solid.Plane _ -> CanonicalSolids.plane(ox, oy, oz, dx, dy, dz);
        };
    }

    static double sphere(double ox, double oy, double oz, double dx, double dy, double dz) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = ox * dx + oy * dy + oz * dz;
        double c = ox * ox + oy * oy + oz * oz - 1;
        double root = Math.sqrt(b * b - a * c);
        return nearestPositive((-b - root) / a, (-b + root) / a);
    }

    static double cylinder(double ox, double oy, double oz, double dx, double dy, double dz) {
        double a = dx * dx + dz * dz;
        double b = ox * dx + oz * dz;
        double c = ox * ox + oz * oz - 1;
        double root = Math.sqrt(b * b - a * c);
        double side = nearestPositive(insideHeight((-b - root) / a, oy, dy), insideHeight((-b + root) / a, oy, dy));
        return nearestPositive(side, nearestPositive(cap(0, ox, oy, oz, dx, dy, dz), cap(1, ox, oy, oz, dx, dy, dz)));
    }

    static double cone(double ox, double oy, double oz, double dx, double dy, double dz) {
        double h = 1 - oy;
        double a = dx * dx + dz * dz - dy * dy;
        double b = ox * dx + oz * dz + h * dy;
        double c = ox * ox + oz * oz - h * h;
        double root = Math.sqrt(b * b - a * c);
        double side = nearestPositive(insideHeight((-b - root) / a, oy, dy), insideHeight((-b + root) / a, oy, dy));
        return nearestPositive(side, cap(0, ox, oy, oz, dx, dy, dz));
    }

    private static double insideHeight(double t, double oy, double dy) {
        double y = oy + t * dy;
        return y >= 0 && y <= 1 ? t : SolidGeometry.MISS;
    }

    private static double cap(double height, double ox, double oy, double oz, double dx, double dy, double dz) {
        double t = (height - oy) / dy;
        double x = ox + t * dx;
        double z = oz + t * dz;
        return x * x + z * z <= 1 ? t : SolidGeometry.MISS;
    }

    /** Returns the smaller positive value; NaN is a miss. */
    private static double nearestPositive(double s, double t) {
        double a = s > 0 ? s : SolidGeometry.MISS;
        double b = t > 0 ? t : SolidGeometry.MISS;
        return a < b ? a : b;
    }
}

package lightning.format.nff;

import java.util.Locale;
import lightning.base.math.Vec3;

/**
 * Utah teapot (Newell 1975) as NFF patches, from its published control points: a quarter of the round parts, and half of
 * handle and spout; the rest follows by rotation and reflection.
 */
public final class Teapot {
    /** Radius and height of the control points along a quarter's edge: lid in two parts, rim, body in two parts, bottom. */
    private static final double[][] ROTATED_PROFILES = {
        {0, 3.15, 0.8, 3.15, 0, 2.85, 0.2, 2.7}, {0.2, 2.7, 0.4, 2.55, 1.3, 2.55, 1.3, 2.4},
        {1.4, 2.4, 1.3375, 2.53125, 1.4375, 2.53125, 1.5, 2.4}, {1.5, 2.4, 1.75, 1.875, 2, 1.35, 2, 0.9},
        {2, 0.9, 2, 0.45, 1.5, 0.225, 1.5, 0.15}, {1.5, 0.15, 1.5, 0.075, 1.425, 0, 0, 0}};
    /** Four edges of each half patch, four points each: x and z inside, half the width y, x and z outside. */
    private static final double[][] HALF_PROFILES = {
        {-1.6, 2.025, 0.3, -1.5, 2.25, -2.3, 2.025, 0.3, -2.5, 2.25, -2.7, 2.025, 0.3, -3, 2.25, -2.7, 1.8, 0.3, -3, 1.8},
        {-2.7, 1.8, 0.3, -3, 1.8, -2.7, 1.575, 0.3, -3, 1.35, -2.5, 1.125, 0.3, -2.65, 0.9375, -2, 0.9, 0.3, -1.9, 0.6},
        {1.7, 1.425, 0.66, 1.7, 0.6, 2.6, 1.425, 0.66, 3.1, 0.825, 2.3, 2.1, 0.25, 2.4, 2.025, 2.7, 2.4, 0.25, 3.3, 2.4},
        {2.7, 2.4, 0.25, 3.3, 2.4, 2.8, 2.475, 0.25, 3.525, 2.49375, 2.9, 2.475, 0.15, 3.45, 2.5125, 2.8, 2.4, 0.15, 3.2, 2.4}};
    /** Distance of the inner control points of a quarter circle along its tangents, in the original teapot. */
    private static final double CIRCLE_TANGENT = 0.56;

    private final StringBuilder out = new StringBuilder();
    private final int steps;

    private Teapot(int steps) {
        this.steps = steps;
    }

    public static String text(int steps) {
        var teapot = new Teapot(steps);
        teapot.out.append("v\nfrom 4.86 7.2 5.4\nat 0 0 1.2\nup 0 0 1\nangle 45\nhither 1\nresolution 64 64\nb 0.078 0.361 0.753\n")
                .append("l -3.1 9.8 12.1\nl 11.3 5.1 8.8\nf 1 0.75 0.33 0.8 0.2 20 0 0\n");
        for (double[] profile : ROTATED_PROFILES) {
            for (int quarter = 0; quarter < 4; quarter++) {
                teapot.appendPatches(rotatedPatches(profile, quarter));
            }
        }
        for (double[] half : HALF_PROFILES) {
            teapot.appendPatches(mirroredPatches(half, 1));
            teapot.appendPatches(mirroredPatches(half, -1));
        }
        return teapot.out.toString();
    }

    private static Vec3[][] rotatedPatches(double[] profile, int quarter) {
        double[] radius = {1, 1, CIRCLE_TANGENT, 0};
        Vec3[][] points = new Vec3[4][4];
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                double x = profile[2 * i] * radius[j];
                double y = profile[2 * i] * radius[3 - j];
                points[i][j] = switch (quarter) {
                    case 0 -> new Vec3(x, y, profile[2 * i + 1]);
                    case 1 -> new Vec3(-y, x, profile[2 * i + 1]);
                    case 2 -> new Vec3(-x, -y, profile[2 * i + 1]);
                    default -> new Vec3(y, -x, profile[2 * i + 1]);
                };
            }
        }
        return points;
    }

    private static Vec3[][] mirroredPatches(double[] edges, int side) {
        Vec3[][] points = new Vec3[4][4];
        for (int i = 0; i < 4; i++) {
            int e = 5 * i;
            double y = side * edges[e + 2];
            points[i] = new Vec3[] {new Vec3(edges[e], 0, edges[e + 1]), new Vec3(edges[e], y, edges[e + 1]),
                new Vec3(edges[e + 3], y, edges[e + 4]), new Vec3(edges[e + 3], 0, edges[e + 4])};
        }
        return points;
    }

    private void appendPatches(Vec3[][] points) {
        for (int i = 0; i < steps; i++) {
            for (int j = 0; j < steps; j++) {
                out.append("pp 4\n");
                corner(points, i, j);
                corner(points, i, j + 1);
                corner(points, i + 1, j + 1);
                corner(points, i + 1, j);
            }
        }
    }

    /** Writes a point and its normal; 0 at a pole, where a patch has none. */
    private void corner(Vec3[][] points, int i, int j) {
        double[] u = weights((double) i / steps);
        double[] v = weights((double) j / steps);
        Vec3 p = evaluate(points, u, v);
        Vec3 n = evaluate(points, derivatives((double) i / steps), v).cross(evaluate(points, u, derivatives((double) j / steps)));
        out.append(String.format(Locale.ROOT, "%.6f %.6f %.6f %.6f %.6f %.6f%n", p.x(), p.y(), p.z(), n.x(), n.y(), n.z()));
    }

    private static Vec3 evaluate(Vec3[][] points, double[] u, double[] v) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                sum = sum.plus(points[i][j].times(u[i] * v[j]));
            }
        }
        return sum;
    }

    private static double[] weights(double t) {
        double s = 1 - t;
        return new double[] {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    }

    private static double[] derivatives(double t) {
        double s = 1 - t;
        return new double[] {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
    }
}

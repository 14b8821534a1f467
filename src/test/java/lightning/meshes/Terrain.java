package lightning.meshes;

import lightning.base.math.Vec3;

/** Valley with a lake, forty units across: sums waves of many lengths, each rotated against the one before. */
final class Terrain {
    static final double SIZE = 40;

    private Terrain() {}

    static Vec3 at(double u, double v) {
        double x = SIZE * (u - 0.5);
        double z = SIZE * (0.5 - v);
        return new Vec3(x, height(x, z), z);
    }

    /** Returns the height; below 0 is under water. */
    static double height(double x, double z) {
        double rough = 0;
        double a = x + 3.1;
        double b = z - 7.7;
        double size = 1;
        for (int octave = 0; octave < 7; octave++) {
            double wave =
                    StrictMath.sin(0.21 * a + 1.3 * StrictMath.sin(0.17 * b)) * StrictMath.cos(0.19 * b + 0.8 * StrictMath.sin(0.23 * a));
            rough += size * (octave < 2 ? wave : 0.6 - Math.abs(wave));
            double turned = 1.6 * a - 1.2 * b + 1.7;
            b = 1.2 * a + 1.6 * b - 2.3;
            a = turned;
            size *= 0.44;
        }
        double valley = StrictMath.hypot(0.75 * (x + 1), z - 3) / 11;
        double far = Math.max(0, -z - 6) / 10;
        return -0.75 + 0.75 * Math.min(3, valley * valley) + (0.35 + 0.55 * Math.min(1.4, valley)) * rough * 0.9 + 2.1 * far * far;
    }
}

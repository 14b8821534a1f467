package lightning.meshes;

import static lightning.meshes.Prism.withRoundedCorners;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.math.Vec3;

/** Meshes of the theater stage: a grand piano, a harp, curtains and a block for furniture. */
final class StageProps {
    private static final double BEVEL = 0.012;
    /** Height at which the curtain is tied, of its whole height. */
    private static final double TIE = 0.3;
    private static final double TIED_WIDTH = 0.32;
    private static final int FOLDS = 9;

    private StageProps() {}

    static Map<String, ParametricSurface> all() {
        var all = new LinkedHashMap<String, ParametricSurface>();
        all.put("block", block().mesh());
        all.put("piano_case", piano(0, 0, 1, 0, 1, 0.36, 0.955, 0.36, 0.955, 0.2, 0, 0.2).mesh());
        all.put("piano_lid", piano(0, 0, 1, 0, 1, 0.028, 0, 0.028).mesh());
        all.put("harp_neck", new ParametricSurface(24, 96, true, StageProps::harpNeck));
        all.put("curtain", new ParametricSurface(120, 40, false, StageProps::curtain));
        all.put("swag", new ParametricSurface(40, 40, false, StageProps::swag));
        return all;
    }

    /** Cube of side 1 that stands on the origin. */
    private static Prism block() {
        double[] outline = withRoundedCorners(new double[] {-0.5, 0.5, 0.5, 0.5, 0.5, -0.5, -0.5, -0.5}, 0.03, true);
        return new Prism(outline, withRoundedCorners(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, 0.03, false), 0, 0);
    }

    /** Body with the outline of a grand piano: the keyboard at x = 0, the bent side at z > 0. */
    private static Prism piano(double... profile) {
        double[] outline = new Spline(true, 0, 0.74, 0.01, 0.75, 0.2, 0.75, 0.45, 0.75, 0.75, 0.74, 1.02, 0.68, 1.25, 0.53, 1.45, 0.32,
                1.65, 0.13,
                1.9, 0.03, 2.12, -0.01, 2.32, -0.12, 2.42, -0.36, 2.33, -0.62, 2.12, -0.74, 1.9, -0.75, 1.5, -0.75, 1, -0.75, 0.5, -0.75,
                0.01, -0.75, 0, -0.74, 0, -0.3, 0, 0.3, 0, 0.7).sampled(144);
        return new Prism(outline, withRoundedCorners(profile, BEVEL, false), 1, -0.15);
    }

    /** Neck of a harp in the plane z = 0, from its shoulder to its pillar at x = 0. */
    private static Vec3 harpNeck(double u, double v) {
        var middle =
                new Spline(false, 0.82, 1.18, 0.8, 1.33, 0.7, 1.42, 0.55, 1.4, 0.4, 1.37, 0.26, 1.45, 0.14, 1.62, 0.03, 1.76, -0.06, 1.74,
                        -0.075, 1.66, -0.02, 1.65);
        double t = Math.clamp(v, 0, 1);
        double before = Math.max(0, t - 1e-3);
        double after = Math.min(1, t + 1e-3);
        double dx = middle.at(after, 0) - middle.at(before, 0);
        double dy = middle.at(after, 1) - middle.at(before, 1);
        double length = Math.hypot(dx, dy);
        double end = Math.sqrt(Math.clamp(Math.min(t, 1 - t) * 30, 0, 1));
        double thick = end * (0.062 - 0.032 * t);
        double angle = 2 * Math.PI * (u - Math.floor(u));
        double aside = thick * StrictMath.cos(angle);
        return new Vec3(middle.at(t, 0) - aside * dy / length, middle.at(t, 1) + aside * dx / length,
                0.8 * thick * StrictMath.sin(angle));
    }

    /** Left curtain, one unit high and at most one wide: hangs from x = 0, tied back at its left. */
    private static Vec3 curtain(double u, double v) {
        double above = Math.clamp((v - TIE) / (1 - TIE), 0, 1);
        double below = Math.clamp((TIE - v) / TIE, 0, 1);
        double width = v > TIE ? TIED_WIDTH + (1 - TIED_WIDTH) * StrictMath.pow(above, 1.6) : TIED_WIDTH + 0.12 * Math.sqrt(below);
        double wave = 2 * Math.PI * FOLDS * u + 0.9 * StrictMath.sin(7 * u + 1) + 0.5 * StrictMath.sin(3 * v + 11 * u);
        double tied = StrictMath.exp(-Math.abs(v - TIE) * 14);
        double depth = 0.032 * (1 - 0.45 * tied) * (1 + 0.35 * StrictMath.sin(19 * u + 2));
        double z = depth * (StrictMath.sin(wave) + 0.25 * StrictMath.sin(2 * wave + 2 * v)) + 0.05 * tied * (1 - (2 * u - 1) * (2 * u - 1));
        // Inner folds fall lower on their way to the tie than outer ones.
        double sag = 0.1 * u * above * (1 - above) * 4;
        return new Vec3(width * (u + 0.018 * StrictMath.cos(wave)), v - sag, z);
    }

    /** Swag of a valance, from x = −1 to 1, one unit deep: hangs from y = 0 and is gathered at both ends. */
    private static Vec3 swag(double u, double v) {
        double x = 2 * u - 1;
        double open = 1 - x * x;
        double drop = 0.16 * v + 0.84 * v * StrictMath.pow(Math.max(0, open), 0.8);
        double fold = StrictMath.sin(2 * Math.PI * 4.5 * StrictMath.pow(Math.clamp(v, 0, 1), 1.15));
        double bulge = 0.3 * StrictMath.sin(Math.PI * 0.62 * v) * (0.3 + 0.7 * open);
        return new Vec3(x, -drop, bulge + 0.05 * fold * (0.35 + 0.65 * open));
    }
}

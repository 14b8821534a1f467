package lightning.render.lobe;

import lightning.base.math.PowerFunction;

/**
 * Lobe of upright fibers: a linearly transformed cosine, as in T. Zeltner, B. Burley and M. Chiang, Practical multiple-scattering sheen using
 * linearly transformed cosines, 2022. A direction w above the surface, whose normal is z and whose view lies in the plane of x and z, is mapped
 * to (A·x + B·z, A·y, z), which is distributed as a cosine. R is the albedo. A, B and R are polynomials that were fitted to pictures of planes
 * in Cycles (Blender 5.0), 12 roughnesses and 13 views; R differs by at most 0.011, and the values of the lobe by 2.3 % of its largest one on average.
 *
 * <p>Roughnesses are 0…1; those below {@value #MIN_ROUGHNESS} count as that, as nearly nothing is visible.
 */
public final class SheenLobe {
    static final double MIN_ROUGHNESS = 0.2;

    private SheenLobe() {}

    /** Returns the share of light that the fibers scatter, 0…1. @param cosine between the normal and the view, 0…1 */
    public static float albedo(double roughness, float cosine) {
        return SheenAlbedo.at(cosine, (float) roughness);
    }

    /** Returns the mean albedo in uniform light from all sides, 0…1. */
    public static float meanAlbedo(double roughness) {
        return SheenAlbedo.mean((float) roughness);
    }

    /**
     * Returns the light that the fibers send to the view under a light of weight 1, as the terms of the lighting equation: π·N·L times the value
     * of the lobe, at most 8.
     *
     * @param nv N·V, 0…1
     * @param nl N·L, above 0
     * @param vl V·L
     */
    public static double term(double roughness, double nv, double nl, double vl) {
        return albedo(roughness, (float) nv) * shape(roughness, nv, nl, vl);
    }

    /** Returns π times the density of the lobe per steradian. */
    static double shape(double roughness, double nv, double nl, double vl) {
        double a = a(roughness, nv);
        double b = slant(roughness, nv);
        double square = a * a;
        // |(A·x + B·z, A·y, z)|² of a unit vector, where B = b·sin and x·sin = V·L − N·V·N·L.
        double length = square + 2 * a * b * (vl - nv * nl) * nl + (1 + b * b * (1 - nv * nv) - square) * (nl * nl);
        return nl * square / (length * length);
    }

    /** Returns A. */
    static double a(double roughness, double nv) {
        double r = clamped(roughness);
        double constant = 0.0358 + r * (-0.181 + r * (1.5055 + r * -0.6416));
        return constant + nv * (0.6094 + r * (1.1279 + r * -0.8926) + nv * (-1.2498 + r * -0.1922 + nv * 0.7518));
    }

    /** Returns B, relative to the sine of the angle between normal and view. */
    static double slant(double roughness, double nv) {
        double r = clamped(roughness);
        return (1 - r) * (0.0715 + r * -0.7828 + nv * 0.3408);
    }

    private static double clamped(double roughness) {
        return roughness < MIN_ROUGHNESS ? MIN_ROUGHNESS : roughness;
    }

    /** Returns R without a table. */
    static double fittedAlbedo(double nv, double roughness) {
        double u = 1 / Math.max(roughness, MIN_ROUGHNESS);
        double constant = 0.1124 + u * (0.2683 + u * (-0.0889 + u * 0.0091));
        double first = -0.5633 + u * (1.184 + u * (0.0632 + u * -0.0077));
        double second = 0.4619 + u * (-1.0073 + u * (0.8289 + u * 0.0859));
        double third = -0.9962 + u * (0.8232 + u * (0.1537 + u * -0.266));
        double exponent = constant + nv * (first + nv * (second + nv * third));
        return PowerFunction.pow(0.5, Math.max(0, exponent) / PowerFunction.LN2);
    }
}

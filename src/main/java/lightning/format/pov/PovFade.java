package lightning.format.pov;

import static java.util.Objects.requireNonNull;

import lightning.scene.value.Attenuation;

/**
 * Light attenuation in POV-Ray's form, a factor of 2 / (1 + (d / distance)^power) on a light's color.
 *
 * @param gain factor on the light's color for which the products agree
 * @param distance scene units; 0 for a light without attenuation
 * @param power POV-Ray's fade_power
 * @param isExact true if both agree at every distance
 */
record PovFade(double gain, double distance, double power, boolean isExact) {
    /** Replacement for a constant term of 0, which POV-Ray's form cannot represent, relative to the other term at the far end. */
    private static final double MIN_CONSTANT = 1e-6;
    private static final int POWER_STEPS = 100;

    /**
     * Returns the closest POV-Ray attenuation.
     *
     * @param near smallest relevant distance, scene units, &gt; 0
     * @param far largest relevant distance, ≥ near
     */
    static PovFade of(Attenuation a, double near, double far) {
        if (a.isNone()) {
            return new PovFade(1, 0, 0, true);
        }
        if (a.linear() == 0 && a.quadratic() == 0) {
            return new PovFade(1 / a.constant(), 0, 0, true);
        }
        // The reciprocal is c + l·d + q·d², POV-Ray's a + b·d^power. The attenuation is also clamped at 1, which has no
        // effect for c ≥ 1.
        if (a.linear() == 0 || a.quadratic() == 0) {
            double power = a.linear() == 0 ? 2 : 1;
            return of(a.constant(), a.linear() + a.quadratic(), power, far, a.constant() >= 1);
        }
        return fit(a, near, far);
    }

    private static PovFade of(double constant, double factor, double power, double far, boolean isExact) {
        double c = Math.max(constant, MIN_CONSTANT * factor * Math.pow(far, power));
        double distance = Math.pow(c / factor, 1 / power);
        // If the clamp applies everywhere, or one term is negligible, there is no fading.
        return Double.isInfinite(distance) ? new PovFade(1 / c, 0, 0, isExact) : new PovFade(1 / (2 * c), distance, power, isExact);
    }

    /** Returns the power between 1 and 2 for which both agree exactly at both ends and closely in between. */
    private static PovFade fit(Attenuation a, double near, double far) {
        double atNear = reciprocal(a, near);
        double atFar = reciprocal(a, far);
        double minError = Double.POSITIVE_INFINITY;
        PovFade best = null;
        for (int i = 0; i <= POWER_STEPS; i++) {
            double power = 1 + (double) i / POWER_STEPS;
            double n = Math.pow(near, power);
            double f = Math.pow(far, power);
            double factor = f > n ? (atFar - atNear) / (f - n) : atNear / n;
            PovFade fade = of(Math.max(atNear - factor * n, 0), factor, power, far, false);
            double error = fade.maxError(a, near, far);
            if (best == null || error < minError) {
                best = fade;
            }
            minError = error < minError ? error : minError;
        }
        return requireNonNull(best);
    }

    private double maxError(Attenuation a, double near, double far) {
        double worst = 0;
        for (int i = 0; i <= 16; i++) {
            double d = near + (far - near) * i / 16;
            worst = Math.max(worst, Math.abs(factor(d) * reciprocal(a, d) - 1));
        }
        return worst;
    }

    /** Returns the attenuation factor in POV-Ray's form at a distance. */
    double factor(double d) {
        return distance == 0 ? gain : gain * 2 / (1 + Math.pow(d / distance, power));
    }

    private static double reciprocal(Attenuation a, double d) {
        return Math.max(a.constant() + a.linear() * d + a.quadratic() * d * d, 1);
    }
}

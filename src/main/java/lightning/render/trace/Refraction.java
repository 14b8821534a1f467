package lightning.render.trace;

import lightning.scene.material.Transmission;

/**
 * Refraction and Fresnel reflection at a transparent surface, from the values that a row stores.
 *
 * <p>Unit normal N faces the ray; V is its unit direction; c = −N·V. η is the index of refraction in front of the surface
 * divided by the index behind the surface; k = 1 − η²(1 − c²). By Snell's law the refracted direction is η·V + (η·c − √k)·N; for k ≤ 0
 * reflection is total.
 */
public final class Refraction {
    private Refraction() {}

    /** Returns η for a ray from outside, or from inside. */
    public static double eta(Transmission transmission, boolean inside) {
        return transmission.thin() ? 1 : inside ? transmission.ior() : 1 / transmission.ior();
    }

    private static double cosine(float nx, float ny, float nz, float vx, float vy, float vz) {
        return Math.abs((double) nx * vx + (double) ny * vy + (double) nz * vz);
    }

    /**
     * Writes the direction, of length 1, of the refracted ray.
     *
     * @param to receives x, y, z, {@code double[3]}
     * @return true if there is a refracted ray; otherwise nothing is written
     */
    public static boolean writeDirection(float nx, float ny, float nz, float vx, float vy, float vz, double eta, double[] to) {
        double c = cosine(nx, ny, nz, vx, vy, vz);
        double k = 1 - eta * eta * (1 - c * c);
        if (!(k > 0)) {
            return false;
        }
        double along = eta * c - Math.sqrt(k);
        double x = eta * vx + along * nx;
        double y = eta * vy + along * ny;
        double z = eta * vz + along * nz;
        double length = Math.sqrt(x * x + y * y + z * z);
        to[0] = x / length;
        to[1] = y / length;
        to[2] = z / length;
        return true;
    }

    /**
     * Returns the reflected fraction of the light, 0…1, by Fresnel's equations for unpolarized light: the mean of ((η·c −
     * √k)/(η·c + √k))² and ((c − η·√k)/(c + η·√k))². A pane has two such surfaces; with all inter-reflections it reflects 2F/(1
     * + F).
     */
    public static float fresnelReflectance(Transmission transmission, boolean inside, float nx, float ny, float nz, float vx, float vy,
            float vz) {
        double eta = inside && !transmission.thin() ? transmission.ior() : 1 / transmission.ior();
        if (eta == 1) {
            return 0;
        }
        double c = cosine(nx, ny, nz, vx, vy, vz);
        c = c < 1 ? c : 1;
        double k = 1 - eta * eta * (1 - c * c);
        if (!(k > 0)) {
            return 1;
        }
        double root = Math.sqrt(k);
        double s = (eta * c - root) / (eta * c + root);
        double p = (c - eta * root) / (c + eta * root);
        double f = (s * s + p * p) / 2;
        return (float) (transmission.thin() ? 2 * f / (1 + f) : f);
    }

    /**
     * Returns one channel of the share of light that passes a surface: the share that is not reflected times the color of transmission.
     *
     * @param kr    color of reflection, 0…1
     * @param share Fresnel reflectance, 0…1
     * @param kt    color of transmission, 0…1
     */
    public static float transmitted(float kr, float share, float kt) {
        return (1 - mirrorShare(kr, share)) * kt;
    }

    /** Returns one channel of the share of light that a surface mirrors; parameters as for {@link #transmitted}. */
    public static float mirrorShare(float kr, float share) {
        return kr + (1 - kr) * share;
    }
}

package lightning.render.lobe;

import lightning.scene.material.Material;

/**
 * Share of white light that a GGX surface reflects by single scattering, as a function of the view's angle and the roughness. A table of
 * means over directions of visible normals (E. Heitz, Sampling the GGX distribution of visible normals, 2018), in which the Fresnel term is
 * split as in B. Karis, Real shading in Unreal Engine 4, 2013: F0·a + b, with the masking of the lighting equation.
 */
public final class DirectionalAlbedo {
    /** Places along each axis of the table: the cosine to the view, and the roughness, both 0…1. */
    private static final int SIDE = 32;
    /** Directions along each side of the pattern of one entry. */
    private static final int SAMPLES = 16;
    private static final double MIN_COSINE = 0.01;
    private static final float[] A = new float[SIDE * SIDE];
    private static final float[] B = new float[SIDE * SIDE];

    static {
        double[] cos = new double[SAMPLES];
        double[] sin = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / SAMPLES;
            cos[i] = StrictMath.cos(angle);
            sin[i] = StrictMath.sin(angle);
        }
        var lobe = new ReflectionLobe();
        for (int r = 0; r < SIDE; r++) {
            for (int v = 0; v < SIDE; v++) {
                double a = 0;
                double b = 0;
                lobe.aim(Math.max((double) v / (SIDE - 1), MIN_COSINE), Material.alpha((double) r / (SIDE - 1)));
                for (int i = 0; i < SAMPLES; i++) {
                    for (int j = 0; j < SAMPLES; j++) {
                        lobe.reflect((i + 0.5) / SAMPLES, cos[j], sin[j]);
                        a += lobe.weight() * (1 - lobe.schlick());
                        b += lobe.weight() * lobe.schlick();
                    }
                }
                A[r * SIDE + v] = (float) (a / (SAMPLES * SAMPLES));
                B[r * SIDE + v] = (float) (b / (SAMPLES * SAMPLES));
            }
        }
    }

    private DirectionalAlbedo() {}

    /**
     * Returns a, the factor of F0.
     *
     * @param cosine    between the normal and the view, 0…1
     * @param roughness 0…1
     */
    public static float ofF0(float cosine, float roughness) {
        return AlbedoTable.at(A, SIDE, cosine, roughness);
    }

    /** Returns b, which does not depend on F0; parameters as above. */
    public static float grazing(float cosine, float roughness) {
        return AlbedoTable.at(B, SIDE, cosine, roughness);
    }
}

package lightning.render.lobe;

/** Table of the albedo of a {@link SheenLobe} over the cosine to the view and the roughness, and its mean over a hemisphere. */
final class SheenAlbedo {
    /** Places along each axis of the table, both 0…1. */
    private static final int SIDE = 64;
    private static final int STEPS = 256;
    private static final float[] TABLE = new float[SIDE * SIDE];
    private static final float[] MEAN = new float[SIDE];

    static {
        for (int r = 0; r < SIDE; r++) {
            double roughness = (double) r / (SIDE - 1);
            for (int v = 0; v < SIDE; v++) {
                TABLE[r * SIDE + v] = (float) SheenLobe.fittedAlbedo((double) v / (SIDE - 1), roughness);
            }
            double sum = 0;
            for (int i = 0; i < STEPS; i++) {
                double cosine = (i + 0.5) / STEPS;
                sum += 2 * cosine * SheenLobe.fittedAlbedo(cosine, roughness);
            }
            MEAN[r] = (float) (sum / STEPS);
        }
    }

    private SheenAlbedo() {}

    /** Returns the albedo; both parameters 0…1. */
    static float at(float cosine, float roughness) {
        return AlbedoTable.at(TABLE, SIDE, cosine, roughness);
    }

    /** Returns the mean albedo in uniform light. @param roughness 0…1 */
    static float mean(float roughness) {
        float y = Math.clamp(roughness, 0, 1) * (SIDE - 1);
        int j = Math.min((int) y, SIDE - 2);
        float v = y - j;
        return MEAN[j] * (1 - v) + MEAN[j + 1] * v;
    }
}

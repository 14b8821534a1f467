package lightning.shading;

import lightning.effects.ViewEffects;
import lightning.scene.World;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;

/**
 * The third stage for one tile and level: sums the lights' contributions and closes the equation
 * over all rows. Holds scratch columns: one for each thread.
 */
final class Composer {
    private static final int ROWS = Terms.ROWS;
    private static final float[] ZEROS = new float[ROWS];
    private static final float[][] NO_MIRRORS = new float[3][];

    private final MaterialTable materials;
    private final boolean litTextures;
    private final Sums sums;
    private final LightSum lightSum;
    private final float[] red = new float[ROWS];
    private final float[] green = new float[ROWS];
    private final float[] blue = new float[ROWS];

    Composer(MaterialTable materials, Sums sums, ViewEffects view) {
        this.sums = sums;
        lightSum = new LightSum(sums);
        this.materials = materials;
        litTextures = view.litTextures();
    }

    LightSum lightSum() {
        return lightSum;
    }

    /** The colours of the rows composed last, linear, {@code float[1024]}. */
    float[] red() {
        return red;
    }

    float[] green() {
        return green;
    }

    float[] blue() {
        return blue;
    }

    /**
     * Computes the colours of all rows.
     *
     * @param lights   the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param branches sums that are known already, or null
     * @param mirrored Cr of the reflective rows: red, green and blue columns; null where there are none
     */
    void compose(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches, World world, float[][] mirrored) {
        SumRows sum = branches == null ? lightSum.of(rows.count, lights, layers) : lightSum.of(rows.count, lights, layers, branches);
        float[][] cr = mirrored == null ? NO_MIRRORS : mirrored;
        for (int r = 0; r < rows.runs; r++) {
            closeRun(rows, r, sum, (float) world.ambience(), cr);
        }
    }

    private void closeRun(HitRows rows, int r, SumRows sum, float ambience, float[][] mirrored) {
        boolean textured = materials.isTextured(rows.runMaterial[r]);
        if (textured && !litTextures) {
            emit(rows, r, ambience);
            return;
        }
        boolean specular = sum != null && sum.hasSpecular;
        close(rows, r, 0, ambience, textured ? rows.texelRed : null, sum == null ? ZEROS : sum.diffuseRed,
                specular ? sum.specularRed : null, mirrored[0], red);
        close(rows, r, 1, ambience, textured ? rows.texelGreen : null, sum == null ? ZEROS : sum.diffuseGreen,
                specular ? sum.specularGreen : null, mirrored[1], green);
        close(rows, r, 2, ambience, textured ? rows.texelBlue : null, sum == null ? ZEROS : sum.diffuseBlue,
                specular ? sum.specularBlue : null, mirrored[2], blue);
    }

    /** A texture that shows its own colour, whatever the lights. */
    private void emit(HitRows rows, int r, float ambience) {
        int m = rows.runMaterial[r];
        for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
            red[i] = materials.ambient(m, 0) * ambience + materials.diffuse(m, 0) * rows.texelRed[i];
            green[i] = materials.ambient(m, 1) * ambience + materials.diffuse(m, 1) * rows.texelGreen[i];
            blue[i] = materials.ambient(m, 2) * ambience + materials.diffuse(m, 2) * rows.texelBlue[i];
        }
    }

    private void close(HitRows rows, int r, int channel, float ambience, float[] texture, float[] diffuse,
            float[] specular, float[] mirrored, float[] out) {
        int m = rows.runMaterial[r];
        sums.close(rows.runStart(r), rows.runEnd[r], new Sums.Channel(materials.ambient(m, channel) * ambience,
                materials.diffuse(m, channel), specular == null ? 0 : materials.specular(m, channel), materials.reflective(m, channel),
                texture, diffuse, specular, mirrored), out);
    }
}

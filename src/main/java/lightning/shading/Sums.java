package lightning.shading;

/**
 * Adds lights' contributions over the rows of a tile and closes the {@link LightingEquation}. Columns are as long as
 * {@link lightning.trace.HitRows#padded}, so that loops may run over the end.
 */
public interface Sums {
    /** Writes {@link LightingEquation#contribution} of a light in three channels. */
    void set(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue);

    /** Adds {@link LightingEquation#contribution} of a light in three channels. */
    void add(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue);

    /** Adds one column to another. */
    void add(int rows, float[] from, float[] to);

    /**
     * One channel of the rows {@code from … to − 1}, which are of one material: {@link LightingEquation#color} with absent terms
     * left out, which changes no bit, because they would add +0 or multiply by 1.
     */
    void close(int from, int to, Channel channel, float[] out);

    /**
     * One channel of what a material shows.
     *
     * @param emitted  k<sub>ambient</sub> times the ambience
     * @param kd       k<sub>diffuse</sub> before the texture
     * @param ks       k<sub>specular</sub>; 0 where {@code specular} is null
     * @param kr       k<sub>reflective</sub>
     * @param texture  the texels; null where the material has no texture
     * @param diffuse  the lights' sum
     * @param specular the lights' sum; null where nothing is specular
     * @param mirrored Cr; unread where {@code kr} is 0
     */
    record Channel(float emitted, float kd, float ks, float kr, float[] texture, float[] diffuse, float[] specular, float[] mirrored) {}
}

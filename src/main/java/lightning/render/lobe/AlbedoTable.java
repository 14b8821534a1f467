package lightning.render.lobe;

/** Table of an albedo over the cosine to the view and the roughness, both 0…1. */
final class AlbedoTable {
    private AlbedoTable() {}

    /**
     * Returns a value of a table, bilinear between its places.
     *
     * @param side places along each axis
     */
    static float at(float[] table, int side, float cosine, float roughness) {
        float x = Math.clamp(cosine, 0, 1) * (side - 1);
        float y = Math.clamp(roughness, 0, 1) * (side - 1);
        int i = Math.min((int) x, side - 2);
        int j = Math.min((int) y, side - 2);
        float u = x - i;
        float v = y - j;
        int at = j * side + i;
        return (table[at] * (1 - u) + table[at + 1] * u) * (1 - v) + (table[at + side] * (1 - u) + table[at + side + 1] * u) * v;
    }
}

package lightning.format.mesh;

/** Normalization of mesh tangents: length 1 and a handedness of 1 or −1. */
public final class Tangents {
    private Tangents() {}

    /**
     * Normalizes tangents and their handedness, and notes how many vertices were changed. Zero or NaN tangents become zero:
     * normal maps then use the texture coordinates.
     *
     * @param tangents {@code float[4 * vertices]}; modified
     */
    public static void normalizeAll(float[] tangents, ConversionNotes notes) {
        int withoutDirection = 0;
        int invalidHandedness = 0;
        for (int i = 0; i < tangents.length; i += 4) {
            withoutDirection += VertexNormals.normalize(tangents, i, tangents[i], tangents[i + 1], tangents[i + 2]) ? 0 : 1;
            invalidHandedness += Math.abs(tangents[i + 3]) == 1 ? 0 : 1;
            tangents[i + 3] = tangents[i + 3] < 0 ? -1 : 1;
        }
        notes.add("tangents without a direction", withoutDirection);
        notes.add("tangents with a handedness (w) other than 1 or -1", invalidHandedness);
    }
}

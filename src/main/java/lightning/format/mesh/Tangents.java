package lightning.format.mesh;

/** The tangents of meshes: of length 1 and with a hand of 1 or −1, whatever a file says. */
public final class Tangents {
    private Tangents() {}

    /**
     * Brings tangents to length 1 and their fourth numbers to 1 or −1, and tells how many vertices said otherwise. Those that are zero or
     * no numbers become zero: normal maps go by the texture coordinates there.
     *
     * @param tangents {@code float[4 * vertices]}; written
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
        notes.add("tangents whose fourth number is neither 1 nor -1", invalidHandedness);
    }
}

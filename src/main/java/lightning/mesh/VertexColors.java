package lightning.mesh;

/** The colours of vertices: factors from 0 to 1, whatever a file says. */
public final class VertexColors {
    private VertexColors() {}

    /**
     * Cuts colours to 0 … 1, infinities included, and tells how many vertices it cut; what is no number stays.
     *
     * @param colors {@code float[3 * vertices]}; written
     */
    public static void cut(float[] colors, Notes notes) {
        int changed = 0;
        for (int i = 0; i < colors.length; i += 3) {
            boolean beyond = false;
            for (int c = i; c < i + 3; c++) {
                beyond |= colors[c] < 0 || colors[c] > 1;
                colors[c] = colors[c] < 0 ? 0 : colors[c] > 1 ? 1 : colors[c];
            }
            changed += beyond ? 1 : 0;
        }
        notes.add("colours of vertices beyond 0 to 1", changed);
    }
}

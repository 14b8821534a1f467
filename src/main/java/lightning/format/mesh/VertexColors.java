package lightning.format.mesh;

import java.util.Arrays;

/** The colors of vertices: factors from 0 to 1, whatever a file says. */
public final class VertexColors {
    private VertexColors() {}

    /**
     * Cuts colors to 0 … 1, infinities included; a color with a channel that is no number becomes white. Reports how many vertices had such.
     *
     * @param colors   {@code float[≥ 3 * vertices]}; written
     * @param vertices how many are read, from the first
     */
    public static void clamp(float[] colors, int vertices, ConversionNotes notes) {
        int clamped = 0;
        int invalid = 0;
        for (int i = 0; i < 3 * vertices; i += 3) {
            boolean isOutOfRange = false;
            boolean hasNaN = false;
            for (int c = i; c < i + 3; c++) {
                hasNaN |= Float.isNaN(colors[c]);
                isOutOfRange |= colors[c] < 0 || colors[c] > 1;
                colors[c] = colors[c] < 0 ? 0 : colors[c] > 1 ? 1 : colors[c];
            }
            if (hasNaN) {
                invalid++;
                Arrays.fill(colors, i, i + 3, 1);
            } else if (isOutOfRange) {
                clamped++;
            }
        }
        notes.add("colors of vertices beyond 0 to 1", clamped);
        notes.add("colors of vertices that are no numbers, white here", invalid);
    }
}

package lightning.format.mesh;

import java.util.Arrays;

/** Normalization of vertex colors: factors from 0 to 1. */
public final class VertexColors {
    private VertexColors() {}

    /**
     * Clamps colors to 0 … 1, infinities included; a color with NaN becomes white. Notes the number of changed vertices.
     *
     * @param colors {@code float[≥ 3 * vertices]}; modified
     * @param vertices number of vertices to process, from the first
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
        notes.add("vertex colors outside 0 to 1", clamped);
        notes.add("vertex colors that are not numbers, replaced by white", invalid);
    }
}

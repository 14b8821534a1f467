package lightning.render.gather;

/**
 * Weights of the gather points near each row of a level: at most eight for each, fixed like the rows.
 *
 * @param structure that the points belong to
 * @param points    points that any row uses
 * @param index     index among these, {@code short[8 * rows]}
 * @param weight    unsigned weights, 0…255, {@code byte[8 * rows]}; nothing follows a weight of 0
 */
public record RowWeights(GatherStructure structure, int[] points, short[] index, byte[] weight) {
    // Arrays in a record: written once by their creator, never after.

    static final int PER_ROW = 8;

    /**
     * Writes the indirect light of rows: for each the weighted mean of the points' light.
     *
     * @param light red, green and blue light of all gather points
     * @param to    receives red, green and blue of each row
     */
    public void interpolate(float[][] light, float[][] to) {
        int rows = weight.length / PER_ROW;
        for (int row = 0; row < rows; row++) {
            double red = 0;
            double green = 0;
            double blue = 0;
            int total = 0;
            for (int i = PER_ROW * row; i < PER_ROW * row + PER_ROW && weight[i] != 0; i++) {
                int w = weight[i] & 0xFF;
                int p = points[index[i] & 0xFFFF];
                red += (double) w * light[0][p];
                green += (double) w * light[1][p];
                blue += (double) w * light[2][p];
                total += w;
            }
            double scale = total == 0 ? 0 : 1.0 / total;
            to[0][row] = (float) (red * scale);
            to[1][row] = (float) (green * scale);
            to[2][row] = (float) (blue * scale);
        }
    }

    /** Returns the point that alone has a weight at a row; −1 if there are several. */
    int onlyPoint(int row) {
        return weight[PER_ROW * row + 1] == 0 ? points[index[PER_ROW * row] & 0xFFFF] : -1;
    }

    /** Returns these weights with other numbers of the points; null if one has none. */
    RowWeights renumbered(GatherStructure to, int[] newNumber) {
        int[] renumbered = new int[points.length];
        for (int i = 0; i < points.length; i++) {
            renumbered[i] = newNumber[points[i]];
            if (renumbered[i] < 0) {
                return null;
            }
        }
        return new RowWeights(to, renumbered, index, weight);
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return 4L * points.length + 2L * index.length + weight.length;
    }
}

package lightning.scene.asset;

/**
 * The light of an environment map without its small bright parts, as means on an equirectangular grid. Immutable.
 *
 * @param rgb mean linear radiance of each cell: red, green, blue, row by row from the top; callers must not modify it
 */
public record SmoothGrid(float[] rgb) {
    // An array in a record: written once by its creator, never after.

    public static final int COLUMNS = 512;
    public static final int ROWS = 256;

    static SmoothGrid of(EnvironmentMap map) {
        int width = Math.max(COLUMNS, map.width());
        int lines = Math.max(ROWS, map.height());
        double[] sum = new double[3 * COLUMNS * ROWS];
        double[] weight = new double[COLUMNS * ROWS];
        double[] radiance = new double[3];
        for (int line = 0; line < lines; line++) {
            // The light of a line near a pole counts less.
            double share = StrictMath.sin(Math.PI * (line + 0.5) / lines);
            int row = (int) ((long) line * ROWS / lines) * COLUMNS;
            for (int i = 0; i < width; i++) {
                int cell = row + (int) ((long) i * COLUMNS / width);
                map.smoothRadiance((i + 0.5) / width, (line + 0.5) / lines, radiance);
                weight[cell] += share;
                for (int c = 0; c < 3; c++) {
                    sum[3 * cell + c] += share * radiance[c];
                }
            }
        }
        float[] rgb = new float[sum.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (sum[i] / weight[i / 3]);
        }
        return new SmoothGrid(rgb);
    }
}

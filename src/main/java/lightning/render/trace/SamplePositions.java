package lightning.render.trace;

import lightning.render.trace.tree.RayBeam;

/**
 * Where in the picture the eye's rays of a tile go: through the centers of its pixels, or through finer samples of some.
 *
 * @param x0     the tile's left pixel
 * @param y0     the tile's upper pixel
 * @param pixels indices in a tile of 32×32 pixels, ascending; those from {@code from} to before {@code to} have samples,
 *               first all of the first pixel, line by line. Null for the centers of all pixels: then a ray's number is its
 *               pixel's index
 * @param grid   samples along each side of a pixel
 */
public record SamplePositions(int x0, int y0, short[] pixels, int from, int to, int grid) {
    static final int SIDE = 32;

    /** The centers of the pixels of the tile whose upper left pixel is {@code x0, y0}. */
    public static SamplePositions centers(int x0, int y0) {
        return new SamplePositions(x0, y0, null, 0, SIDE * SIDE, 1);
    }

    /** How many rays there are. */
    public int count() {
        return (to - from) * grid * grid;
    }

    private int pixel(int ray) {
        return pixels == null ? ray : pixels[from + ray / (grid * grid)];
    }

    /** How far a ray's place is from the left, pixels. */
    public double x(int ray) {
        return x0 + pixel(ray) % SIDE + offset(ray % grid, grid);
    }

    /** How far a ray's place is from the top, pixels. */
    public double y(int ray) {
        return y0 + pixel(ray) / SIDE + offset(ray / grid % grid, grid);
    }

    /** Writes {@link #x} and {@link #y} of {@code count} rays from {@code first} on, counting on where each place by itself divides. */
    public void writePositions(int first, int count, double[] x, double[] y) {
        int samplesPerPixel = grid * grid;
        int pixelIndex = first / samplesPerPixel;
        int cell = first % samplesPerPixel;
        int column = cell % grid;
        int line = cell / grid;
        for (int i = 0; i < count; i++) {
            int pixel = pixels == null ? pixelIndex : pixels[from + pixelIndex];
            x[i] = x0 + pixel % SIDE + offset(column, grid);
            y[i] = y0 + pixel / SIDE + offset(line, grid);
            column = column + 1 == grid ? 0 : column + 1;
            line = column > 0 ? line : line + 1 == grid ? 0 : line + 1;
            pixelIndex += column == 0 && line == 0 ? 1 : 0;
        }
    }

    /** How far the middle of column or line {@code cell} of a pixel's samples is from the pixel's side, in pixels. */
    static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }

    /** Makes the beam of all rays through the smallest rectangle that holds the pixels; there must be any. */
    void boundBeam(RayBeam beam, CameraRays camera) {
        int left = SIDE;
        int right = 0;
        for (int i = from; i < to; i++) {
            int column = (pixels == null ? i : pixels[i]) % SIDE;
            left = Math.min(left, column);
            right = Math.max(right, column);
        }
        int top = (pixels == null ? from : pixels[from]) / SIDE;
        int bottom = (pixels == null ? to - 1 : pixels[to - 1]) / SIDE;
        camera.boundBeam(beam, x0 + left, y0 + top, right - left + 1, bottom - top + 1);
    }
}

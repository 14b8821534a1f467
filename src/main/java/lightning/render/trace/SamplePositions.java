package lightning.render.trace;

import lightning.render.trace.tree.RayBeam;

/**
 * Image positions of a tile's camera rays: the centers of its pixels, or finer samples of some of them.
 *
 * @param x0 left pixel of the tile
 * @param y0 top pixel of the tile
 * @param pixels indices in a tile of 32×32 pixels, ascending; those from {@code from} to before {@code to} have samples, first
 *     all samples of the first pixel, line by line. Null for the centers of all pixels; then a ray's number is its pixel's
 *     index
 * @param grid samples along each side of a pixel
 */
public record SamplePositions(int x0, int y0, short[] pixels, int from, int to, int grid) {
    static final int SIDE = 32;

    /** Returns the pixel centers of the tile whose upper left pixel is {@code x0, y0}. */
    public static SamplePositions centers(int x0, int y0) {
        return new SamplePositions(x0, y0, null, 0, SIDE * SIDE, 1);
    }

    /** Returns the number of rays. */
    public int count() {
        return (to - from) * grid * grid;
    }

    private int pixel(int ray) {
        return pixels == null ? ray : pixels[from + ray / (grid * grid)];
    }

    /** Returns a ray's distance from the left of the image, pixels. */
    public double x(int ray) {
        return x0 + pixel(ray) % SIDE + offset(ray % grid, grid);
    }

    /** Returns a ray's distance from the top of the image, pixels. */
    public double y(int ray) {
        return y0 + pixel(ray) / SIDE + offset(ray / grid % grid, grid);
    }

    /**
     * Writes {@link #x} and {@link #y} of {@code count} rays starting with {@code first}. Increments counters instead of
     * dividing for each ray.
     */
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

    /** Returns the distance of the center of column or line {@code cell} of a pixel's samples from the pixel's side, pixels. */
    static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }

    /** Sets a beam to bound all rays through the bounding rectangle of the pixels; there must be at least one. */
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

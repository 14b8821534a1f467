package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.RayBeam;
import org.jspecify.annotations.Nullable;

/**
 * Image positions of a tile's camera rays: the centers of its pixels, or finer samples of some of them.
 *
 * @param x0     left pixel of the tile
 * @param y0     top pixel of the tile
 * @param pixels indices in a tile of 32×32 pixels, ascending; all samples of the first pixel come first. Null for the centers of
 *     all pixels; then a ray's number is its pixel's index
 * @param cells  samples of each pixel
 */
public record SamplePositions(int x0, int y0, short @Nullable [] pixels, SampleCells cells) {
    static final int SIDE = 32;

    private static final SampleCells CENTER = SampleCells.all(1);

    /** Returns the pixel centers of the tile whose upper left pixel is {@code x0, y0}. */
    public static SamplePositions centers(int x0, int y0) {
        return new SamplePositions(x0, y0, null, CENTER);
    }

    /** Returns the number of rays. */
    public int count() {
        return pixels == null ? SIDE * SIDE : pixels.length * cells.count();
    }

    private int pixel(int ray) {
        return pixels == null ? ray : pixels[ray / cells.count()];
    }

    private int cell(int ray) {
        return cells.cells()[ray % cells.count()];
    }

    /** Returns a ray's distance from the left of the image, pixels. */
    public double x(int ray) {
        return x0 + pixel(ray) % SIDE + offset(cell(ray) % cells.grid(), cells.grid());
    }

    /** Returns a ray's distance from the top of the image, pixels. */
    public double y(int ray) {
        return y0 + pixel(ray) / SIDE + offset(cell(ray) / cells.grid(), cells.grid());
    }

    /** Writes {@link #x} and {@link #y} of {@code count} rays starting with {@code first}; divides once for each pixel. */
    public void writePositions(int first, int count, double[] x, double[] y) {
        int sample = first % cells.count();
        for (int i = 0, pixelIndex = first / cells.count(); i < count; pixelIndex++) {
            int pixel = pixels == null ? pixelIndex : pixels[pixelIndex];
            for (; sample < cells.count() && i < count; sample++, i++) {
                int cell = cells.cells()[sample];
                x[i] = x0 + pixel % SIDE + offset(cell % cells.grid(), cells.grid());
                y[i] = y0 + pixel / SIDE + offset(cell / cells.grid(), cells.grid());
            }
            sample = 0;
        }
    }

    /** Returns whether the rays start at other points than the eye: those of finer samples through an open lens. */
    boolean startOnLens(CameraRays camera) {
        return pixels != null && camera.hasOpenLens();
    }

    /** Writes the direction, of length 1, of a camera ray to index 0. */
    public void writeDirection(CameraRays camera, int ray, double[] dx, double[] dy, double[] dz) {
        if (!startOnLens(camera)) {
            camera.writeDirection(x(ray), y(ray), dx, dy, dz, 0);
        } else {
            Vec3 direction = camera.sampleRay(x(ray), y(ray), cell(ray), cells.grid()).direction();
            dx[0] = direction.x();
            dy[0] = direction.y();
            dz[0] = direction.z();
        }
    }

    /** Writes the rays of finer samples through an open lens; their numbers are their slots. */
    void writeLensRays(CameraRays camera, float[] fromX, float[] fromY, float[] fromZ, double[] toX, double[] toY, double[] toZ) {
        float[] from = new float[3];
        double[] to = new double[3];
        for (int ray = 0; ray < count(); ray++) {
            camera.writeLensRay(x(ray), y(ray), cell(ray), cells.grid(), from, to);
            fromX[ray] = from[0];
            fromY[ray] = from[1];
            fromZ[ray] = from[2];
            toX[ray] = to[0];
            toY[ray] = to[1];
            toZ[ray] = to[2];
        }
    }

    /** Writes the sample pattern of each ray of finer samples. */
    void writePatterns(byte[] patterns) {
        assert pixels != null;
        int[] parts = SampleCells.parts(cells.grid());
        for (int i = 0, ray = 0; i < pixels.length; i++) {
            for (int cell : cells.cells()) {
                patterns[ray++] = SamplePattern.of(x0 + pixels[i] % SIDE, y0 + pixels[i] / SIDE, parts[cell], cells.grid());
            }
        }
    }

    /** Returns the distance of the center of column or line {@code cell} of a pixel's samples from the pixel's side, pixels. */
    static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }

    /** Sets a beam to bound all rays from the eye through the bounding rectangle of the pixels; there must be at least one. */
    void boundBeam(RayBeam beam, CameraRays camera) {
        int left = SIDE;
        int right = 0;
        int count = pixels == null ? SIDE * SIDE : pixels.length;
        for (int i = 0; i < count; i++) {
            int column = (pixels == null ? i : pixels[i]) % SIDE;
            left = Math.min(left, column);
            right = Math.max(right, column);
        }
        int top = (pixels == null ? 0 : pixels[0]) / SIDE;
        int bottom = (pixels == null ? count - 1 : pixels[count - 1]) / SIDE;
        camera.boundBeam(beam, x0 + left, y0 + top, right - left + 1, bottom - top + 1);
    }
}

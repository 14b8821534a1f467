package lightning.trace;

/**
 * Which rays of the eye the rows of a tile's first level come from, by their {@code parent}.
 *
 * @param x0     the tile's leftmost pixel; likewise {@code y0} the uppermost
 * @param pixels null for the centres of the tile's pixels, whose rows have the pixel as their parent; else the pixels that
 *               have finer samples, indices in the tile
 * @param from   the first of those pixels whose samples these are: its first sample is parent 0
 * @param grid   samples along each side of such a pixel
 */
public record EyeSamples(int x0, int y0, short[] pixels, int from, int grid) {
    private static final int SIDE = 32;

    /** The centres of a tile's pixels. */
    public static EyeSamples centers(int x0, int y0) {
        return new EyeSamples(x0, y0, null, 0, 1);
    }

    /** The ray of a parent. */
    Ray ray(CameraRays camera, int parent) {
        if (pixels == null) {
            return camera.through(x0 + parent % SIDE, y0 + parent / SIDE);
        }
        int pixel = pixels[from + parent / (grid * grid)];
        int sample = parent % (grid * grid);
        return camera.at(x0 + pixel % SIDE + SampleGrid.offset(sample % grid, grid),
                y0 + pixel / SIDE + SampleGrid.offset(sample / grid, grid));
    }
}

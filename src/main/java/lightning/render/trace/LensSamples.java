package lightning.render.trace;

import lightning.scene.value.Lens;
import lightning.scene.value.SceneLimits;

/**
 * Points on a lens at which the finer samples of a pixel start: a function of pixel and sample alone.
 *
 * <p>The samples of a pixel take the points of a Sobol sequence in turn, the first samples the first ones, so that few samples cover the
 * lens evenly, too. Each pixel flips other bits of the coordinates, which keeps the points as even (digital shift; Kollig and Keller,
 * Efficient Multidimensional Sampling, 2002), and turns too few samples into noise instead of copies of the picture. One coordinate is the
 * angle, the other the share of the area within the radius.
 */
final class LensSamples {
    /** Index in the sequence of each cell of a grid, by the grid. */
    private static final int[][] INDICES = indices();

    /** Corners of the opening, the first one again at the end, if it has blades. */
    private final double[] cornerX;
    private final double[] cornerY;
    private final double radius;

    LensSamples(Lens lens) {
        radius = lens.aperture();
        cornerX = new double[lens.blades() + 1];
        cornerY = new double[cornerX.length];
        for (int i = 0; i < lens.blades(); i++) {
            double angle = Math.toRadians(90 + lens.bladeRotation() + 360.0 * i / lens.blades());
            cornerX[i] = StrictMath.cos(angle);
            cornerY[i] = StrictMath.sin(angle);
        }
        cornerX[lens.blades()] = cornerX[0];
        cornerY[lens.blades()] = cornerY[0];
    }

    private static int[][] indices() {
        int[][] indices = new int[SceneLimits.MAX_SAMPLES + 1][];
        for (int grid = 1; grid < indices.length; grid++) {
            indices[grid] = new int[grid * grid];
            int next = 0;
            for (int cell : SampleCells.first(grid).cells()) {
                indices[grid][cell] = next++;
            }
            for (int cell : SampleCells.rest(grid).cells()) {
                indices[grid][cell] = next++;
            }
        }
        return indices;
    }

    /**
     * Writes the point of a sample: to the right and up from the center of the lens, scene units.
     *
     * @param x    column of the pixel in the image
     * @param y    line of the pixel in the image
     * @param cell cell of the sample in the pixel's grid
     * @param to   {@code double[2]}
     */
    void write(int x, int y, int cell, int grid, double[] to) {
        int index = INDICES[grid][cell];
        int hash = mix(x * 0x9E3779B1 + mix(y));
        double u = unit(Integer.reverse(index) ^ hash);
        double distance = radius * Math.sqrt(unit(second(index) ^ mix(hash)));
        int blades = cornerX.length - 1;
        if (blades == 0) {
            double angle = 2 * Math.PI * u;
            to[0] = distance * StrictMath.cos(angle);
            to[1] = distance * StrictMath.sin(angle);
        } else {
            int blade = (int) (u * blades);
            double along = u * blades - blade;
            to[0] = distance * (cornerX[blade] + along * (cornerX[blade + 1] - cornerX[blade]));
            to[1] = distance * (cornerY[blade] + along * (cornerY[blade + 1] - cornerY[blade]));
        }
    }

    /** Returns bits as a number from 0, inclusive, to 1, exclusive. */
    private static double unit(int bits) {
        return (bits & 0xFFFFFFFFL) * 0x1p-32;
    }

    /** Returns the second coordinate of a point of the Sobol sequence; the first is the reversed index. */
    private static int second(int index) {
        int bits = 0;
        for (int i = index, direction = 1 << 31; i != 0; i >>>= 1, direction ^= direction >>> 1) {
            bits ^= (i & 1) * direction;
        }
        return bits;
    }

    /** Returns evenly distributed bits for a number. */
    private static int mix(int i) {
        int h = i + 0x7F4A7C15;
        h = (h ^ h >>> 16) * 0x7FEB352D;
        h = (h ^ h >>> 15) * 0x846CA68B;
        return h ^ h >>> 16;
    }
}

package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.render.fog.FogGrid;

/**
 * Light that fog scatters before each place along the rays of a part of the grid. Each ray has the samples of its 3×3 neighbors, by place: those of a
 * phase have weights 1, 2, 1 in both directions, so that the four phases weigh the same. Holds scratch memory.
 *
 * <p>A sample counts once it is before a surface, and fully one step later. So no light from behind a surface is added.
 */
final class FogSums {
    private static final int PLACES = FogGrid.SAMPLES * FogGrid.PHASES;
    private static final int STRIDE = PLACES + 1;

    private final FogGrid grid;
    /** Sum of the samples before each place, by ray; the first is 0. */
    private float[] sums = new float[0];
    private int left;
    private int top;
    private int columns;

    FogSums(FogGrid grid) {
        this.grid = grid;
    }

    /**
     * Sets the rays around some points of the image, in pixels.
     *
     * @return false if the light reaches none of their samples, so that all sums are 0
     */
    boolean set(FogLight light, double minX, double minY, double maxX, double maxY) {
        left = column(minX);
        top = line(minY);
        columns = column(maxX) + 2 - left;
        int lines = line(maxY) + 2 - top;
        if (!shines(light, lines)) {
            return false;
        }
        if (sums.length < columns * lines * STRIDE) {
            sums = new float[columns * lines * STRIDE];
        }
        Arrays.fill(sums, 0, columns * lines * STRIDE, 0);
        for (int i = 0; i < columns * lines; i++) {
            addNeighbors(light, left + i % columns, top + i / columns, i * STRIDE);
        }
        return true;
    }

    private boolean shines(FogLight light, int lines) {
        boolean any = false;
        for (int line = top - 1; line <= top + lines; line++) {
            for (int column = left - 1; column <= left + columns; column++) {
                any |= light.shines(line * grid.columns() + column);
            }
        }
        return any;
    }

    private void addNeighbors(FogLight light, int column, int line, int to) {
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int ray = (line + dy) * grid.columns() + column + dx;
                if (!light.shines(ray)) {
                    continue;
                }
                float[] parts = light.parts();
                float weight = weight(dx) * weight(dy);
                int at = to + 1 + grid.phase(ray);
                for (int k = 0; k < FogGrid.SAMPLES; k++) {
                    sums[at + FogGrid.PHASES * k] += weight * parts[ray * FogGrid.SAMPLES + k];
                }
            }
        }
        for (int i = 1; i < STRIDE; i++) {
            sums[to + i] += sums[to + i - 1];
        }
    }

    private static float weight(int offset) {
        return offset == 0 ? 0.5f : 0.25f;
    }

    private int column(double x) {
        return Math.clamp((int) grid.position(x), 1, grid.columns() - 3);
    }

    private int line(double y) {
        return Math.clamp((int) grid.position(y), 1, grid.lines() - 3);
    }

    /**
     * Interpolates the sums of the four rays around a point of the image, which was set.
     *
     * @param place place of a surface along its ray, 0…1
     */
    float before(double x, double y, double place) {
        int c = column(x);
        int r = line(y);
        float u = (float) Math.clamp(grid.position(x) - c, 0, 1);
        float v = (float) Math.clamp(grid.position(y) - r, 0, 1);
        // Half a step after its place, a sample counts by a half.
        double counted = place >= 1 ? PLACES : Math.max(0, place * PLACES - 0.5);
        int k = Math.min((int) counted, PLACES - 1);
        float share = (float) (counted - k);
        int at = ((r - top) * columns + c - left) * STRIDE + k;
        int below = at + columns * STRIDE;
        float upper = before(at, share) * (1 - u) + before(at + STRIDE, share) * u;
        float lower = before(below, share) * (1 - u) + before(below + STRIDE, share) * u;
        return upper * (1 - v) + lower * v;
    }

    private float before(int at, float share) {
        return sums[at] * (1 - share) + sums[at + 1] * share;
    }
}

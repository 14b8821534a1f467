package lightning.render.gather;

/**
 * Weighted means over neighboring gather points, which remove the noise of their rays. The weights are fixed, so the mean is linear in
 * the light.
 *
 * @param start  first entry of each point, {@code int[points + 1]}
 * @param point  neighbors of all points, each point itself included
 * @param weight their weights; those of one point add up to 1
 */
record PointFilter(int[] start, int[] point, float[] weight) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Writes the means of a column.
     *
     * @param from value of each point
     */
    void apply(float[] from, float[] to, int first, int end) {
        for (int p = first; p < end; p++) {
            float sum = 0;
            for (int i = start[p]; i < start[p + 1]; i++) {
                sum += weight[i] * from[point[i]];
            }
            to[p] = sum;
        }
    }

    long bytes() {
        return 4L * start.length + 8L * point.length;
    }
}

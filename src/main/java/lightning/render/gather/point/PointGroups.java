package lightning.render.gather.point;

import lightning.render.gather.cell.SurfaceColumns;

/**
 * Boxes of groups of neighboring gather points, and of groups of these groups, by which the points near a place are found.
 *
 * <p>Rounding is monotonic: if a place is beyond the rounded sum of a point's coordinate and its radius, then the rounded difference is
 * at least the radius, and the point's weight is 0. So boxes need no margin.
 */
public final class PointGroups {
    private static final int SIZE = 32;

    private final SurfaceColumns points;
    /** Distance from each point within which it is of interest. */
    private final float[] radius;
    /** Points of the groups, one group after the other. */
    private final int[] order;
    /** Boxes of the groups, enlarged by the radii: least x, y, z, greatest x, y, z. */
    private final float[] boxes;
    /** Boxes of {@link #SIZE} groups each. */
    private final float[] outerBoxes;
    /** Boxes of the groups' points. */
    private final float[] pointBoxes;
    private final float[] outerPointBoxes;
    private final int count;

    public PointGroups(SurfaceColumns points, float[] radius) {
        this(points, radius, new PointOrder(points).clusters(SIZE));
    }

    private PointGroups(SurfaceColumns points, float[] radius, int[] order) {
        this.order = order;
        this.points = points;
        this.radius = radius;
        count = Math.ceilDiv(points.count, SIZE);
        boxes = emptyBoxes(count);
        pointBoxes = emptyBoxes(count);
        outerBoxes = emptyBoxes(Math.ceilDiv(count, SIZE));
        outerPointBoxes = emptyBoxes(Math.ceilDiv(count, SIZE));
        for (int i = 0; i < points.count; i++) {
            int p = order[i];
            enlarge(boxes, i / SIZE, p, radius[p]);
            enlarge(outerBoxes, i / SIZE / SIZE, p, radius[p]);
            enlarge(pointBoxes, i / SIZE, p, 0);
            enlarge(outerPointBoxes, i / SIZE / SIZE, p, 0);
        }
    }

    /** Returns the same groups for other distances. */
    PointGroups withRadius(float[] other) {
        return new PointGroups(points, other, order);
    }

    private static float[] emptyBoxes(int count) {
        float[] boxes = new float[6 * count];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = i % 6 < 3 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
        }
        return boxes;
    }

    private void enlarge(float[] to, int box, int p, float distance) {
        enlarge(to, 6 * box, points.px[p], distance);
        enlarge(to, 6 * box + 1, points.py[p], distance);
        enlarge(to, 6 * box + 2, points.pz[p], distance);
    }

    private static void enlarge(float[] to, int at, float place, float distance) {
        to[at] = Math.min(to[at], place - distance);
        to[at + 3] = Math.max(to[at + 3], place + distance);
    }

    /** Returns the bytes of the order and the boxes. */
    public long bytes() {
        return 4L * (order.length + 2 * boxes.length + 2 * outerBoxes.length);
    }

    /** Returns all points, neighbors next to each other. Callers must not modify it. */
    int[] order() {
        return order;
    }

    /**
     * Finds the points whose radius may reach into a box.
     *
     * @param box least x, y, z, greatest x, y, z
     * @param to  receives them in any order; long enough for all points
     * @return their number
     */
    int find(float[] box, int[] to) {
        int found = 0;
        for (int outer = 0; SIZE * outer < count; outer++) {
            if (touches(outerBoxes, outer, box)) {
                for (int g = SIZE * outer; g < Math.min(count, SIZE * outer + SIZE); g++) {
                    if (touches(boxes, g, box)) {
                        found = addPoints(g, box, to, found);
                    }
                }
            }
        }
        return found;
    }

    private int addPoints(int group, float[] box, int[] to, int count) {
        int found = count;
        for (int i = group * SIZE; i < Math.min(points.count, group * SIZE + SIZE); i++) {
            if (reaches(order[i], box)) {
                to[found++] = order[i];
            }
        }
        return found;
    }

    /** Returns whether the radius of any point may reach into a box. */
    public boolean reaches(float[] box) {
        for (int outer = 0; SIZE * outer < count; outer++) {
            for (int g = SIZE * outer; touches(outerBoxes, outer, box) && g < Math.min(count, SIZE * outer + SIZE); g++) {
                for (int i = g * SIZE; touches(boxes, g, box) && i < Math.min(points.count, g * SIZE + SIZE); i++) {
                    if (reaches(order[i], box)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean reaches(int p, float[] box) {
        float r = radius[p];
        return points.px[p] - r <= box[3] && points.px[p] + r >= box[0] && points.py[p] - r <= box[4] && points.py[p] + r >= box[1]
                && points.pz[p] - r <= box[5] && points.pz[p] + r >= box[2];
    }

    /** Returns whether the {@link PointWeight#distance} of any point is not greater than a distance. */
    public boolean isAnyNearer(float distance, float x, float y, float z, float nx, float ny, float nz) {
        for (int g = 0; g < count; g++) {
            if (g % SIZE == 0 && boxDistance(outerBoxes, g / SIZE, x, y, z) > distance) {
                g += SIZE - 1;
            } else if (!(boxDistance(pointBoxes, g, x, y, z) > distance)) {
                for (int i = g * SIZE; i < Math.min(points.count, g * SIZE + SIZE); i++) {
                    if (!(PointWeight.distance(points, order[i], x, y, z, nx, ny, nz) > distance)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private static boolean touches(float[] boxes, int at, float[] box) {
        return boxes[6 * at] <= box[3] && boxes[6 * at + 3] >= box[0] && boxes[6 * at + 1] <= box[4] && boxes[6 * at + 4] >= box[1]
                && boxes[6 * at + 2] <= box[5] && boxes[6 * at + 5] >= box[2];
    }

    /**
     * Returns the point with the least {@link PointWeight#distance}, the first of equals.
     *
     * @param barriers of the points
     * @param guess any point; the fewer points are nearer, the faster
     */
    public int nearest(Barriers barriers, float x, float y, float z, float nx, float ny, float nz, int guess) {
        int nearest = guess;
        float least = PointWeight.distance(points, guess, barriers, x, y, z, nx, ny, nz);
        for (int g = 0; g < count; g++) {
            // No point of a box is nearer than the box.
            if (g % SIZE == 0 && boxDistance(outerPointBoxes, g / SIZE, x, y, z) > least) {
                g += SIZE - 1;
            } else if (!(boxDistance(pointBoxes, g, x, y, z) > least)) {
                for (int i = g * SIZE; i < Math.min(points.count, g * SIZE + SIZE); i++) {
                    int p = order[i];
                    float distance = PointWeight.distance(points, p, barriers, x, y, z, nx, ny, nz);
                    if (distance < least || distance == least && p < nearest) {
                        least = distance;
                        nearest = p;
                    }
                }
            }
        }
        return nearest;
    }

    private static float boxDistance(float[] boxes, int at, float x, float y, float z) {
        float dx = Math.max(0, Math.max(boxes[6 * at] - x, x - boxes[6 * at + 3]));
        float dy = Math.max(0, Math.max(boxes[6 * at + 1] - y, y - boxes[6 * at + 4]));
        float dz = Math.max(0, Math.max(boxes[6 * at + 2] - z, z - boxes[6 * at + 5]));
        return dx * dx + dy * dy + dz * dz;
    }
}

package lightning.render.gather;

import java.util.Arrays;

/** Boxes of groups of consecutive gather points, by which those near a place are found. */
final class PointGroups {
    private static final int SIZE = 32;

    private final SurfaceColumns points;
    /** Distance from each point within which it is of interest. */
    private final float[] radius;
    /** Boxes of the groups, enlarged by the radii: least x, y, z, greatest x, y, z. */
    private final float[] boxes;
    /** Boxes of the groups' points. */
    private final float[] pointBoxes;
    private final int count;

    PointGroups(SurfaceColumns points, float[] radius) {
        this.points = points;
        this.radius = radius;
        count = Math.ceilDiv(points.count, SIZE);
        boxes = new float[6 * count];
        pointBoxes = new float[6 * count];
        for (int g = 0; g < count; g++) {
            write(boxes, g, 1);
            write(pointBoxes, g, 0);
        }
    }

    private void write(float[] to, int group, int grow) {
        Arrays.fill(to, 6 * group, 6 * group + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(to, 6 * group + 3, 6 * group + 6, Float.NEGATIVE_INFINITY);
        for (int p = group * SIZE; p < Math.min(points.count, group * SIZE + SIZE); p++) {
            for (int axis = 0; axis < 3; axis++) {
                float place = (axis == 0 ? points.px : axis == 1 ? points.py : points.pz)[p];
                to[6 * group + axis] = Math.min(to[6 * group + axis], Math.nextDown(place - grow * radius[p]));
                to[6 * group + 3 + axis] = Math.max(to[6 * group + 3 + axis], Math.nextUp(place + grow * radius[p]));
            }
        }
    }

    /**
     * Finds the points whose radius may reach into a box.
     *
     * @param box least x, y, z, greatest x, y, z
     * @param to  receives them, ascending; long enough for all points
     * @return their number
     */
    int find(float[] box, int[] to) {
        int found = 0;
        for (int g = 0; g < count; g++) {
            if (boxes[6 * g] <= box[3] && boxes[6 * g + 3] >= box[0] && boxes[6 * g + 1] <= box[4] && boxes[6 * g + 4] >= box[1]
                    && boxes[6 * g + 2] <= box[5] && boxes[6 * g + 5] >= box[2]) {
                for (int p = g * SIZE; p < Math.min(points.count, g * SIZE + SIZE); p++) {
                    if (touches(points.px[p], radius[p], box[0], box[3]) && touches(points.py[p], radius[p], box[1], box[4])
                            && touches(points.pz[p], radius[p], box[2], box[5])) {
                        to[found++] = p;
                    }
                }
            }
        }
        return found;
    }

    private static boolean touches(float place, float radius, float least, float greatest) {
        return Math.nextDown(place - radius) <= greatest && Math.nextUp(place + radius) >= least;
    }

    /** Returns the point with the least {@link PointWeight#distance}, the first of equals; −1 if there is none. */
    int nearest(float x, float y, float z, float nx, float ny, float nz) {
        int nearest = -1;
        float least = Float.POSITIVE_INFINITY;
        for (int g = 0; g < count; g++) {
            // Rounding is monotonic, so no point of the box is nearer than the box.
            if (nearest < 0 || boxDistance(g, x, y, z) < least) {
                for (int p = g * SIZE; p < Math.min(points.count, g * SIZE + SIZE); p++) {
                    float distance = PointWeight.distance(points, p, x, y, z, nx, ny, nz);
                    if (nearest < 0 || distance < least) {
                        least = distance;
                        nearest = p;
                    }
                }
            }
        }
        return nearest;
    }

    private float boxDistance(int g, float x, float y, float z) {
        float dx = Math.max(0, Math.max(pointBoxes[6 * g] - x, x - pointBoxes[6 * g + 3]));
        float dy = Math.max(0, Math.max(pointBoxes[6 * g + 1] - y, y - pointBoxes[6 * g + 4]));
        float dz = Math.max(0, Math.max(pointBoxes[6 * g + 2] - z, z - pointBoxes[6 * g + 5]));
        return dx * dx + dy * dy + dz * dz;
    }
}

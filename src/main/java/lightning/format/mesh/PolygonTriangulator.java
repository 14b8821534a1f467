package lightning.format.mesh;

/**
 * Triangulator for polygons that need not be planar or convex. It projects a polygon along the axis nearest to its normal
 * (Newell's method: Sutherland, Sproull and Schumacker, A characterization of ten hidden-surface algorithms, 1974) and clips
 * ears, corners whose triangle contains no other corner (Meisters, Polygons have ears, 1975). If no ear exists, as in
 * self-intersecting polygons, the rest becomes a fan.
 */
public final class PolygonTriangulator {
    /** Maximum number of corners for ear clipping, whose time is quadratic; larger polygons become fans. */
    public static final int MAX_CORNERS = 500;

    private final double[] u = new double[MAX_CORNERS];
    private final double[] v = new double[MAX_CORNERS];
    private final int[] remaining = new int[MAX_CORNERS];

    /** Returns whether a polygon has enough corners; notes one that has too few, or so many that it becomes a fan. */
    public static boolean isFace(int count, ConversionNotes notes) {
        if (count < 3) {
            notes.add("faces with fewer than three corners");
        } else if (count > MAX_CORNERS) {
            notes.add("faces with more than " + MAX_CORNERS + " corners, triangulated as convex");
        }
        return count >= 3;
    }

    /**
     * Adds the {@code count} − 2 triangles of a polygon, with its orientation.
     *
     * @param corners vertices in order; the first {@code count} are read
     * @param count at least 3
     * @param positions x, y, z of each vertex
     * @param triangles receives three indices into {@code corners} for each triangle
     */
    public void triangulate(int[] corners, int count, float[] positions, IntList triangles) {
        if (count == 3 || count > MAX_CORNERS || !project(corners, count, positions)) {
            fan(count, triangles);
            return;
        }
        for (int i = 0; i < count; i++) {
            remaining[i] = i;
        }
        int remainingCount = count;
        int start = 0;
        for (int failures = 0; remainingCount > 3 && failures < remainingCount;) {
            int i = start % remainingCount;
            int previous = remaining[(i + remainingCount - 1) % remainingCount];
            int next = remaining[(i + 1) % remainingCount];
            if (isEar(previous, remaining[i], next, remainingCount)) {
                add(previous, remaining[i], next, triangles);
                System.arraycopy(remaining, i + 1, remaining, i, remainingCount - i - 1);
                remainingCount--;
                failures = 0;
            } else {
                failures++;
                start = i + 1;
            }
        }
        for (int i = 2; i < remainingCount; i++) {
            add(remaining[0], remaining[i - 1], remaining[i], triangles);
        }
    }

    private static void fan(int count, IntList triangles) {
        for (int i = 2; i < count; i++) {
            add(0, i - 1, i, triangles);
        }
    }

    private static void add(int a, int b, int c, IntList triangles) {
        triangles.add(a);
        triangles.add(b);
        triangles.add(c);
    }

    /** Projects the corners along an axis so that they are counter-clockwise; returns false if the area is zero. */
    private boolean project(int[] corners, int count, float[] positions) {
        double[] normal = new double[3];
        for (int i = 0; i < count; i++) {
            int p = 3 * corners[i];
            int q = 3 * corners[(i + 1) % count];
            for (int axis = 0; axis < 3; axis++) {
                int y = (axis + 1) % 3;
                int z = (axis + 2) % 3;
                normal[axis] += ((double) positions[p + y] - positions[q + y]) * ((double) positions[p + z] + positions[q + z]);
            }
        }
        int axis = 0;
        for (int i = 1; i < 3; i++) {
            axis = Math.abs(normal[i]) > Math.abs(normal[axis]) ? i : axis;
        }
        double sign = Math.signum(normal[axis]);
        for (int i = 0; i < count; i++) {
            u[i] = sign * positions[3 * corners[i] + (axis + 1) % 3];
            v[i] = positions[3 * corners[i] + (axis + 2) % 3];
        }
        return sign != 0;
    }

    private boolean isEar(int a, int b, int c, int count) {
        if (orientation(a, b, c) <= 0) {
            return false;
        }
        for (int i = 0; i < count; i++) {
            int p = remaining[i];
            if (p != a && p != b && p != c && orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0
                    && !isSamePoint(p, a) && !isSamePoint(p, b)
                    && !isSamePoint(p, c)) {
                return false;
            }
        }
        return true;
    }

    /** Returns true for corners at the same position, as where a hole is joined to the outline. */
    private boolean isSamePoint(int p, int q) {
        return u[p] == u[q] && v[p] == v[q];
    }

    /** Returns a positive value if c is left of the line from a to b. */
    private double orientation(int a, int b, int c) {
        return (u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]);
    }
}

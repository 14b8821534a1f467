package lightning.render.gather;

/**
 * Gather points near some places: first those near all of them, then those near a few, side by side in memory. Holds scratch memory: use
 * one instance per thread.
 */
final class NearPoints {
    private final SurfaceColumns points;
    private final float[] radius;
    private final PointGroups groups;
    /** Points near all places, ascending, and their columns. */
    private final int[] found;
    final SurfaceColumns columns = new SurfaceColumns();
    float[] columnRadius = new float[1024];
    /** Indices of the selected points among these columns, ascending. */
    int[] selected = new int[1024];
    private final float[] box = new float[6];

    /** @param radius distance from each point within which it is of interest; also that of the groups */
    NearPoints(SurfaceColumns points, float[] radius, PointGroups groups) {
        this.points = points;
        this.radius = radius;
        this.groups = groups;
        found = new int[points.count];
    }

    /** Returns the gather point of a column. */
    int point(int column) {
        return found[column];
    }

    /** Collects the points near places {@code from … to − 1}, at least one. */
    void collect(float[] x, float[] y, float[] z, int from, int to) {
        bound(x, y, z, from, to);
        int count = groups.find(box, found);
        columns.reserve(count);
        if (columnRadius.length < count) {
            columnRadius = new float[columns.px.length];
            selected = new int[columns.px.length];
        }
        columns.count = count;
        for (int i = 0; i < count; i++) {
            int p = found[i];
            columns.set(i, points.px[p], points.py[p], points.pz[p], points.nx[p], points.ny[p], points.nz[p], points.primitive[p]);
            columnRadius[i] = radius[p];
        }
    }

    /** Selects among the collected points those near places {@code from … to − 1}; returns their number. */
    int select(float[] x, float[] y, float[] z, int from, int to) {
        bound(x, y, z, from, to);
        int count = 0;
        for (int i = 0; i < columns.count; i++) {
            float r = columnRadius[i];
            selected[count] = i;
            boolean isNear = columns.px[i] - r <= box[3] & columns.px[i] + r >= box[0] & columns.py[i] - r <= box[4]
                    & columns.py[i] + r >= box[1] & columns.pz[i] - r <= box[5] & columns.pz[i] + r >= box[2];
            count += isNear ? 1 : 0;
        }
        return count;
    }

    private void bound(float[] x, float[] y, float[] z, int from, int to) {
        bound(x, from, to, 0);
        bound(y, from, to, 1);
        bound(z, from, to, 2);
    }

    private void bound(float[] places, int from, int to, int axis) {
        float least = places[from];
        float greatest = least;
        for (int i = from + 1; i < to; i++) {
            least = Math.min(least, places[i]);
            greatest = Math.max(greatest, places[i]);
        }
        box[axis] = least;
        box[3 + axis] = greatest;
    }
}

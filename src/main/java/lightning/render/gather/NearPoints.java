package lightning.render.gather;

/**
 * Gather points near some places: first those near all of them, then those near a few, then those near one, side by side in memory. Holds
 * scratch memory: use one instance per thread.
 */
final class NearPoints {
    private final SurfaceColumns points;
    private final float[] radius;
    private final PointGroups groups;
    /** Points near all places, ascending, and their columns. */
    private final int[] found;
    final SurfaceColumns columns = new SurfaceColumns();
    float[] columnRadius = new float[1024];
    /** Columns of the points near a few places, ascending, their places and the squares of their radii. */
    private int[] selected = new int[1024];
    private float[] x = new float[1024];
    private float[] y = new float[1024];
    private float[] z = new float[1024];
    private float[] square = new float[1024];
    private int selectedCount;
    /** Square of the distance to each selected point, minus the square within which it is near. */
    private float[] excess = new float[1024];
    /** Columns of the points near one place, ascending. */
    int[] near = new int[1024];
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
    void collect(float[] placesX, float[] placesY, float[] placesZ, int from, int to) {
        bound(placesX, placesY, placesZ, from, to);
        int count = groups.find(box, found);
        columns.reserve(count);
        if (columnRadius.length < count) {
            reserve(columns.px.length);
        }
        columns.count = count;
        for (int i = 0; i < count; i++) {
            int p = found[i];
            columns.set(i, points.px[p], points.py[p], points.pz[p], points.nx[p], points.ny[p], points.nz[p], points.primitive[p]);
            columnRadius[i] = radius[p];
        }
    }

    private void reserve(int length) {
        columnRadius = new float[length];
        selected = new int[length];
        x = new float[length];
        y = new float[length];
        z = new float[length];
        square = new float[length];
        excess = new float[length];
        near = new int[length];
    }

    /** Selects among the collected points those near places {@code from … to − 1}; returns their number. */
    int select(float[] placesX, float[] placesY, float[] placesZ, int from, int to) {
        bound(placesX, placesY, placesZ, from, to);
        int count = 0;
        for (int i = 0; i < columns.count; i++) {
            float r = columnRadius[i];
            selected[count] = i;
            boolean isNear = columns.px[i] - r <= box[3] & columns.px[i] + r >= box[0] & columns.py[i] - r <= box[4]
                    & columns.py[i] + r >= box[1] & columns.pz[i] - r <= box[5] & columns.pz[i] + r >= box[2];
            count += isNear ? 1 : 0;
        }
        for (int i = 0; i < count; i++) {
            int column = selected[i];
            x[i] = columns.px[column];
            y[i] = columns.py[column];
            z[i] = columns.pz[column];
            square[i] = columnRadius[column] * columnRadius[column];
        }
        selectedCount = count;
        return count;
    }

    /**
     * Writes the selected points that are nearer to a place than their radius and a limit to {@link #near}; returns their number. The
     * first loop has no branch, so that it runs on lanes.
     */
    int findNear(float placeX, float placeY, float placeZ, float limit) {
        float limitSquare = limit * limit;
        for (int i = 0; i < selectedCount; i++) {
            float dx = placeX - x[i];
            float dy = placeY - y[i];
            float dz = placeZ - z[i];
            excess[i] = dx * dx + dy * dy + dz * dz - Math.min(square[i], limitSquare);
        }
        int count = 0;
        for (int i = 0; i < selectedCount; i++) {
            near[count] = selected[i];
            count += excess[i] < 0 ? 1 : 0;
        }
        return count;
    }

    private void bound(float[] placesX, float[] placesY, float[] placesZ, int from, int to) {
        bound(placesX, from, to, 0);
        bound(placesY, from, to, 1);
        bound(placesZ, from, to, 2);
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

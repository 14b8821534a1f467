package lightning.render.gather.point;

import java.util.Arrays;
import lightning.render.gather.cell.SurfaceColumns;

/**
 * Finds the gather points near each of some places: first those near all places, then those near each half of them, and so on, side by side
 * in memory. Holds scratch memory: use one instance per thread.
 */
public final class NearPoints {
    /** Places and points from which on places are not divided further. */
    private static final int FEW_PLACES = 2;
    private static final int FEW_POINTS = 24;

    private final SurfaceColumns points;
    private final float[] radius;
    private final PointGroups groups;
    /** Points near all places, ascending, and their columns. */
    private final int[] found;
    public final SurfaceColumns columns = new SurfaceColumns();
    public float[] columnRadius = new float[1024];
    /** Lists of columns, each near a part of the places of the one before it, with their places and the squares of their radii. */
    private int[] column = new int[4096];
    private float[] x = new float[4096];
    private float[] y = new float[4096];
    private float[] z = new float[4096];
    private float[] square = new float[4096];
    /** Square of the distance to each point of a list, minus the square within which it is near; and those of them that are near. */
    private float[] excess = new float[4096];
    private int[] kept = new int[4096];
    /** Columns of the points near one place, ascending. */
    public int[] near = new int[4096];
    private float[] placesX = {};
    private float[] placesY = {};
    private float[] placesZ = {};
    private int[] places = {};

    /** Receives a place after the points near it were found. */
    public interface Visitor {
        /** @param count number of points in {@link #near} */
        void visit(int place, int count);
    }

    /** @param radius distance from each point within which it is of interest; also that of the groups */
    public NearPoints(SurfaceColumns points, float[] radius, PointGroups groups) {
        this.points = points;
        this.radius = radius;
        this.groups = groups;
        found = new int[points.count];
    }

    /** Returns the gather point of a column. */
    public int point(int itsColumn) {
        return found[itsColumn];
    }

    /**
     * Finds the points that are nearer to places than their radius.
     *
     * @param itsX      coordinates of places, as {@code itsY} and {@code itsZ}
     * @param itsPlaces indices of some of them, which are visited in any order; they are sorted
     * @param from      first index, with {@code to} after the last one
     */
    public void find(float[] itsX, float[] itsY, float[] itsZ, int[] itsPlaces, int from, int to, Visitor visitor) {
        placesX = itsX;
        placesY = itsY;
        placesZ = itsZ;
        places = itsPlaces;
        float[] box = bound(from, to);
        int count = groups.find(box, found);
        Arrays.sort(found, 0, count);
        columns.reserve(count);
        columns.count = count;
        if (columnRadius.length < count) {
            columnRadius = new float[columns.px.length];
        }
        reserve(count);
        for (int i = 0; i < count; i++) {
            int p = found[i];
            columns.set(i, points.px[p], points.py[p], points.pz[p], points.nx[p], points.ny[p], points.nz[p], points.primitive[p]);
            columnRadius[i] = radius[p];
            column[i] = i;
            square[i] = radius[p] * radius[p];
        }
        System.arraycopy(columns.px, 0, x, 0, count);
        System.arraycopy(columns.py, 0, y, 0, count);
        System.arraycopy(columns.pz, 0, z, 0, count);
        visit(from, to, box, 0, count, visitor);
    }

    private void reserve(int length) {
        if (length > column.length) {
            int longer = Math.max(length, 2 * column.length);
            column = Arrays.copyOf(column, longer);
            x = Arrays.copyOf(x, longer);
            y = Arrays.copyOf(y, longer);
            z = Arrays.copyOf(z, longer);
            square = Arrays.copyOf(square, longer);
            excess = new float[longer];
            kept = new int[longer];
            near = new int[longer];
        }
    }

    /** Visits places with the points of a list. */
    private void visit(int from, int to, float[] box, int list, int listEnd, Visitor visitor) {
        int middle = to - from <= FEW_PLACES || listEnd - list <= FEW_POINTS ? from : split(from, to, box);
        if (middle == from) {
            for (int i = from; i < to; i++) {
                visitor.visit(places[i], findNear(places[i], list, listEnd));
            }
            return;
        }
        visitPart(from, middle, list, listEnd, visitor);
        visitPart(middle, to, list, listEnd, visitor);
    }

    private void visitPart(int from, int to, int list, int listEnd, Visitor visitor) {
        float[] box = bound(from, to);
        visit(from, to, box, listEnd, select(box, list, listEnd), visitor);
    }

    /** Sorts places into two halves of their box; returns the first one of the second, {@code from} if they cannot be divided. */
    private int split(int from, int to, float[] box) {
        // Halves first: the difference of two floats may be infinite.
        float sizeX = box[3] / 2 - box[0] / 2;
        float sizeY = box[4] / 2 - box[1] / 2;
        float sizeZ = box[5] / 2 - box[2] / 2;
        int axis = sizeX >= sizeY && sizeX >= sizeZ ? 0 : sizeY >= sizeZ ? 1 : 2;
        float[] along = axis == 0 ? placesX : axis == 1 ? placesY : placesZ;
        float middle = box[axis] / 2 + box[3 + axis] / 2;
        int end = from;
        for (int i = from; i < to; i++) {
            int place = places[i];
            if (along[place] < middle) {
                places[i] = places[end];
                places[end++] = place;
            }
        }
        return end == to ? from : end;
    }

    /** Appends a list of the points of a list that are near any place in a box; returns its end. Rounding is monotonic, so none is missed. */
    private int select(float[] box, int list, int listEnd) {
        reserve(2 * listEnd - list);
        float x0 = box[0];
        float y0 = box[1];
        float z0 = box[2];
        float x1 = box[3];
        float y1 = box[4];
        float z1 = box[5];
        for (int i = list; i < listEnd; i++) {
            float dx = Math.max(0, Math.max(x0 - x[i], x[i] - x1));
            float dy = Math.max(0, Math.max(y0 - y[i], y[i] - y1));
            float dz = Math.max(0, Math.max(z0 - z[i], z[i] - z1));
            excess[i] = dx * dx + dy * dy + dz * dz - square[i];
        }
        int count = keep(list, listEnd);
        for (int i = 0; i < count; i++) {
            int from = kept[i];
            column[listEnd + i] = column[from];
            x[listEnd + i] = x[from];
            y[listEnd + i] = y[from];
            z[listEnd + i] = z[from];
            square[listEnd + i] = square[from];
        }
        return listEnd + count;
    }

    /** Writes the points of a list that are near a place to {@link #near}; returns their number. The first loop runs on lanes. */
    private int findNear(int place, int list, int listEnd) {
        float placeX = placesX[place];
        float placeY = placesY[place];
        float placeZ = placesZ[place];
        for (int i = list; i < listEnd; i++) {
            float dx = placeX - x[i];
            float dy = placeY - y[i];
            float dz = placeZ - z[i];
            excess[i] = dx * dx + dy * dy + dz * dz - square[i];
        }
        int count = keep(list, listEnd);
        for (int i = 0; i < count; i++) {
            near[i] = column[kept[i]];
        }
        return count;
    }

    private int keep(int list, int listEnd) {
        int count = 0;
        for (int i = list; i < listEnd; i++) {
            kept[count] = i;
            count += excess[i] < 0 ? 1 : 0;
        }
        return count;
    }

    private float[] bound(int from, int to) {
        float[] box = new float[6];
        bound(placesX, from, to, box, 0);
        bound(placesY, from, to, box, 1);
        bound(placesZ, from, to, box, 2);
        return box;
    }

    private void bound(float[] along, int from, int to, float[] box, int axis) {
        float least = along[places[from]];
        float greatest = least;
        for (int i = from + 1; i < to; i++) {
            least = Math.min(least, along[places[i]]);
            greatest = Math.max(greatest, along[places[i]]);
        }
        box[axis] = least;
        box[3 + axis] = greatest;
    }
}

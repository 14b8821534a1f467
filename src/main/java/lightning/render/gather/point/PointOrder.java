package lightning.render.gather.point;

import lightning.render.gather.cell.SurfaceColumns;

/** Sorts points into clusters of neighbors, by halving the longest side of their box again and again. */
final class PointOrder {
    private final SurfaceColumns points;
    private final int[] order;

    PointOrder(SurfaceColumns points) {
        this.points = points;
        order = new int[points.count];
        for (int p = 0; p < order.length; p++) {
            order[p] = p;
        }
    }

    /** Returns the points in clusters of {@code size}, a power of two; the last one may be smaller. */
    int[] clusters(int size) {
        split(0, order.length, size);
        return order;
    }

    private void split(int from, int to, int size) {
        if (to - from <= size) {
            return;
        }
        float[] along = longestAxis(from, to);
        // A power of two, so that all clusters but the last are full.
        int middle = from + Integer.highestOneBit(to - from - 1);
        select(along, from, to - 1, middle);
        split(from, middle, size);
        split(middle, to, size);
    }

    private float[] longestAxis(int from, int to) {
        float x = extent(points.px, from, to);
        float y = extent(points.py, from, to);
        float z = extent(points.pz, from, to);
        return x >= y && x >= z ? points.px : y >= z ? points.py : points.pz;
    }

    private float extent(float[] along, int from, int to) {
        float least = along[order[from]];
        float greatest = least;
        for (int i = from + 1; i < to; i++) {
            least = Math.min(least, along[order[i]]);
            greatest = Math.max(greatest, along[order[i]]);
        }
        return greatest - least;
    }

    /** Moves the points so that none of those from {@code middle} on comes before any of the others (C. A. R. Hoare, Algorithm 65: find, 1961). */
    private void select(float[] along, int from, int to, int middle) {
        int low = from;
        int high = to;
        while (low < high) {
            float pivot = along[order[low + high >>> 1]];
            int i = low;
            int j = high;
            while (i <= j) {
                while (along[order[i]] < pivot) {
                    i++;
                }
                while (along[order[j]] > pivot) {
                    j--;
                }
                if (i <= j) {
                    int swapped = order[i];
                    order[i++] = order[j];
                    order[j--] = swapped;
                }
            }
            if (middle <= j) {
                high = j;
            } else if (middle >= i) {
                low = i;
            } else {
                return;
            }
        }
    }
}

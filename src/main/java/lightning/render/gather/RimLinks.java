package lightning.render.gather;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/** What the additional rays of gather points meet, through cells of directions that contain the rim of an opening. Immutable. */
public final class RimLinks {
    /** Maximum bytes of an additional ray: its number while it is found and afterwards, its tint twice, and its cell. */
    public static final int BUILD_BYTES = 4 + 4 + 12 + 16 + 2;

    /** First cell and first ray of each point, and the numbers of all; empty if there are none. */
    private final int[] firstCell;
    private final int[] firstRay;
    /** Cells in the grid of directions, ascending for each point. */
    private final char[] cell;
    private final RayLinks rays;

    RimLinks(int[] firstCell, int[] firstRay, char[] cell, RayLinks rays) {
        this.firstCell = firstCell;
        this.firstRay = firstRay;
        this.cell = cell;
        this.rays = rays;
    }

    /** Returns links without rays. */
    static RimLinks none() {
        return new RimLinks(new int[0], new int[0], new char[0], new RayLinks(1, 1, null));
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(firstCell);
        out.writeArray(firstRay);
        out.writeArray(cell);
        rays.writeTo(out);
    }

    static RimLinks readFrom(ColumnReader in) throws IOException {
        return new RimLinks(in.readInts(), in.readInts(), in.readChars(), RayLinks.readFrom(in));
    }

    /** Returns the number of additional rays. */
    public int rayCount() {
        return rays.rayCount();
    }

    /**
     * Replaces the light that a point's ray meets in each cell with a rim by the mean of all rays there.
     *
     * @param links the points' own rays
     * @param light as in {@link RayLinks#sum(int, float[], float[])}
     * @param to    sum over the point's own rays: red, green and blue
     */
    public void add(int point, RayLinks links, float[] light, float[] to) {
        if (firstCell.length == 0 || firstCell[point] == firstCell[point + 1]) {
            return;
        }
        int added = (firstRay[point + 1] - firstRay[point]) / (firstCell[point + 1] - firstCell[point]);
        float[] own = new float[3];
        float[] others = new float[3];
        for (int i = firstCell[point], ray = firstRay[point]; i < firstCell[point + 1]; i++, ray += added) {
            links.sum(point * links.raysPerPoint() + cell[i], 1, light, own);
            rays.sum(ray, added, light, others);
            for (int c = 0; c < 3; c++) {
                to[c] += (others[c] - added * own[c]) / (added + 1);
            }
        }
    }

    /** Returns the bytes of the links. */
    long bytes() {
        return 4L * firstCell.length + 4L * firstRay.length + 2L * cell.length + rays.bytes();
    }
}

package lightning.render.gather.rim;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySums;

/**
 * Links of the additional rays of gather points, through cells of directions that contain the rim of an opening. Immutable.
 *
 * @param firstCell   first cell of each point, and the number of all; empty if there are none
 * @param firstRay    first ray of each point, and the number of all
 * @param cell        cells in the grid of directions, ascending for each point
 * @param substituted rays that hit a cell without a surfel, so that they have the number of another ray; ascending
 */
public record RimLinks(int[] firstCell, int[] firstRay, char[] cell, RayLinks rays, int[] substituted) {
    /** Maximum bytes of an additional ray: its number while it is found and afterwards, its tint twice, its cell, and a substitution. */
    public static final int BUILD_BYTES = 4 + 4 + 12 + 16 + 2 + 4;
    static final int NONE = -1;

    /** Returns links without rays. */
    public static RimLinks none() {
        return new RimLinks(new int[0], new int[0], new char[0], new RayLinks(1, 1, null), new int[0]);
    }

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(firstCell);
        out.writeArray(firstRay);
        out.writeArray(cell);
        rays.writeTo(out);
        out.writeArray(substituted);
    }

    public static RimLinks readFrom(ColumnReader in) throws IOException {
        return new RimLinks(in.readInts(), in.readInts(), in.readChars(), RayLinks.readFrom(in), in.readInts());
    }

    /**
     * Returns an additional ray of a point; {@link #NONE} if there is no such ray, or if it hit a cell without a surfel.
     *
     * @param itsCell cell of the grid of directions
     * @param nth     number of the ray in the cell, 1 or more
     */
    public int find(int point, char itsCell, int nth) {
        int at = firstCell.length == 0 ? NONE : Arrays.binarySearch(cell, firstCell[point], firstCell[point + 1], itsCell);
        int added = at < 0 ? 0 : added(point);
        if (nth > added) {
            return NONE;
        }
        int ray = firstRay[point] + (at - firstCell[point]) * added + nth - 1;
        return Arrays.binarySearch(substituted, ray) < 0 ? ray : NONE;
    }

    /** Returns the surfel that an additional ray hit; {@link RayLinks#MISS} for none. */
    public int surfel(int ray) {
        return rays.surfel(ray);
    }

    /** Returns the number of additional rays in each cell of a point that has such cells. */
    private int added(int point) {
        return (firstRay[point + 1] - firstRay[point]) / (firstCell[point + 1] - firstCell[point]);
    }

    /**
     * Replaces the light that a point's ray meets in each cell with a rim by the mean of all rays there.
     *
     * @param links the points' own rays
     * @param light as in {@link RayLinks#sum(int, FilmLight, RaySums)}
     * @param own   scratch memory, as {@code others}
     * @param to    sums over the point's own rays
     */
    public void add(int point, RayLinks links, FilmLight light, RaySums own, RaySums others, RaySums to) {
        if (firstCell.length == 0 || firstCell[point] == firstCell[point + 1]) {
            return;
        }
        int added = added(point);
        for (int i = firstCell[point], ray = firstRay[point]; i < firstCell[point + 1]; i++, ray += added) {
            links.sum(point * links.raysPerPoint() + cell[i], 1, light, own);
            rays.sum(ray, added, light, others);
            for (int film = 0; film < light.films(); film++) {
                for (int c = 0; c < 3; c++) {
                    to.add(film, c, (others.get(film, c) - added * own.get(film, c)) / (added + 1));
                }
            }
        }
    }

    /** Returns the bytes of the links. */
    public long bytes() {
        return 4L * firstCell.length + 4L * firstRay.length + 2L * cell.length + 4L * substituted.length + rays.bytes();
    }
}

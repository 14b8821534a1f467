package lightning.render.shading;

import java.util.BitSet;
import org.jspecify.annotations.Nullable;

/**
 * Films of a tile's pixel centers, of samples of some pixels, or of gather points.
 *
 * @param colors columns of each film; null for films that are black, and for unknown ones
 * @param known  films whose colors are known
 * @param branches sums beside the film whose weight was edited last; null if there are none
 */
public record StoredFilms(float[] @Nullable [][] colors, BitSet known, @Nullable FilmBranches branches) {
    // Arrays in a record: written once by their creator, never after.

    public StoredFilms(float[] @Nullable [][] colors, BitSet known) {
        this(colors, known, null);
    }

    /** Returns the columns of a known film; null if it is black, and for numbers after the last. */
    public float @Nullable [][] get(int film) {
        return film < colors.length ? colors[film] : null;
    }

    /**
     * Returns the films after an update.
     *
     * @param before   films before; null if there are none
     * @param origin   for each film its number before; −1 for none
     * @param changed  films that differ, of which those in {@code composed} are known
     * @param composed films of the source
     * @param source   new films of the update; copied if they are scratch memory
     */
    public static StoredFilms after(@Nullable StoredFilms before, int[] origin, BitSet changed, BitSet composed, FilmSum.Films source) {
        float[] @Nullable [][] colors = new float[origin.length][][];
        BitSet known = (BitSet) composed.clone();
        for (int film = 0; film < origin.length; film++) {
            if (composed.get(film)) {
                colors[film] = source.get(film);
            } else if (before != null && origin[film] >= 0 && !changed.get(film) && before.known.get(origin[film])) {
                colors[film] = before.colors[origin[film]];
                known.set(film);
            }
        }
        return new StoredFilms(colors, known);
    }

    /** Returns the bytes of all colors and sums. */
    public long bytes() {
        long bytes = branches == null ? 0 : branches.bytes();
        for (float[][] film : colors) {
            for (float[] column : film == null ? new float[0][] : film) {
                bytes += (long) Float.BYTES * column.length;
            }
        }
        return bytes;
    }
}

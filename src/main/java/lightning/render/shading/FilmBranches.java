package lightning.render.shading;

import java.util.Arrays;

/**
 * Sums of the branches that stand beside one film in the tree of {@link FilmSum}. While the weight of that film alone changes, they stay, so that
 * as many columns are read as the tree has levels, and not all films.
 *
 * @param film    the film
 * @param from    first of the few films that are read one by one, with {@code film} among them
 * @param end     the film after the last of these
 * @param weights weight of each film; that of {@code film} is unread
 * @param sums    red, green and blue of each branch, the largest first; null for channels that are black
 */
public record FilmBranches(int film, int from, int end, LightWeight[] weights, float[][][] sums) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns whether these are the sums beside a film with other weights. */
    boolean fits(int other, LightWeight[] now) {
        boolean fits = film == other && weights.length == now.length;
        for (int i = 0; fits && i < now.length; i++) {
            fits = i == film || weights[i].red() == now[i].red() && weights[i].green() == now[i].green()
                    && weights[i].blue() == now[i].blue();
        }
        return fits;
    }

    long bytes() {
        return Arrays.stream(sums).flatMap(Arrays::stream).mapToLong(column -> column == null ? 0 : (long) Float.BYTES * column.length)
                .sum();
    }
}

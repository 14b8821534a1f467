package lightning.render.shading.composition;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.TermKernel;
import org.jspecify.annotations.Nullable;

/** Gathered light at the rows of a level, computed for some films side by side. Scratch memory of one thread. */
final class GatheredColumns {
    private final FilmKernel kernel;
    private final float[][][] columns = new float[FilmLight.MAX_FILMS][][];
    private final int[] films = new int[FilmLight.MAX_FILMS];
    private int count;
    private @Nullable IndirectRows rows;
    private BitSet composed = new BitSet();

    GatheredColumns(FilmKernel kernel) {
        this.kernel = kernel;
    }

    /**
     * Starts a level.
     *
     * @param itsRows null if it has no gathered light
     * @param itsFilms films that are composed, in ascending order
     */
    void start(@Nullable IndirectRows itsRows, BitSet itsFilms) {
        rows = itsRows;
        composed = itsFilms;
        count = 0;
    }

    /**
     * Returns the light of a film: red, green and blue, and, if there are reflection points, six columns of what the rows reflect. The caller
     * may overwrite them. Null if the film has none.
     */
    float @Nullable [][] get(int film) {
        if (rows == null || rows.light()[film] == null) {
            return null;
        }
        int place = Arrays.binarySearch(films, 0, count, film);
        if (place < 0) {
            compute(rows, film);
            place = 0;
        }
        return columns[place];
    }

    /** Computes the light of a film and of those that follow. */
    private void compute(IndirectRows of, int first) {
        float[][][] light = new float[FilmLight.MAX_FILMS][][];
        count = 0;
        for (int film = first; film >= 0 && count < light.length; film = composed.nextSetBit(film + 1)) {
            if (of.light()[film] != null) {
                light[count] = of.light()[film];
                films[count++] = film;
            }
        }
        int length = of.weights().reflected() == null ? 3 : light[0].length;
        for (int i = 0; i < count; i++) {
            if (columns[i] == null || columns[i].length != length) {
                columns[i] = new float[length][TermKernel.MAX_ROWS];
            }
        }
        of.weights().interpolate(Arrays.copyOf(light, count), kernel, columns);
    }
}

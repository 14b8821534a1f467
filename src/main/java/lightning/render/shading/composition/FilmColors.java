package lightning.render.shading.composition;

import java.util.Arrays;
import lightning.render.shading.SampleMean;
import lightning.render.shading.TermKernel;
import org.jspecify.annotations.Nullable;

/**
 * Colors of all films over the positions of a tile, or over the rays that bounce from a level's rows: red, green and blue columns of {@code
 * float[1024]} each. Films that are black there have none. Scratch memory for one thread.
 */
public final class FilmColors {
    private float[] @Nullable [][] columns = new float[0][][];
    private boolean[] isShown = {};
    private int positions = TermKernel.MAX_ROWS;

    /** Returns the number of positions that are used. */
    int positions() {
        return positions;
    }

    /** Makes all films black. */
    public void clear(int films) {
        clear(films, TermKernel.MAX_ROWS);
    }

    /** Makes all films black. @param used number of positions, at most 1024; the values of others are undefined */
    public void clear(int films, int used) {
        positions = used;
        if (columns.length < films) {
            columns = Arrays.copyOf(columns, films);
            isShown = new boolean[films];
        } else {
            Arrays.fill(isShown, false);
        }
    }

    /** Returns the colors of a film; null if it is black. */
    public float @Nullable [][] get(int film) {
        return film < isShown.length && isShown[film] ? columns[film] : null;
    }

    /** Returns a copy of the colors of a film; null if it is black. */
    public float @Nullable [][] copy(int film) {
        float[][] its = get(film);
        return its == null ? null : new float[][] {its[0].clone(), its[1].clone(), its[2].clone()};
    }

    /**
     * Returns the means of the samples of some pixels in a film; null if it is black.
     *
     * @param perPixel number of samples of a pixel; those of the first pixel come first
     */
    public float @Nullable [][] mean(int film, int pixels, int perPixel) {
        float[][] its = get(film);
        return its == null ? null : SampleMean.ofPixels(pixels, perPixel, its);
    }

    /** Returns the means of samples in all films; parameters as above. */
    public float[] @Nullable [][] means(int films, int pixels, int perPixel) {
        float[] @Nullable [][] means = new float[films][][];
        Arrays.setAll(means, film -> mean(film, pixels, perPixel));
        return means;
    }

    /** Returns the colors of a film, to be written; 0 if it was black. */
    public float[][] toWrite(int film) {
        if (isShown[film]) {
            return columns[film];
        }
        float[][] its = columns[film];
        if (its == null) {
            its = new float[3][TermKernel.MAX_ROWS];
            columns[film] = its;
        } else {
            for (float[] channel : its) {
                Arrays.fill(channel, 0, positions, 0);
            }
        }
        isShown[film] = true;
        return its;
    }
}

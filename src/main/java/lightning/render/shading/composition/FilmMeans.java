package lightning.render.shading.composition;

import java.util.BitSet;
import lightning.render.shading.SampleMean;

/** Means of the samples of pixels in all films. Scratch memory for one thread. */
public final class FilmMeans {
    private final int firstCount;
    private final int restCount;
    private final FilmColors means = new FilmColors();
    private int films;

    /**
     * @param firstCount number of the first samples of a pixel
     * @param restCount  number of further samples; 0 if there are none
     */
    public FilmMeans(int firstCount, int restCount) {
        this.firstCount = firstCount;
        this.restCount = restCount;
    }

    /** Makes all pixels black in all films. */
    public void clear(int count) {
        films = count;
        means.clear(count);
    }

    /** Returns the colors of a tile's pixels. */
    public FilmColors films() {
        return means;
    }

    /**
     * Sets pixels to the means of their first samples.
     *
     * @param pixels  indices of the pixels in the tile
     * @param samples the samples of the first pixel, then of the next
     */
    public void setFirst(short[] pixels, FilmColors samples) {
        for (int film = 0; film < films; film++) {
            float[][] mean = samples.mean(film, pixels.length, firstCount);
            if (mean != null) {
                float[][] to = means.toWrite(film);
                for (int c = 0; c < 3; c++) {
                    for (int i = 0; i < pixels.length; i++) {
                        to[c][pixels[i]] = mean[c][i];
                    }
                }
            }
        }
    }

    /** Combines pixels with the means of their further samples; parameters as above. @param used pixels that are combined */
    public void addRest(short[] pixels, BitSet used, FilmColors samples) {
        float[] black = new float[pixels.length];
        for (int film = 0; film < films; film++) {
            float[][] its = samples.mean(film, pixels.length, restCount);
            if (its != null || means.get(film) != null) {
                float[][] mean = its == null ? new float[][] {black, black, black} : its;
                float[][] to = means.toWrite(film);
                for (int c = 0; c < 3; c++) {
                    for (int i = 0; i < pixels.length; i++) {
                        if (!used.get(pixels[i])) {
                            continue;
                        }
                        to[c][pixels[i]] = SampleMean.combine(to[c][pixels[i]], firstCount, mean[c][i], restCount);
                    }
                }
            }
        }
    }
}

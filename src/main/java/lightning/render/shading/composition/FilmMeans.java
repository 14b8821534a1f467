package lightning.render.shading.composition;

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

    /** Makes all pixels black in all films. @param pixels their number, at most 1024 */
    public void clear(int count, int pixels) {
        films = count;
        means.clear(count, pixels);
    }

    /** Returns the colors of the pixels. */
    public FilmColors films() {
        return means;
    }

    /**
     * Sets pixels to the means of their first samples.
     *
     * @param from    first of the pixels
     * @param count   number of them
     * @param samples the samples of the first pixel, then of the next
     */
    public void setFirst(int from, int count, FilmColors samples) {
        for (int film = 0; film < films; film++) {
            float[][] mean = samples.mean(film, count, firstCount);
            if (mean != null) {
                float[][] to = means.toWrite(film);
                for (int c = 0; c < 3; c++) {
                    System.arraycopy(mean[c], 0, to[c], from, count);
                }
            }
        }
    }

    /** Combines pixels with the means of their further samples. @param pixels the pixels, whose samples are in this order */
    public void addRest(int[] pixels, FilmColors samples) {
        float[] black = new float[pixels.length];
        for (int film = 0; film < films; film++) {
            float[][] its = samples.mean(film, pixels.length, restCount);
            if (its != null || means.get(film) != null) {
                float[][] mean = its == null ? new float[][] {black, black, black} : its;
                float[][] to = means.toWrite(film);
                for (int c = 0; c < 3; c++) {
                    for (int i = 0; i < pixels.length; i++) {
                        to[c][pixels[i]] = SampleMean.combine(to[c][pixels[i]], firstCount, mean[c][i], restCount);
                    }
                }
            }
        }
    }
}

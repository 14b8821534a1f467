package lightning.render.gather.ray;

/** Adds up the light of films that stand side by side. Any thread may call it. */
public interface FilmKernel {
    /**
     * Writes the sums of weight · light over some numbers, in their order, each product and sum rounded to float.
     *
     * @param to receives {@link FilmLight#stride} sums: those of red, green and blue of each film come first
     */
    void weightedSum(FilmLight light, int[] number, float[] weight, int count, float[] to);
}

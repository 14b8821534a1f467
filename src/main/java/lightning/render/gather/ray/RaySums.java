package lightning.render.gather.ray;

import java.util.Arrays;

/** Weighted sums of the light of some films that rays meet: red, green and blue of each. Scratch memory of one thread. */
public final class RaySums {
    private final FilmKernel kernel;
    private final float[] sum = new float[FilmLight.MAX_STRIDE];
    /** What the rays meet, in their order. */
    private int[] number = {};
    private float[] weight = {};
    /** Red, green and blue tint of each ray, if any is tinted. */
    private final float[][] tint = new float[3][];

    public RaySums(FilmKernel kernel) {
        this.kernel = kernel;
    }

    /** Returns room for the numbers of what some rays meet. Their weights are 1 if there was less room before. */
    public int[] numbers(int rays) {
        if (number.length < rays) {
            number = new int[rays];
            weight = new float[rays];
            Arrays.fill(weight, 1);
            for (int c = 0; c < 3; c++) {
                tint[c] = new float[rays];
            }
        }
        return number;
    }

    /** Returns the weights of as many rays. */
    public float[] weights() {
        return weight;
    }

    /** Returns room for the tints of as many rays: red, green and blue. */
    public float[][] tints() {
        return tint;
    }

    /** Adds up weight · (light · tint) of the first numbers, in their order for each film. */
    public void addUp(FilmLight light, int rays, boolean isTinted) {
        if (isTinted) {
            addUpTinted(light, rays);
        } else {
            kernel.weightedSum(light, number, weight, rays, sum);
        }
    }

    private void addUpTinted(FilmLight light, int rays) {
        Arrays.fill(sum, 0);
        for (int ray = 0; ray < rays; ray++) {
            for (int film = 0; film < light.films(); film++) {
                int at = light.at(number[ray], film);
                for (int c = 0; c < 3; c++) {
                    sum[3 * film + c] += weight[ray] * (light.values()[at + c] * tint[c][ray]);
                }
            }
        }
    }

    /** Adds light to a channel of a film. */
    public void add(int film, int channel, float light) {
        sum[3 * film + channel] += light;
    }

    /** Returns a channel of a film. */
    public float get(int film, int channel) {
        return sum[3 * film + channel];
    }

    /** Writes red, green and blue of each film to an element of columns. */
    public void writeTo(float[][][] columns, int element) {
        for (int film = 0; film < columns.length; film++) {
            for (int c = 0; c < 3; c++) {
                columns[film][c][element] = sum[3 * film + c];
            }
        }
    }

    /** Writes the sums as the light of a number. */
    public void writeTo(FilmLight light, int to) {
        light.set(to, sum);
    }
}

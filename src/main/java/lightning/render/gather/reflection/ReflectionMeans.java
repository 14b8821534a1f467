package lightning.render.gather.reflection;

import java.util.Arrays;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;

/** Mean light that a reflection point shows, in the order of its rays for each film. Scratch memory of one thread. */
public final class ReflectionMeans {
    /** What the rays meet, and their shares of the two means. */
    final int[] number;
    final float[] colorShare;
    final float[] whiteShare;
    /** Red, green and blue tint of each ray, if any ray of the point is tinted. */
    final float[][] tint;

    private final FilmKernel kernel;
    private final float[] sum = new float[FilmLight.MAX_STRIDE];

    ReflectionMeans(int raysPerPoint, FilmKernel kernel) {
        this.kernel = kernel;
        number = new int[raysPerPoint];
        colorShare = new float[raysPerPoint];
        whiteShare = new float[raysPerPoint];
        tint = new float[3][raysPerPoint];
    }

    /** Writes the means as the light of a number. @param light what the rays meet */
    void write(FilmLight light, boolean isTinted, int to, FilmLight color, FilmLight white) {
        write(light, isTinted, colorShare, to, color);
        write(light, isTinted, whiteShare, to, white);
    }

    private void write(FilmLight light, boolean isTinted, float[] share, int to, FilmLight mean) {
        if (isTinted) {
            addUpTinted(light, share);
        } else {
            kernel.weightedSum(light, number, share, number.length, sum);
        }
        mean.set(to, sum);
    }

    private void addUpTinted(FilmLight light, float[] share) {
        Arrays.fill(sum, 0);
        for (int ray = 0; ray < number.length; ray++) {
            for (int film = 0; film < light.films(); film++) {
                int at = light.at(number[ray], film);
                for (int c = 0; c < 3; c++) {
                    sum[3 * film + c] += share[ray] * (light.values()[at + c] * tint[c][ray]);
                }
            }
        }
    }
}

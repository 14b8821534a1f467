package lightning.render.gather.reflection;

import lightning.render.gather.ray.FilmLight;

/** Mean light that a reflection point shows, in the order of its rays for each film. Scratch memory of one thread. */
public final class ReflectionMeans {
    /** What the rays meet, and their shares of the two means. */
    final int[] number;
    final float[] colorShare;
    final float[] whiteShare;
    /** Red, green and blue tint of each ray, if any ray of the point is tinted. */
    final float[][] tint;

    ReflectionMeans(int raysPerPoint) {
        number = new int[raysPerPoint];
        colorShare = new float[raysPerPoint];
        whiteShare = new float[raysPerPoint];
        tint = new float[3][raysPerPoint];
    }

    /** Writes the means as the light of a number. @param light what the rays meet */
    void write(FilmLight light, boolean isTinted, int to, FilmLight color, FilmLight white) {
        float[] values = light.values();
        int stride = light.stride();
        for (int film = 0; film < light.films(); film++) {
            float colorRed = 0;
            float colorGreen = 0;
            float colorBlue = 0;
            float whiteRed = 0;
            float whiteGreen = 0;
            float whiteBlue = 0;
            for (int ray = 0; ray < number.length; ray++) {
                int at = stride * number[ray] + 3 * film;
                float red = isTinted ? values[at] * tint[0][ray] : values[at];
                float green = isTinted ? values[at + 1] * tint[1][ray] : values[at + 1];
                float blue = isTinted ? values[at + 2] * tint[2][ray] : values[at + 2];
                colorRed += colorShare[ray] * red;
                colorGreen += colorShare[ray] * green;
                colorBlue += colorShare[ray] * blue;
                whiteRed += whiteShare[ray] * red;
                whiteGreen += whiteShare[ray] * green;
                whiteBlue += whiteShare[ray] * blue;
            }
            color.set(to, film, colorRed, colorGreen, colorBlue);
            white.set(to, film, whiteRed, whiteGreen, whiteBlue);
        }
    }
}

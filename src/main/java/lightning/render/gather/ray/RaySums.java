package lightning.render.gather.ray;

/** Sums of the light of some films that rays meet: red, green and blue of each. Scratch memory of one thread. */
public final class RaySums {
    private final float[] sum = new float[3 * FilmLight.MAX_FILMS];
    /** What the rays meet, in their order. */
    private int[] number = {};
    /** Red, green and blue tint of each ray, if any is tinted. */
    private final float[][] tint = new float[3][];

    /** Returns room for the numbers of some rays. */
    int[] numbers(int rays) {
        if (number.length < rays) {
            number = new int[rays];
            for (int c = 0; c < 3; c++) {
                tint[c] = new float[rays];
            }
        }
        return number;
    }

    /** Returns room for the tints of as many rays: red, green and blue. */
    float[][] tints() {
        return tint;
    }

    /** Adds up the light of the first numbers, in their order for each film. */
    void addUp(FilmLight light, int rays, boolean isTinted) {
        float[] values = light.values();
        int stride = light.stride();
        for (int film = 0; film < light.films(); film++) {
            float red = 0;
            float green = 0;
            float blue = 0;
            for (int ray = 0; ray < rays; ray++) {
                int at = stride * number[ray] + 3 * film;
                red += isTinted ? values[at] * tint[0][ray] : values[at];
                green += isTinted ? values[at + 1] * tint[1][ray] : values[at + 1];
                blue += isTinted ? values[at + 2] * tint[2][ray] : values[at + 2];
            }
            sum[3 * film] = red;
            sum[3 * film + 1] = green;
            sum[3 * film + 2] = blue;
        }
    }

    /** Writes red, green and blue of each film to an element of columns. */
    public void writeTo(float[][][] columns, int element) {
        for (int film = 0; film < columns.length; film++) {
            for (int c = 0; c < 3; c++) {
                columns[film][c][element] = sum[3 * film + c];
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

    /** Writes the sums as the light of a number. */
    public void writeTo(FilmLight light, int to) {
        System.arraycopy(sum, 0, light.values(), light.at(to, 0), 3 * light.films());
    }
}

package lightning.render.gather.ray;

/**
 * Light of up to {@value #MAX_FILMS} films side by side, so that one look-up along a path serves all of them: what one number reads shares a
 * cache line.
 *
 * @param films  number of films
 * @param values red, green and blue of each film, from {@link #at} on
 */
public record FilmLight(int films, float[] values) {
    /** As many as the 16 floats of a cache line hold. */
    public static final int MAX_FILMS = 5;
    public static final int MAX_STRIDE = 16;

    // Arrays in a record: filled in parts by threads, then only read.

    /** Returns no light of some numbers. */
    public static FilmLight black(int films, int numbers) {
        return new FilmLight(films, new float[Math.multiplyExact(stride(films), numbers)]);
    }

    private static int stride(int films) {
        return films == 1 ? 4 : films == 2 ? 8 : MAX_STRIDE;
    }

    /** Returns the elements of a number: a power of two. */
    public int stride() {
        return stride(films);
    }

    /** Returns how many numbers there are. */
    public int numbers() {
        return values.length / stride();
    }

    /** Sets the light of a number in a film. */
    public void set(int number, int film, float red, float green, float blue) {
        int at = at(number, film);
        values[at] = red;
        values[at + 1] = green;
        values[at + 2] = blue;
    }

    /** Sets the light of a number in all films. @param from red, green and blue of each */
    public void set(int number, float[] from) {
        System.arraycopy(from, 0, values, at(number, 0), 3 * films);
    }

    /** Sets the light of a number to that of one of other light of as many films. */
    public void copy(FilmLight from, int fromNumber, int number) {
        System.arraycopy(from.values, from.at(fromNumber, 0), values, at(number, 0), 3 * films);
    }

    /** Returns the element of red of a number's light in a film; green and blue follow. */
    public int at(int number, int film) {
        return stride() * number + 3 * film;
    }
}

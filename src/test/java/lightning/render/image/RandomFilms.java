package lightning.render.image;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Random films for tests. */
public final class RandomFilms {

    private RandomFilms() {}

    /** Returns films of 1 to 70 pixels a side, so that one to three tiles meet in each direction; every bit pattern occurs. */
    public static Arbitrary<Film> anyBits() {
        return Combinators.combine(Arbitraries.integers().between(1, 70), Arbitraries.integers().between(1, 70),
                Arbitraries.longs()).as((width, height, seed) -> anyBits(width, height, seed));
    }

    public static Film anyBits(int width, int height, long seed) {
        Random random = new Random(seed);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = switch (random.nextInt(8)) {
                case 0 -> Float.intBitsToFloat(random.nextInt());
                case 1 -> -0f;
                case 2 -> Float.POSITIVE_INFINITY;
                default -> random.nextFloat() * 1.2f - 0.1f;
            };
        }
        return Film.ofScanlines(width, height, rgb);
    }

    /** Returns a film of display codes, which 8 bits preserve. */
    public static Film anyCodes(int width, int height, long seed) {
        Random random = new Random(seed);
        Film film = Film.black(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                DisplayPixels.set(film, x, y, random.nextInt());
            }
        }
        return film;
    }

    /** Returns a uniform gray film. */
    public static Film gray(int width, int height, float value) {
        float[] rgb = new float[3 * width * height];
        Arrays.fill(rgb, value);
        return Film.ofScanlines(width, height, rgb);
    }

    /** Returns a copy with another green value in one pixel. */
    public static Film withGreen(Film film, int x, int y, float green) {
        Film copy = film.copy();
        copy.green(copy.tileOf(x, y))[Film.pixelInTile(x, y)] = green;
        return copy;
    }
}

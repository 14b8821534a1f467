package lightning.render.image;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.image.ImageFile;

/** Picture assertions that save images of failures. */
public final class FilmAssert {

    private static final Path FAILURES = Path.of("target", "failures");

    private FilmAssert() {}

    /**
     * Asserts that two films have the same size and the same bits in every visible pixel. Otherwise saves actual.png, expected.png
     * and difference.png (see {@link DifferenceImage}) in {@code target/failures/NAME/}. The error reports the folder, the
     * difference and the values of the worst pixel.
     *
     * @param name test name; characters other than letters, digits, - and _ become _ in the folder's name
     */
    public static void assertSameBits(Film actual, Film expected, String name) {
        assertSameBits(actual, expected, name, FAILURES);
    }

    static void assertSameBits(Film actual, Film expected, String name, Path failures) {
        if (actual.width() != expected.width() || actual.height() != expected.height()) {
            throw new AssertionError(name + ": expected " + size(expected) + ", but was " + size(actual));
        }
        if (actual.hasSameBits(expected)) {
            return;
        }
        Path folder = failures.resolve(name.replaceAll("[^\\p{L}\\p{N}_-]", "_"));
        Difference difference = Difference.of(actual, expected);
        write(folder, actual, expected);
        throw new AssertionError(name + ": " + difference.pixels() + " of " + (long) actual.width() * actual.height()
                + " pixels (" + difference.values() + " values) differ in bits, by at most " + difference.maxUlp()
                + " ulp; at (" + difference.x() + ", " + difference.y() + ") expected "
                + pixel(expected, difference.x(), difference.y()) + ", but was "
                + pixel(actual, difference.x(), difference.y()) + "; pictures are in " + folder);
    }

    private static void write(Path folder, Film actual, Film expected) {
        try {
            Files.createDirectories(folder);
            ImageFile.write(folder.resolve("actual.png"), actual, ViewTransform.DEFAULT);
            ImageFile.write(folder.resolve("expected.png"), expected, ViewTransform.DEFAULT);
            ImageFile.write(folder.resolve("difference.png"), DifferenceImage.of(actual, expected),
                    ViewTransform.DEFAULT);
        } catch (IOException e) {
            throw new UncheckedIOException("could not write the images of a failed test", e);
        }
    }

    private static String size(Film film) {
        return film.width() + " × " + film.height() + " pixels";
    }

    private static String pixel(Film film, int x, int y) {
        return value(film.red(x, y)) + " " + value(film.green(x, y)) + " " + value(film.blue(x, y));
    }

    private static String value(float value) {
        return value + "=0x" + Integer.toHexString(Float.floatToRawIntBits(value));
    }
}

package lightning.review;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import lightning.render.image.Film;

/**
 * An image as text: halves of red, green and blue, row by row from the top left. All low bytes come first, then all high bytes, each as the
 * difference from the byte before (of the same channel), compressed by zlib, in Base64.
 */
public final class HalfPlanes {
    private static final float MAX_HALF = 65504;

    private HalfPlanes() {}

    /** Returns the text of a film. Values beyond those of halves become the largest half. */
    static String encode(Film film) {
        return encode(halves(film.toScanlines()), 3);
    }

    /** Returns numbers as halves. Values beyond those of halves become the largest half. */
    public static short[] halves(float[] numbers) {
        short[] halves = new short[numbers.length];
        for (int i = 0; i < numbers.length; i++) {
            halves[i] = Float.floatToFloat16(Math.clamp(numbers[i], -MAX_HALF, MAX_HALF));
        }
        return halves;
    }

    /**
     * Returns the text of numbers of 16 bits.
     *
     * @param stride numbers between two of the same kind
     */
    public static String encode(short[] numbers, int stride) {
        byte[] bytes = new byte[2 * numbers.length];
        for (int i = 0; i < numbers.length; i++) {
            int before = i < stride ? 0 : numbers[i - stride];
            bytes[i] = (byte) (numbers[i] - before);
            bytes[numbers.length + i] = (byte) ((numbers[i] >> 8) - (before >> 8));
        }
        return Base64.getEncoder().encodeToString(compressed(bytes));
    }

    private static byte[] compressed(byte[] bytes) {
        var to = new ByteArrayOutputStream();
        var deflater = new Deflater(Deflater.BEST_SPEED);
        try (var out = new DeflaterOutputStream(to, deflater)) {
            out.write(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
        return to.toByteArray();
    }
}

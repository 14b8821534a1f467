package lightning.format.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import lightning.render.image.Film;

/**
 * Portable float map: the linear film, every bit of every float.
 *
 * <p>Three lines of text — {@code PF}, width and height, and a scale whose sign is negative for little-endian — then the
 * interleaved RGB floats, the <em>bottom</em> row first. The scale's magnitude is a brightness unit that no common program
 * applies; it is ignored here too.
 */
final class Pfm {

    private Pfm() {}

    static void write(OutputStream out, Film film) throws IOException {
        out.write(("PF\n" + film.width() + " " + film.height() + "\n-1.0\n").getBytes(StandardCharsets.US_ASCII));
        ByteBuffer row = ByteBuffer.allocate(12 * film.width()).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = film.height() - 1; y >= 0; y--) {
            row.clear();
            for (int x = 0; x < film.width(); x++) {
                // Copy raw bits: a float register may change the payload of a NaN.
                row.putInt(Float.floatToRawIntBits(film.red(x, y)));
                row.putInt(Float.floatToRawIntBits(film.green(x, y)));
                row.putInt(Float.floatToRawIntBits(film.blue(x, y)));
            }
            out.write(row.array());
        }
    }
}

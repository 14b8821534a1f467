package lightning.format.picture;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.zip.Adler32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * A row of a film's tiles as PNG has its lines: filtered and packed by themselves, so that bands are made side by side and written
 * one after the other. A filter takes each byte's difference from the same channel of the pixel before it, or of the one above it.
 *
 * @param packed deflated, up to a whole byte and not ended
 * @param length bytes before that
 * @param adler  their checksum
 */
record PngBand(byte[] packed, int length, long adler) {
    /** On pictures of light half as much effort makes them a sixth longer, and twice as much a thirtieth shorter in twice the time. */
    private static final int EFFORT = 4;

    private static final byte BEFORE = 1;
    private static final byte ABOVE = 2;

    /** @param bits of a channel, 8 or 16 */
    static PngBand of(Film film, ViewTransform view, int bits, int row) {
        byte[] lines = filtered(bits == Byte.SIZE ? codes(film, view, row) : deepCodes(film, view, row), 3 * bits / Byte.SIZE,
                film.width());
        Adler32 adler = new Adler32();
        adler.update(lines);
        return new PngBand(deflated(lines), lines.length, adler.getValue());
    }

    private static int lines(Film film, int row) {
        return Math.min(Film.TILE, film.height() - row * Film.TILE);
    }

    /** 8 bits: {@code byte[lines * width * 3]}. */
    private static byte[] codes(Film film, ViewTransform view, int row) {
        int[] pixels = new int[lines(film, row) * film.width()];
        for (int i = 0; i < film.tilesX(); i++) {
            int tile = row * film.tilesX() + i;
            view.packTile(film.red(tile), film.green(tile), film.blue(tile), i * Film.TILE, 0, film.width(), pixels);
        }
        byte[] codes = new byte[3 * pixels.length];
        for (int i = 0, at = 0; i < pixels.length; i++) {
            codes[at++] = (byte) (pixels[i] >> 16);
            codes[at++] = (byte) (pixels[i] >> 8);
            codes[at++] = (byte) pixels[i];
        }
        return codes;
    }

    /** 16 bits, the higher byte first: {@code byte[lines * width * 6]}. */
    private static byte[] deepCodes(Film film, ViewTransform view, int row) {
        byte[] codes = new byte[6 * lines(film, row) * film.width()];
        short[] pixel = new short[3];
        for (int i = 0; i < codes.length / 6; i++) {
            int x = i % film.width();
            int y = row * Film.TILE + i / film.width();
            view.packDeep(film.red(x, y), film.green(x, y), film.blue(x, y), pixel, 0);
            for (int channel = 0; channel < 3; channel++) {
                codes[6 * i + 2 * channel] = (byte) (pixel[channel] >> 8);
                codes[6 * i + 2 * channel + 1] = (byte) pixel[channel];
            }
        }
        return codes;
    }

    /** Each line behind the number of its filter. The first knows no line above it, as that is in another band. */
    private static byte[] filtered(byte[] codes, int bytesPerPixel, int width) {
        int line = bytesPerPixel * width;
        byte[] filtered = new byte[codes.length + codes.length / line];
        for (int from = 0, to = 0; from < codes.length; from += line, to += line + 1) {
            byte filter = from == 0 ? BEFORE : filter(codes, from, line, bytesPerPixel);
            filtered[to] = filter;
            int back = filter == BEFORE ? bytesPerPixel : line;
            int alone = filter == BEFORE ? bytesPerPixel : 0;
            System.arraycopy(codes, from, filtered, to + 1, alone);
            for (int i = alone; i < line; i++) {
                filtered[to + 1 + i] = (byte) (codes[from + i] - codes[from + i - back]);
            }
        }
        return filtered;
    }

    /** Whose differences have the least sum, as the standard advises. */
    private static byte filter(byte[] codes, int from, int line, int bytesPerPixel) {
        int before = 0;
        int above = 0;
        for (int i = from + bytesPerPixel; i < from + line; i++) {
            before += Math.abs((byte) (codes[i] - codes[i - bytesPerPixel]));
            above += Math.abs((byte) (codes[i] - codes[i - line]));
        }
        return before <= above ? BEFORE : ABOVE;
    }

    private static byte[] deflated(byte[] lines) {
        var packed = new ByteArrayOutputStream(lines.length / 2);
        try (Deflater deflater = new Deflater(EFFORT, true)) {
            var stream = new DeflaterOutputStream(packed, deflater, 1 << 16, true);
            stream.write(lines);
            stream.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return packed.toByteArray();
    }
}

package lightning.format.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.zip.Adler32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Compressed lines of one row of tiles in a PNG. Bands are filtered and deflated independently, in parallel, and written in
 * order. A filter subtracts from each byte the same channel of the pixel to the left or above.
 *
 * @param compressed deflated data, flushed to a byte boundary, without a final block
 * @param length number of uncompressed bytes
 * @param adler Adler-32 of the uncompressed bytes
 */
record PngBand(byte[] compressed, int length, long adler) {
    /**
     * Compression level. Half the effort makes rendered images 1/6 longer; twice the effort makes them 1/30 shorter in twice
     * the time.
     */
    private static final int COMPRESSION_LEVEL = 4;

    private static final byte SUB_FILTER = 1;
    private static final byte UP_FILTER = 2;

    /**
     * Encodes a row of tiles.
     *
     * @param bits bits per channel, 8 or 16
     */
    static PngBand of(Film film, ViewTransform view, int bits, int row) {
        byte[] lines = applyFilters(bits == Byte.SIZE ? encode8Bit(film, view, row) : encode16Bit(film, view, row), 3 * bits / Byte.SIZE,
                film.width());
        Adler32 adler = new Adler32();
        adler.update(lines);
        return new PngBand(compress(lines), lines.length, adler.getValue());
    }

    private static int lineCount(Film film, int row) {
        return Math.min(Film.TILE_SIZE, film.height() - row * Film.TILE_SIZE);
    }

    /** Encodes 8-bit samples: {@code byte[lines * width * 3]}. */
    private static byte[] encode8Bit(Film film, ViewTransform view, int row) {
        int[] pixels = new int[lineCount(film, row) * film.width()];
        for (int i = 0; i < film.tilesX(); i++) {
            int tile = row * film.tilesX() + i;
            view.packTile(film.red(tile), film.green(tile), film.blue(tile), i * Film.TILE_SIZE, 0, film.width(), pixels);
        }
        byte[] codes = new byte[3 * pixels.length];
        for (int i = 0, index = 0; i < pixels.length; i++) {
            codes[index++] = (byte) (pixels[i] >> 16);
            codes[index++] = (byte) (pixels[i] >> 8);
            codes[index++] = (byte) pixels[i];
        }
        return codes;
    }

    /** Encodes 16-bit samples, big-endian: {@code byte[lines * width * 6]}. */
    private static byte[] encode16Bit(Film film, ViewTransform view, int row) {
        byte[] codes = new byte[6 * lineCount(film, row) * film.width()];
        short[] pixel = new short[3];
        for (int i = 0; i < codes.length / 6; i++) {
            int x = i % film.width();
            int y = row * Film.TILE_SIZE + i / film.width();
            view.pack16(film.red(x, y), film.green(x, y), film.blue(x, y), pixel, 0);
            for (int channel = 0; channel < 3; channel++) {
                codes[6 * i + 2 * channel] = (byte) (pixel[channel] >> 8);
                codes[6 * i + 2 * channel + 1] = (byte) pixel[channel];
            }
        }
        return codes;
    }

    /** Filters each line and prepends its filter type. The first line of a band cannot reference the line above it. */
    private static byte[] applyFilters(byte[] codes, int bytesPerPixel, int width) {
        int lineBytes = bytesPerPixel * width;
        byte[] filtered = new byte[codes.length + codes.length / lineBytes];
        for (int from = 0, to = 0; from < codes.length; from += lineBytes, to += lineBytes + 1) {
            byte filter = from == 0 ? SUB_FILTER : chooseFilter(codes, from, lineBytes, bytesPerPixel);
            filtered[to] = filter;
            int distance = filter == SUB_FILTER ? bytesPerPixel : lineBytes;
            int unfilteredBytes = filter == SUB_FILTER ? bytesPerPixel : 0;
            System.arraycopy(codes, from, filtered, to + 1, unfilteredBytes);
            for (int i = unfilteredBytes; i < lineBytes; i++) {
                filtered[to + 1 + i] = (byte) (codes[from + i] - codes[from + i - distance]);
            }
        }
        return filtered;
    }

    /** Chooses the filter with the smallest sum of absolute differences, as the standard recommends. */
    private static byte chooseFilter(byte[] codes, int from, int lineBytes, int bytesPerPixel) {
        int subCost = 0;
        int upCost = 0;
        for (int i = from + bytesPerPixel; i < from + lineBytes; i++) {
            subCost += Math.abs((byte) (codes[i] - codes[i - bytesPerPixel]));
            upCost += Math.abs((byte) (codes[i] - codes[i - lineBytes]));
        }
        return subCost <= upCost ? SUB_FILTER : UP_FILTER;
    }

    private static byte[] compress(byte[] lines) {
        var compressed = new ByteArrayOutputStream(lines.length / 2);
        try (Deflater deflater = new Deflater(COMPRESSION_LEVEL, true)) {
            var stream = new DeflaterOutputStream(compressed, deflater, 1 << 16, true);
            stream.write(lines);
            stream.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return compressed.toByteArray();
    }
}

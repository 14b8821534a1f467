package lightning.format.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** PNG format: display values, 8 or 16 bits per channel, lossless. */
final class Png {

    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    /** Color type: RGB without alpha. */
    private static final byte RGB = 2;
    /** zlib header: deflate with a 32 kB window. */
    private static final byte[] ZLIB = {0x78, 0x01};
    /** Empty final deflate block. */
    private static final byte[] LAST_BLOCK = {3, 0};
    private static final long ADLER_BASE = 65521;
    /** Number of bands compressed before they are written. */
    private static final int BANDS_PER_BATCH = 16;

    private Png() {}

    /**
     * Writes a film; all workers compress bands of lines in parallel. The file does not depend on their number.
     *
     * @param bits bits per channel, 8 or 16
     */
    static void write(OutputStream out, Film film, ViewTransform view, int bits, WorkerPool workers) throws IOException {
        out.write(SIGNATURE);
        writeChunk(out, "IHDR", ByteBuffer.allocate(13).putInt(film.width()).putInt(film.height()).put((byte) bits).put(RGB).array());
        writeChunk(out, "IDAT", ZLIB);
        long adler = 1;
        PngBand[] bands = new PngBand[BANDS_PER_BATCH];
        for (int row = 0; row < film.tilesY(); row += BANDS_PER_BATCH) {
            int first = row;
            int count = Math.min(BANDS_PER_BATCH, film.tilesY() - first);
            workers.run(count, (_, i) -> bands[i] = PngBand.of(film, view, bits, first + i), Progress.NONE);
            for (int i = 0; i < count; i++) {
                writeChunk(out, "IDAT", bands[i].compressed());
                adler = combineAdler(adler, bands[i].adler(), bands[i].length());
            }
        }
        writeChunk(out, "IDAT", ByteBuffer.allocate(LAST_BLOCK.length + Integer.BYTES).put(LAST_BLOCK).putInt((int) adler).array());
        writeChunk(out, "IEND", new byte[0]);
    }

    private static void writeChunk(OutputStream out, String type, byte[] content) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 crc = new CRC32();
        crc.update(name);
        crc.update(content);
        out.write(encodeInt(content.length));
        out.write(name);
        out.write(content);
        out.write(encodeInt((int) crc.getValue()));
    }

    private static byte[] encodeInt(int v) {
        return ByteBuffer.allocate(Integer.BYTES).putInt(v).array();
    }

    /**
     * Combines the Adler-32 checksums (RFC 1950) of two consecutive byte sequences. The lower half is 1 plus the sum of all
     * bytes, the upper half the sum of all intermediate lower halves, both modulo {@link #ADLER_BASE}.
     *
     * @param length length of the second sequence
     */
    private static long combineAdler(long adler, long next, long length) {
        long low = adler & 0xFFFF;
        // The second sequence started at 1 instead of the first one's lower half.
        long sum = (low + (next & 0xFFFF) + ADLER_BASE - 1) % ADLER_BASE;
        long sums = ((adler >> 16) + (next >> 16) + length % ADLER_BASE * (low + ADLER_BASE - 1)) % ADLER_BASE;
        return sums << 16 | sum;
    }

    /** Returns the maximum memory in bytes for writing: codes, filtered lines and the compressed bands of a batch. */
    static long bytesToWrite(int width) {
        return BANDS_PER_BATCH * 4L * 6 * Film.TILE_SIZE * width;
    }
}

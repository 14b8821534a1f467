package lightning.format.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import lightning.base.file.RegularFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.DisplayPixels;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** PNG: what is displayed, 8 or 16 bits a channel, without loss. */
final class Png {

    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    /** Three channels of color and no alpha. */
    private static final byte RGB = 2;
    /** Deflated, with a window of 32 kB. */
    private static final byte[] ZLIB = {0x78, 0x01};
    /** An empty block that ends all others. */
    private static final byte[] LAST_BLOCK = {3, 0};
    private static final long ADLER_BASE = 65521;
    /** So many bands are packed before they are written. */
    private static final int BANDS_PER_BATCH = 16;

    private Png() {}

    /**
     * Writes a film, lines of it packed by all workers at the same time. How many these are makes no difference to the file.
     *
     * @param bits of a channel, 8 or 16
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
     * Adler-32 (RFC 1950) of bytes and others behind them: its lower half is 1 and the sum of all bytes, its upper half the sum of what
     * the lower half was after each of them, both modulo {@link #ADLER_BASE}.
     *
     * @param length how many the others are
     */
    private static long combineAdler(long adler, long next, long length) {
        long low = adler & 0xFFFF;
        // Each of the others had begun with 1 in place of the lower half so far.
        long sum = (low + (next & 0xFFFF) + ADLER_BASE - 1) % ADLER_BASE;
        long sums = ((adler >> 16) + (next >> 16) + length % ADLER_BASE * (low + ADLER_BASE - 1)) % ADLER_BASE;
        return sums << 16 | sum;
    }

    /** The most bytes that writing takes beside the film: codes, filtered lines and what is packed of a group of bands. */
    static long bytesToWrite(int width) {
        return BANDS_PER_BATCH * 4L * 6 * Film.TILE_SIZE * width;
    }

    /**
     * Display pixels as a film whose values are the linear ones of the codes. Transparency is ignored.
     *
     * @throws IOException if the file is no PNG, is damaged or is too large; the message does not repeat its name
     */
    static Film read(Path file) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (var stream = new MemoryCacheImageInputStream(RegularFile.open(file, "a PNG picture"))) {
            reader.setInput(stream, true, true);
            ImageLimits.check(reader.getWidth(0), reader.getHeight(0));
            return DisplayPixels.toFilm(reader.read(0));
        } catch (RuntimeException e) {
            // The reader answers some damaged files with unchecked exceptions.
            throw new IOException("is no undamaged PNG picture", e);
        } finally {
            reader.dispose();
        }
    }
}

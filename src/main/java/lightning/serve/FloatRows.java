package lightning.serve;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import lightning.base.file.SharedMemoryFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import tools.jackson.databind.node.ObjectNode;

/** Part of a film as rows of 32-bit floats: red, green and blue of each pixel, linear, the top row first. */
record FloatRows(Film film, PictureRegion region) {
    private static final int BYTES_PER_PIXEL = 3 * Float.BYTES;
    /** Rows that a thread writes in one call: few enough for its cache. */
    private static final int STRIP_ROWS = 8;

    /** Returns the bytes of all rows. */
    long bytes() {
        return (long) region.width() * region.height() * BYTES_PER_PIXEL;
    }

    /** Writes the rows, little-endian, in parallel strips. */
    void write(SharedMemoryFile file, WorkerPool workers) throws IOException {
        var strips = new ByteBuffer[workers.count()];
        try (SharedMemoryFile.Writer out = file.openWriter()) {
            workers.run(Math.ceilDiv(region.height(), STRIP_ROWS), (worker, strip) -> {
                if (strips[worker] == null) {
                    strips[worker] =
                            ByteBuffer.allocateDirect(STRIP_ROWS * region.width() * BYTES_PER_PIXEL).order(ByteOrder.LITTLE_ENDIAN);
                }
                writeStrip(out, strip * STRIP_ROWS, strips[worker].clear());
            }, Progress.NONE);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Describes the rows so that a program can map them without knowledge of the request. */
    void describe(SharedMemoryFile memory, ObjectNode node) {
        node.put("path", memory.path().toString()).put("bytes", memory.bytes()).put("type", "float32").put("order", "little");
        node.putArray("shape").add(region.height()).add(region.width()).add(3);
    }

    private void writeStrip(SharedMemoryFile.Writer file, int first, ByteBuffer bytes) {
        int count = Math.min(STRIP_ROWS, region.height() - first);
        float[] row = new float[region.width() * 3];
        FloatBuffer floats = bytes.asFloatBuffer();
        for (int y = first; y < first + count; y++) {
            readRow(y, row, 0);
            floats.put(row);
        }
        try {
            file.write(bytes.limit(floats.position() * Float.BYTES), (long) first * region.width() * BYTES_PER_PIXEL);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Reads a row of the region, counted from its top, into {@code rgb} at an offset. */
    private void readRow(int rowOfRegion, float[] rgb, int offset) {
        int y = region.y() + rowOfRegion;
        int at = offset;
        for (int x = region.x(); x < region.x() + region.width();) {
            int tile = film.tileOf(x, y);
            float[] red = film.red(tile);
            float[] green = film.green(tile);
            float[] blue = film.blue(tile);
            int end = Math.min(region.x() + region.width(), (x / Film.TILE_SIZE + 1) * Film.TILE_SIZE);
            for (int pixel = Film.pixelInTile(x, y); x < end; x++, pixel++) {
                rgb[at++] = red[pixel];
                rgb[at++] = green[pixel];
                rgb[at++] = blue[pixel];
            }
        }
    }

    /** Returns the region as a film of its own; the film itself if it is all of it. */
    Film toFilm() {
        if (region.isAllOf(film)) {
            return film;
        }
        float[] rgb = new float[Math.multiplyExact(Math.multiplyExact(region.width(), region.height()), 3)];
        for (int y = 0; y < region.height(); y++) {
            readRow(y, rgb, y * region.width() * 3);
        }
        return Film.ofScanlines(region.width(), region.height(), rgb);
    }
}

package lightning.serve;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import lightning.base.file.SharedMemoryFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;

/** Part of a film as rows of 32-bit floats: red, green and blue of each pixel, linear, the top row first. */
record FloatRows(Film film, PictureRegion region) {
    private static final int BYTES_PER_PIXEL = 3 * Float.BYTES;

    /** Returns the bytes of all rows. */
    long bytes() {
        return (long) region.width() * region.height() * BYTES_PER_PIXEL;
    }

    /** Writes the rows, little-endian, in parallel strips. */
    void write(SharedMemoryFile file, WorkerPool workers, Progress progress) throws IOException {
        try {
            workers.run(Math.ceilDiv(region.height(), Film.TILE_SIZE), (_, strip) -> writeStrip(file, strip), progress);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private void writeStrip(SharedMemoryFile file, int strip) {
        int first = strip * Film.TILE_SIZE;
        int count = Math.min(Film.TILE_SIZE, region.height() - first);
        ByteBuffer bytes = ByteBuffer.allocate(count * region.width() * BYTES_PER_PIXEL).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(floats(first, count));
        try {
            file.write(bytes, (long) first * region.width() * BYTES_PER_PIXEL);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns some rows of the region. */
    private float[] floats(int first, int count) {
        float[] rgb = new float[count * region.width() * 3];
        int at = 0;
        for (int y = region.y() + first; y < region.y() + first + count; y++) {
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
        return rgb;
    }

    /** Returns the region as a film of its own; the film itself if it is all of it. */
    Film toFilm() {
        return region.isAllOf(film) ? film : Film.ofScanlines(region.width(), region.height(), floats(0, region.height()));
    }
}

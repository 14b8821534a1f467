package lightning.render.measure;

import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;

/** Nearest-neighbor upscaler of images: each pixel takes the color of the source pixel that contains its center. */
final class FilmUpscaler {
    private FilmUpscaler() {}

    /**
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     */
    static Film upscale(Film small, int width, int height, WorkerPool workers, Progress progress) {
        int[] columns = sourceIndices(width, small.width());
        int[] rows = sourceIndices(height, small.height());
        Film large = Film.black(width, height);
        workers.run(large.tileCount(), (_, tile) -> fill(small, large, tile, columns, rows), progress);
        return large;
    }

    /** Returns, for each pixel along a side, the source pixel that contains its center: ⌊(i + ½)·small/large⌋. */
    private static int[] sourceIndices(int large, int small) {
        IntUnaryOperator source = i -> (int) ((2L * i + 1) * small / (2L * large));
        return IntStream.range(0, large).map(source).toArray();
    }

    private static void fill(Film small, Film large, int tile, int[] columns, int[] rows) {
        float[] red = large.red(tile);
        float[] green = large.green(tile);
        float[] blue = large.blue(tile);
        int left = tile % large.tilesX() * Film.TILE_SIZE;
        int top = tile / large.tilesX() * Film.TILE_SIZE;
        int right = Math.min(left + Film.TILE_SIZE, large.width());
        int bottom = Math.min(top + Film.TILE_SIZE, large.height());
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                int to = Film.pixelInTile(x, y);
                int fromTile = rows[y] / Film.TILE_SIZE * small.tilesX() + columns[x] / Film.TILE_SIZE;
                int from = Film.pixelInTile(columns[x], rows[y]);
                red[to] = small.red(fromTile)[from];
                green[to] = small.green(fromTile)[from];
                blue[to] = small.blue(fromTile)[from];
            }
        }
    }
}

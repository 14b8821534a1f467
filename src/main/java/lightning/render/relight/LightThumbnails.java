package lightning.render.relight;

import java.util.BitSet;
import java.util.Collection;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.shading.LightWeight;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/** Thumbnails of every contribution to a picture, from its films: each pixel of a thumbnail is one of the picture. */
public final class LightThumbnails {
    private final PictureFilms films;
    private final int width;
    private final int height;
    /** Image of each film: red, green, blue of each pixel, the top row first. */
    private final float[][] images;
    private final float[] image;

    private LightThumbnails(PictureFilms films, int width, int height) {
        this.films = films;
        this.width = width;
        this.height = height;
        images = new float[films.parts().count()][3 * width * height];
        image = new float[3 * width * height];
    }

    /**
     * Creates thumbnails with the picture's aspect ratio.
     *
     * @param options  of its render
     * @param maxWidth pixels, ≥ 1, with {@code maxHeight}
     * @throws IllegalStateException if mirror levels are stored as hit shapes
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public static LightThumbnails of(PixelCache cache, RenderOptions options, int maxWidth, int maxHeight, Progress progress) {
        int w = cache.scene().picture().width();
        int h = cache.scene().picture().height();
        double shrink = Math.max(1, Math.max((double) w / maxWidth, (double) h / maxHeight));
        return of(cache, options, midpoints(w, (int) Math.max(1, w / shrink)), midpoints(h, (int) Math.max(1, h / shrink)), progress);
    }

    /** Creates the thumbnails of one pixel, in column {@code x} from the left and row {@code y} from the top. */
    public static LightThumbnails pixel(PixelCache cache, RenderOptions options, int x, int y, Progress progress) {
        return of(cache, options, new int[] {x}, new int[] {y}, progress);
    }

    /** Returns the midpoints of {@code count} equal parts of a side. */
    private static int[] midpoints(int side, int count) {
        return IntStream.range(0, count).map(i -> (int) ((2L * i + 1) * side / (2L * count))).toArray();
    }

    private static LightThumbnails of(PixelCache cache, RenderOptions options, int[] columns, int[] rows, Progress progress) {
        LightThumbnails small = new LightThumbnails(new PictureFilms(cache, options), columns.length, rows.length);
        LightWeight[] weights = small.films.parts().weights();
        Film film = cache.film();
        int tilesX = film.tilesX();
        BitSet tiles = new BitSet();
        for (int y : rows) {
            for (int x : columns) {
                tiles.set(y / Film.TILE_SIZE * tilesX + x / Film.TILE_SIZE);
            }
        }
        try (WorkerPool workers = new WorkerPool(options.threads())) {
            small.films.forEachTile(workers, tiles.stream().toArray(), progress, (_, tile, read) -> {
                for (int i = 0; i < columns.length * rows.length; i++) {
                    int x = columns[i % columns.length];
                    int y = rows[i / columns.length];
                    if (y / Film.TILE_SIZE * tilesX + x / Film.TILE_SIZE != tile) {
                        continue;
                    }
                    for (int part = 0; part < weights.length; part++) {
                        float[][] its = read.get(part);
                        for (int c = 0; its != null && c < 3; c++) {
                            small.images[part][3 * i + c] = weights[part].channel(c) * its[c][Film.pixelInTile(x, y)];
                        }
                    }
                    small.image[3 * i] = film.red(x, y);
                    small.image[3 * i + 1] = film.green(x, y);
                    small.image[3 * i + 2] = film.blue(x, y);
                }
            });
        }
        return small;
    }

    /** Returns the scene of the picture. */
    public Scene scene() {
        return films.scene();
    }

    /** Returns the width in pixels. */
    public int width() {
        return width;
    }

    /** Returns the height in pixels. */
    public int height() {
        return height;
    }

    /** Returns the thumbnail of the picture: red, green, blue of each pixel, the top row first. */
    public float[] image() {
        return image.clone();
    }

    /** Returns the sum of some contributions, in the layout of {@link #image}. */
    public float[] sum(Collection<? extends Contribution> contributions) {
        float[] sum = new float[image.length];
        films.parts().of(contributions).stream().forEach(part -> {
            for (int i = 0; i < sum.length; i++) {
                sum[i] += images[part][i];
            }
        });
        return sum;
    }

    /** Returns the mean luminance, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). */
    public static double brightness(float[] rgb) {
        double sum = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            sum += 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
        }
        return 3 * sum / rgb.length;
    }
}

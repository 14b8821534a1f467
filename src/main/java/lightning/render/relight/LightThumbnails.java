package lightning.render.relight;

import java.util.Arrays;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.image.Film;
import lightning.render.shading.LightLayer;
import lightning.render.shading.RowContribution;
import lightning.render.shading.SampleMean;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;

/**
 * What each light gives to some of a picture's pixels, those of the picture at a small size, from what is known: no ray is
 * cast, and only the rows of these pixels are looked at, so that all lights together take less than one picture's composing.
 *
 * <p>A pixel is shown by its center, or by its first sample where all pixels have several. There each value has the bits of
 * {@link Renderer#lightImage} of a picture without anti-aliasing. What is kept of a picture is never written over, so that this may
 * run on any thread beside the renderer.
 */
public final class LightThumbnails {
    private final Scene scene;
    private final int width;
    private final int height;
    /** Of each light, those of the environment last: red, green, blue of each pixel, the top row first. */
    private final float[][] lightImages;
    private final float[] image;

    private LightThumbnails(Scene scene, int width, int height, int lights) {
        this.scene = scene;
        this.width = width;
        this.height = height;
        lightImages = new float[lights][3 * width * height];
        image = new float[3 * width * height];
    }

    /**
     * At a small size, in the shape of the picture.
     *
     * @param maxWidth  pixels, ≥ 1; likewise {@code maxHeight}
     * @throws IllegalStateException if mirror levels are kept as hit shapes
     */
    public static LightThumbnails of(PixelCache cache, int maxWidth, int maxHeight) {
        int w = cache.scene().picture().width();
        int h = cache.scene().picture().height();
        double shrink = Math.max(1, Math.max((double) w / maxWidth, (double) h / maxHeight));
        return of(cache, pixelPositions(w, (int) Math.max(1, w / shrink)), pixelPositions(h, (int) Math.max(1, h / shrink)));
    }

    /** Of one pixel, in column {@code x} from the left and row {@code y} from the top. */
    public static LightThumbnails pixel(PixelCache cache, int x, int y) {
        return of(cache, new int[] {x}, new int[] {y});
    }

    /** The middles of {@code count} equal parts of a side. */
    private static int[] pixelPositions(int side, int count) {
        int[] places = new int[count];
        Arrays.setAll(places, i -> (int) ((2L * i + 1) * side / (2L * count)));
        return places;
    }

    private static LightThumbnails of(PixelCache cache, int[] columns, int[] rows) {
        WeightedLight[] top = WeightedLight.ofScene(cache.scene());
        var shares = new LightThumbnails(cache.scene(), columns.length, rows.length, top.length);
        Film film = cache.film();
        for (int i = 0; i < shares.image.length / 3; i++) {
            int x = columns[i % columns.length];
            int y = rows[i / columns.length];
            shares.image[3 * i] = film.red(x, y);
            shares.image[3 * i + 1] = film.green(x, y);
            shares.image[3 * i + 2] = film.blue(x, y);
        }
        var levels = new LevelWalk(cache, top);
        short[] target = new short[Film.TILE_PIXELS];
        int tilesPerRow = Film.tilesAlong(cache.scene().picture().width());
        for (int y0 = 0; y0 < rows.length;) {
            int y1 = tileEnd(rows, y0);
            for (int x0 = 0; x0 < columns.length;) {
                int x1 = tileEnd(columns, x0);
                Arrays.fill(target, (short) -1);
                for (int y = y0; y < y1; y++) {
                    for (int x = x0; x < x1; x++) {
                        // Places of a tile are few enough to be counted in it.
                        target[Film.pixelInTile(columns[x], rows[y])] = (short) ((y - y0) * (x1 - x0) + x - x0);
                    }
                }
                var part = new TilePart(x0, y0, x1 - x0, columns.length);
                shares.renderTile(cache, rows[y0] / Film.TILE_SIZE * tilesPerRow + columns[x0] / Film.TILE_SIZE, target, part, levels);
                x0 = x1;
            }
            y0 = y1;
        }
        return shares;
    }

    /** Behind the last place that is in the same tile as the one at {@code from}. */
    private static int tileEnd(int[] places, int from) {
        int end = from;
        while (end < places.length && places[end] / Film.TILE_SIZE == places[from] / Film.TILE_SIZE) {
            end++;
        }
        return end;
    }

    /** Where the pixels of one tile stand among all that are looked at. */
    private record TilePart(int left, int top, int width, int across) {
        int index(int i) {
            return (top + i / width) * across + left + i % width;
        }
    }

    private void renderTile(PixelCache cache, int index, short[] target, TilePart part, LevelWalk levels) {
        if (cache.tileCount() > 0) {
            levels.renderTile(cache.tile(index), target, part, lightImages);
            return;
        }
        FineSamples all = cache.fineTile(index).shapes();
        int perPixel = scene.picture().sampling().samplesPerPixel();
        int batchSize = SampleMean.pixelsPerBatch(perPixel);
        for (int b = 0; b < all.blocks().length; b++) {
            short[] first = new short[Film.TILE_PIXELS];
            Arrays.fill(first, (short) -1);
            for (int i = b * batchSize; i < Math.min(all.pixels().length, (b + 1) * batchSize); i++) {
                first[(i - b * batchSize) * perPixel] = target[all.pixels()[i]];
            }
            levels.renderTile(all.blocks()[b], first, part, lightImages);
        }
    }

    /** The rows of single pixels, and of all that is seen from there in mirrors and through clear surfaces. */
    private static final class LevelWalk {
        private final WeightedLight[] lights;
        /** The lights that the mirrors show, each at the place of the light of that name; null where there is none. */
        private final WeightedLight[] mirrorLights;
        /** Where each of these stands among the layers of a mirror level. */
        private final int[] mirrorLayer;
        private final RowContribution eyeShader;
        private final RowContribution mirrorShader;
        private final int depth;
        private TileLevel[] levels;
        /** The level to be looked at next. */
        private int nextLevel;

        LevelWalk(PixelCache cache, WeightedLight[] top) {
            this.lights = top;
            depth = cache.scene().picture().depth();
            mirrorLights = new WeightedLight[top.length];
            mirrorLayer = new int[top.length];
            WeightedLight[] known = WeightedLight.ofScene(cache.mirroredScene());
            for (int l = 0; l < top.length; l++) {
                for (int m = 0; m < known.length; m++) {
                    if (known[m].light().name().equals(top[l].light().name())) {
                        mirrorLights[l] = known[m];
                        mirrorLayer[l] = m;
                    }
                }
            }
            eyeShader = new RowContribution(cache.geometry().materials());
            mirrorShader = new RowContribution(cache.mirroredGeometry().materials());
        }

        /** @param target for each place of the tile its number in the part, or −1 */
        void renderTile(CachedTile tile, short[] target, TilePart part, float[][] shares) {
            if (!tile.storesRows()) {
                throw new IllegalStateException("mirror levels are stored as hit shapes");
            }
            levels = tile.levels;
            nextLevel = 1;
            SelectedRows first = collectLevel(0, 0, target);
            for (int l = 0; l < lights.length; l++) {
                float[] colors = first.colors(eyeShader, lights[l], l, this);
                for (int i = 0; i < first.count; i++) {
                    System.arraycopy(colors, 3 * i, shares[l], 3 * part.index(first.parentNumber[i]), 3);
                }
            }
        }

        /** A level and all that is seen from it; the walk is that of {@code relight.tile.BounceLevels}. */
        private SelectedRows collectLevel(int at, int level, short[] above) {
            SelectedRows selected = new SelectedRows(levels[at], above);
            short[] numbers = selected.numbers();
            for (BounceKind bounce : BounceKind.values()) {
                if (level < depth && bounce.rowCount(levels[at].rows()) > 0) {
                    selected.bounces[bounce.ordinal()] = collectLevel(nextLevel++, level + 1, numbers);
                }
            }
            return selected;
        }
    }

    /** Those rows of a level that are looked at, and what is seen from them. */
    private static final class SelectedRows {
        private final TileLevel level;
        /** What is seen from these rows, by the {@link BounceKind}; null where nothing is followed. */
        private final SelectedRows[] bounces = new SelectedRows[BounceKind.values().length];
        private final int[] row;
        private final int[] material;
        /** The number that each row's parent had. */
        private final short[] parentNumber;
        private int count;

        /** @param numbers of the rows, or pixels, that the level is seen from: those that are looked at; else −1 */
        SelectedRows(TileLevel level, short[] numbers) {
            this.level = level;
            HitRows rows = level.rows();
            int max = 0;
            for (int i = 0; i < rows.count; i++) {
                max += numbers[rows.parent[i]] >= 0 ? 1 : 0;
            }
            row = new int[max];
            material = new int[max];
            parentNumber = new short[max];
            for (int r = 0; r < rows.runCount; r++) {
                for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                    if (numbers[rows.parent[i]] >= 0) {
                        row[count] = i;
                        material[count] = rows.runMaterial[r];
                        parentNumber[count++] = numbers[rows.parent[i]];
                    }
                }
            }
        }

        /** For each row of the level its number here, −1 where it is not looked at. */
        short[] numbers() {
            short[] numbers = new short[level.rows().count];
            Arrays.fill(numbers, (short) -1);
            for (int i = 0; i < count; i++) {
                numbers[row[i]] = (short) i;
            }
            return numbers;
        }

        /** A light's share of the color of each row: red, green, blue. */
        float[] colors(RowContribution equation, WeightedLight light, int layer, LevelWalk levels) {
            float[] mirrored = bounceColors(BounceKind.MIRRORED, layer, levels);
            float[] refracted = bounceColors(BounceKind.REFRACTED, layer, levels);
            float[] colors = new float[3 * count];
            LightLayer rows = level.layers()[equation == levels.eyeShader ? layer : levels.mirrorLayer[layer]];
            for (int i = 0; i < count; i++) {
                equation.color(level.rows(), row[i], material[i], light, rows, mirrored, refracted, 3 * i, colors, 3 * i);
            }
            return colors;
        }

        /** What the rays bring that go on in one way from each row; 0 where none does. */
        private float[] bounceColors(BounceKind bounce, int layer, LevelWalk levels) {
            float[] images = new float[3 * count];
            SelectedRows selected = bounces[bounce.ordinal()];
            if (selected != null && levels.mirrorLights[layer] != null) {
                float[] colors = selected.colors(levels.mirrorShader, levels.mirrorLights[layer], layer, levels);
                for (int i = 0; i < selected.count; i++) {
                    System.arraycopy(colors, 3 * i, images, 3 * selected.parentNumber[i], 3);
                }
            }
            return images;
        }
    }

    /** What the picture shows. */
    public Scene scene() {
        return scene;
    }

    /** Pixels. */
    public int width() {
        return width;
    }

    /** Pixels. */
    public int height() {
        return height;
    }

    /** The picture at these pixels: red, green, blue of each, linear, the top row first. */
    public float[] image() {
        return image.clone();
    }

    /** What the scene's light at a place gives, as {@link #image}. */
    public float[] lightImage(int nodeIndex) {
        return lightImages[nodeIndex].clone();
    }

    /** What several lights give together, likewise. */
    public float[] sumOfLights(int... places) {
        float[] sum = new float[image.length];
        for (int nodeIndex : places) {
            add(lightImages[nodeIndex], sum);
        }
        return sum;
    }

    /** What the environment gives as a light, likewise. */
    public float[] environmentImage() {
        float[] sum = new float[image.length];
        for (int l = scene.lights().size(); l < lightImages.length; l++) {
            add(lightImages[l], sum);
        }
        return sum;
    }

    private static void add(float[] values, float[] to) {
        for (int i = 0; i < to.length; i++) {
            to[i] += values[i];
        }
    }

    /** The mean luminance of some of it, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). */
    public static double brightness(float[] rgb) {
        double sum = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            sum += 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
        }
        return 3 * sum / rgb.length;
    }
}

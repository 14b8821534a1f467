package lightning.render.relight;

import java.util.Arrays;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.image.Film;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.shading.RowShare;
import lightning.render.shading.SampleMean;
import lightning.render.trace.Bounce;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;

/**
 * What each light gives to some of a picture's pixels, those of the picture at a small size, from what is known: no ray is
 * cast, and only the rows of these pixels are looked at, so that all lights together take less than one picture's composing.
 *
 * <p>A pixel is shown by its centre, or by its first sample where all pixels have several. There each value has the bits of
 * {@link Renderer#share} of a picture without anti-aliasing. What is kept of a picture is never written over, so that this may
 * run on any thread beside the renderer.
 */
public final class SmallShares {
    private final Scene scene;
    private final int width;
    private final int height;
    /** Of each light, those of the environment last: red, green, blue of each pixel, the top row first. */
    private final float[][] shares;
    private final float[] picture;

    private SmallShares(Scene scene, int width, int height, int lights) {
        this.scene = scene;
        this.width = width;
        this.height = height;
        shares = new float[lights][3 * width * height];
        picture = new float[3 * width * height];
    }

    /**
     * At a small size, in the shape of the picture.
     *
     * @param maxWidth  pixels, ≥ 1; likewise {@code maxHeight}
     * @throws IllegalStateException if mirror levels are kept as hit shapes
     */
    public static SmallShares of(PixelCache cache, int maxWidth, int maxHeight) {
        int w = cache.scene().picture().width();
        int h = cache.scene().picture().height();
        double shrink = Math.max(1, Math.max((double) w / maxWidth, (double) h / maxHeight));
        return of(cache, places(w, (int) Math.max(1, w / shrink)), places(h, (int) Math.max(1, h / shrink)));
    }

    /** Of one pixel, in column {@code x} from the left and row {@code y} from the top. */
    public static SmallShares pixel(PixelCache cache, int x, int y) {
        return of(cache, new int[] {x}, new int[] {y});
    }

    /** The middles of {@code count} equal parts of a side. */
    private static int[] places(int side, int count) {
        int[] places = new int[count];
        Arrays.setAll(places, i -> (int) ((2L * i + 1) * side / (2L * count)));
        return places;
    }

    private static SmallShares of(PixelCache cache, int[] columns, int[] rows) {
        Luminaire[] top = Luminaire.all(cache.scene());
        var shares = new SmallShares(cache.scene(), columns.length, rows.length, top.length);
        Film film = cache.film();
        for (int i = 0; i < shares.picture.length / 3; i++) {
            int x = columns[i % columns.length];
            int y = rows[i / columns.length];
            shares.picture[3 * i] = film.red(x, y);
            shares.picture[3 * i + 1] = film.green(x, y);
            shares.picture[3 * i + 2] = film.blue(x, y);
        }
        var levels = new Levels(cache, top);
        short[] wanted = new short[Film.TILE_PIXELS];
        int across = Film.tilesAlong(cache.scene().picture().width());
        for (int y0 = 0; y0 < rows.length;) {
            int y1 = end(rows, y0);
            for (int x0 = 0; x0 < columns.length;) {
                int x1 = end(columns, x0);
                Arrays.fill(wanted, (short) -1);
                for (int y = y0; y < y1; y++) {
                    for (int x = x0; x < x1; x++) {
                        // Places of a tile are few enough to be counted in it.
                        wanted[Film.pixelInTile(columns[x], rows[y])] = (short) ((y - y0) * (x1 - x0) + x - x0);
                    }
                }
                var part = new Part(x0, y0, x1 - x0, columns.length);
                shares.take(cache, rows[y0] / Film.TILE * across + columns[x0] / Film.TILE, wanted, part, levels);
                x0 = x1;
            }
            y0 = y1;
        }
        return shares;
    }

    /** Behind the last place that is in the same tile as the one at {@code from}. */
    private static int end(int[] places, int from) {
        int end = from;
        while (end < places.length && places[end] / Film.TILE == places[from] / Film.TILE) {
            end++;
        }
        return end;
    }

    /** Where the pixels of one tile stand among all that are looked at. */
    private record Part(int left, int top, int width, int across) {
        int place(int i) {
            return (top + i / width) * across + left + i % width;
        }
    }

    private void take(PixelCache cache, int index, short[] wanted, Part part, Levels levels) {
        if (cache.tileCount() > 0) {
            levels.pass(cache.tile(index), wanted, part, shares);
            return;
        }
        FineSamples all = cache.fine(index).shapes();
        int perPixel = scene.picture().sampling().perPixel();
        int together = SampleMean.pixelsTogether(perPixel);
        for (int b = 0; b < all.blocks().length; b++) {
            short[] first = new short[Film.TILE_PIXELS];
            Arrays.fill(first, (short) -1);
            for (int i = b * together; i < Math.min(all.pixels().length, (b + 1) * together); i++) {
                first[(i - b * together) * perPixel] = wanted[all.pixels()[i]];
            }
            levels.pass(all.blocks()[b], first, part, shares);
        }
    }

    /** The rows of single pixels, and of all that is seen from there in mirrors and through clear surfaces. */
    private static final class Levels {
        private final Luminaire[] top;
        /** The lights that the mirrors show, each at the place of the light of that name; null where there is none. */
        private final Luminaire[] mirrored;
        /** Where each of these stands among the layers of a mirror level. */
        private final int[] layer;
        private final RowShare eye;
        private final RowShare mirror;
        private final int depth;
        private TileLevel[] levels;
        /** The level to be looked at next. */
        private int next;

        Levels(PixelCache cache, Luminaire[] top) {
            this.top = top;
            depth = cache.scene().picture().depth();
            mirrored = new Luminaire[top.length];
            layer = new int[top.length];
            Luminaire[] known = Luminaire.all(cache.mirroredScene());
            for (int l = 0; l < top.length; l++) {
                for (int m = 0; m < known.length; m++) {
                    if (known[m].light().name().equals(top[l].light().name())) {
                        mirrored[l] = known[m];
                        layer[l] = m;
                    }
                }
            }
            eye = new RowShare(cache.geometry().materials());
            mirror = new RowShare(cache.mirroredGeometry().materials());
        }

        /** @param wanted for each place of the tile its number in the part, or −1 */
        void pass(CachedTile tile, short[] wanted, Part part, float[][] shares) {
            if (!tile.keepsRows()) {
                throw new IllegalStateException("mirror levels are kept as hit shapes");
            }
            levels = tile.levels;
            next = 1;
            Seen first = seen(0, 0, wanted);
            for (int l = 0; l < top.length; l++) {
                float[] colors = first.colors(eye, top[l], l, this);
                for (int i = 0; i < first.count; i++) {
                    System.arraycopy(colors, 3 * i, shares[l], 3 * part.place(first.above[i]), 3);
                }
            }
        }

        /** A level and all that is seen from it; the walk is that of {@code relight.tile.LowerLevels}. */
        private Seen seen(int at, int of, short[] above) {
            Seen seen = new Seen(levels[at], above);
            short[] numbers = seen.numbers();
            for (Bounce bounce : Bounce.values()) {
                if (of < depth && bounce.rows(levels[at].rows()) > 0) {
                    seen.behind[bounce.ordinal()] = seen(next++, of + 1, numbers);
                }
            }
            return seen;
        }
    }

    /** Those rows of a level that are looked at, and what is seen from them. */
    private static final class Seen {
        private final TileLevel level;
        /** What is seen from these rows, by the {@link Bounce}; null where nothing is followed. */
        private final Seen[] behind = new Seen[Bounce.values().length];
        private final int[] row;
        private final int[] material;
        /** The number that each row's parent had. */
        private final short[] above;
        private int count;

        /** @param numbers of the rows, or pixels, that the level is seen from: those that are looked at; else −1 */
        Seen(TileLevel level, short[] numbers) {
            this.level = level;
            HitRows rows = level.rows();
            int most = 0;
            for (int i = 0; i < rows.count; i++) {
                most += numbers[rows.parent[i]] >= 0 ? 1 : 0;
            }
            row = new int[most];
            material = new int[most];
            above = new short[most];
            for (int r = 0; r < rows.runs; r++) {
                for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                    if (numbers[rows.parent[i]] >= 0) {
                        row[count] = i;
                        material[count] = rows.runMaterial[r];
                        above[count++] = numbers[rows.parent[i]];
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

        /** A light's share of the colour of each row: red, green, blue. */
        float[] colors(RowShare equation, Luminaire light, int layer, Levels levels) {
            float[] mirrored = behind(Bounce.MIRRORED, layer, levels);
            float[] refracted = behind(Bounce.REFRACTED, layer, levels);
            float[] colors = new float[3 * count];
            LightLayer rows = level.layers()[equation == levels.eye ? layer : levels.layer[layer]];
            for (int i = 0; i < count; i++) {
                equation.color(level.rows(), row[i], material[i], light, rows, mirrored, refracted, 3 * i, colors, 3 * i);
            }
            return colors;
        }

        /** What the rays bring that go on in one way from each row; 0 where none does. */
        private float[] behind(Bounce bounce, int layer, Levels levels) {
            float[] images = new float[3 * count];
            Seen seen = behind[bounce.ordinal()];
            if (seen != null && levels.mirrored[layer] != null) {
                float[] colors = seen.colors(levels.mirror, levels.mirrored[layer], layer, levels);
                for (int i = 0; i < seen.count; i++) {
                    System.arraycopy(colors, 3 * i, images, 3 * seen.above[i], 3);
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
    public float[] picture() {
        return picture.clone();
    }

    /** What the scene's light at a place gives, as {@link #picture}. */
    public float[] light(int place) {
        return shares[place].clone();
    }

    /** What several lights give together, likewise. */
    public float[] lights(int... places) {
        float[] sum = new float[picture.length];
        for (int place : places) {
            add(shares[place], sum);
        }
        return sum;
    }

    /** What the environment gives as a light, likewise. */
    public float[] environment() {
        float[] sum = new float[picture.length];
        for (int l = scene.lights().size(); l < shares.length; l++) {
            add(shares[l], sum);
        }
        return sum;
    }

    private static void add(float[] what, float[] to) {
        for (int i = 0; i < to.length; i++) {
            to[i] += what[i];
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

package lightning.relight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.cache.CachedTile;
import lightning.cache.PixelCache;
import lightning.image.Film;
import lightning.relight.plan.Accuracy;
import lightning.relight.tile.MirrorStorage;
import lightning.relight.tile.Options;
import lightning.scene.Antialias;
import lightning.scene.Limits;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.work.Progress;

/**
 * How much memory a picture takes, before any work begins: by the formula of docs/architecture.md, where every ray hits and every
 * light falls on everything; and where that is too much, by a small picture of the same scene, which knows what is hit.
 */
public final class MemoryNeed {
    /** The part of the heap that pictures may take: an edit's new columns and the collector need the rest. */
    private static final double SHARE = 0.8;
    /** The longer side of the small picture, pixels. */
    private static final int SMALL = 192;
    private static final double GB = 1e9;
    private static final long COLOR = 3L * Float.BYTES;

    private MemoryNeed() {}

    /**
     * The most bytes that rows, layers, samples and film of a first pass can take.
     *
     * @param scene as the view shows it
     */
    public static long most(Scene scene, Options options) {
        Picture picture = scene.picture();
        Sampling sampling = picture.sampling();
        long pixels = padded(picture.width()) * padded(picture.height());
        boolean mirrors = picture.depth() > 0 && scene.materials().stream().anyMatch(m -> !m.reflective().isBlack());
        boolean edges = sampling.antialias() == Antialias.EDGES;
        long light = options.accuracy() == Accuracy.EXACT ? 1 + 3 * Float.BYTES : 1 + 2 * COLOR;
        // Point, normal, direction, place; texel; code.
        long row = 38 + COLOR + (edges ? Integer.BYTES : 0) + light * scene.lights().size();
        long levels = mirrors ? picture.depth() : 0;
        long mirrored = mirrors ? COLOR + levels * (options.storage() == MirrorStorage.FULL_ROWS ? row : Integer.BYTES) : 0;
        long samples = switch (sampling.antialias()) {
            case OFF -> 1;
            case EDGES -> 1L + sampling.perPixel();
            case EVERY -> sampling.perPixel();
        };
        long codes = edges ? 4L * Integer.BYTES : 0;
        return pixels * (samples * (row + mirrored + COLOR) + codes + (sampling.isFine() ? COLOR : 0));
    }

    /** Whole tiles. */
    private static long padded(int side) {
        return (side + Film.TILE - 1L) / Film.TILE * Film.TILE;
    }

    /**
     * The bytes that a first pass will take, from two small pictures. Rows of centres grow with the pixels; samples at edges grow
     * as a power of the picture's side between 1, for edges of shapes are lines, and 2, for those of fine textures fill areas.
     */
    static long expected(Scene scene, Options options) {
        Picture picture = scene.picture();
        int side = Math.max(picture.width(), picture.height());
        if (side <= SMALL) {
            return most(scene, options);
        }
        Small half = Small.of(scene, options, SMALL / 2);
        Small small = Small.of(scene, options, SMALL);
        double power = half.fine == 0 ? 2 : Math.clamp(Math.log((double) small.fine / half.fine) / Math.log(2), 1, 2);
        double more = (double) side / SMALL;
        double film = picture.sampling().isFine() ? (double) COLOR * picture.width() * picture.height() : 0;
        return (long) (more * more * small.centers + Math.pow(more, power) * small.fine + film);
    }

    /** The bytes of a small picture, with those of its colours: pixels' centres and finer samples. */
    private record Small(long centers, long fine) {
        static Small of(Scene scene, Options options, int side) {
            Picture picture = scene.picture();
            double shrink = (double) Math.max(picture.width(), picture.height()) / side;
            Picture small = picture.withSize(Math.max(1, (int) (picture.width() / shrink)), Math.max(1, (int) (picture.height() / shrink)));
            try (Renderer renderer = new Renderer(options)) {
                renderer.render(scene.withPicture(small), Progress.NONE);
                PixelCache cache = renderer.cache();
                long centers = Arrays.stream(cache.tiles()).mapToLong(MemoryNeed::bytes).sum();
                return new Small(centers, cache.all().stream().mapToLong(MemoryNeed::bytes).sum() - centers);
            }
        }
    }

    private static long bytes(CachedTile tile) {
        return tile.bytes() + COLOR * Film.TILE_PIXELS;
    }

    /** The bytes that pictures may take in this Java. */
    public static long available() {
        return (long) (SHARE * Runtime.getRuntime().maxMemory());
    }

    /**
     * Refuses a picture that does not fit.
     *
     * @throws PictureTooLarge if it takes more than {@link #available()}; the message says what would fit
     */
    public static void check(Scene scene, Options options) {
        check(scene, options, available());
    }

    static void check(Scene scene, Options options, long available) {
        if (most(scene, options) <= available) {
            return;
        }
        long need = expected(scene, options);
        if (need > available) {
            throw new PictureTooLarge(String.format(Locale.ROOT, "the picture needs about %.1f GB of memory and may have %.1f GB; %s",
                    need / GB, available / GB, fitting(scene, options, need, available)));
        }
    }

    /** What of it would fit. */
    private static String fitting(Scene scene, Options options, long need, long available) {
        Picture picture = scene.picture();
        List<String> ways = new ArrayList<>();
        double shrink = Math.sqrt((double) available / need);
        if (shrink * Math.min(picture.width(), picture.height()) >= 1) {
            // Samples at edges shrink more slowly than pixels do.
            Picture smaller = picture;
            do {
                smaller = picture.withSize(Math.max(1, (int) (picture.width() * shrink)), Math.max(1, (int) (picture.height() * shrink)));
                shrink *= 0.9;
            } while (smaller.width() > 1 && expected(scene.withPicture(smaller), options) > available);
            ways.add("a size of " + smaller.width() + "x" + smaller.height());
        }
        fewerSamples(scene, options, available, ways);
        if (options.storage() == MirrorStorage.FULL_ROWS && expected(scene, options.withStorage(MirrorStorage.HIT_SHAPES)) <= available) {
            ways.add("mirrors kept as shapes (--storage shapes)");
        }
        return "it would fit with " + String.join(", or with ", ways);
    }

    private static void fewerSamples(Scene scene, Options options, long available, List<String> ways) {
        Picture picture = scene.picture();
        if (!picture.sampling().isFine()) {
            return;
        }
        for (int grid = picture.sampling().grid() - 1; grid >= Limits.MIN_SAMPLES; grid--) {
            if (expected(scene.withPicture(picture.withSampling(new Sampling(picture.sampling().antialias(), grid))), options) <= available) {
                ways.add(grid + "x" + grid + " samples (--samples " + grid + ")");
                return;
            }
        }
        if (expected(scene.withPicture(picture.withSampling(Sampling.DEFAULT)), options) <= available) {
            ways.add("no anti-aliasing (--antialias off)");
        }
    }
}

package lightning.render.relight;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/**
 * What first passes of a scene will take, from small ones: once those are made, any size and any number of samples is
 * arithmetic. Rows of centers grow with the pixels, and samples of every pixel are as many centers. What is kept of a pixel falls
 * with the picture's side: tiles in which something ends, a shape, a texture or a light, have columns that others need not have,
 * and of all tiles their share falls with the side once tiles are smaller than what lies between; before that it falls more slowly,
 * so that two small pictures tell rather too much. Samples at edges grow as a
 * power of the picture's side between 1, for edges of shapes are lines, and 2, for those of fine textures fill areas; and with
 * the samples of a pixel, for which pixels lie on an edge is told by the centers alone.
 */
final class MemoryForecast {
    /** The longer side of the smaller of two pictures, pixels; that of the other is twice as long. */
    private static final int SMALL_SIDE = 192;
    private static final int MIN_SAMPLES = SceneLimits.MIN_SAMPLES * SceneLimits.MIN_SAMPLES;

    private final Scene scene;
    private final RenderOptions options;
    /** Bytes for each pixel's center in a picture of any size, and what that is more where the longer side is one pixel. */
    private final double bytesPerCenter;
    private final double borderBytes;
    /** Bytes of the samples at the small picture's edges, as few for each pixel as there can be. */
    private final double edgeBytes;
    private final double edgeExponent;

    private MemoryForecast(Scene scene, RenderOptions options, SmallRender small, SmallRender twice, double edges, double power) {
        this.scene = scene;
        this.options = options;
        borderBytes = Math.max(0, (small.bytesPerCenter() - twice.bytesPerCenter()) * 2 * SMALL_SIDE);
        bytesPerCenter = twice.bytesPerCenter() - borderBytes / (2 * SMALL_SIDE);
        this.edgeBytes = edges;
        this.edgeExponent = power;
    }

    /** Makes the small pictures: a fraction of a second once the code is warm. */
    static MemoryForecast of(Scene scene, RenderOptions options) {
        boolean edges = scene.picture().sampling().antialias() == AntialiasMode.EDGES;
        SmallRender small = SmallRender.of(scene, options, SMALL_SIDE, edges);
        SmallRender twice = SmallRender.of(scene, options, 2 * SMALL_SIDE, false);
        if (!edges || small.fine == 0) {
            return new MemoryForecast(scene, options, small, twice, 0, 2);
        }
        SmallRender half = SmallRender.of(scene, options, SMALL_SIDE / 2, true);
        double power = half.fine == 0 ? 2 : Math.clamp(Math.log((double) small.fine / half.fine) / Math.log(2), 1, 2);
        return new MemoryForecast(scene, options, small, twice, small.fine, power);
    }

    /**
     * The bytes that a first pass will take.
     *
     * @param picture with the anti-aliasing of the scene that the forecast is of, or with none
     */
    long bytes(PictureSettings picture) {
        SamplingSettings sampling = picture.sampling();
        double pixels = (double) picture.width() * picture.height();
        double film = sampling.isSupersampled() ? pixels * MemoryEstimate.BYTES_PER_COLOR : 0;
        double side = Math.max(picture.width(), picture.height());
        // A picture smaller than the small ones is cheap, whatever it takes.
        double each = bytesPerCenter + borderBytes / Math.max(side, SMALL_SIDE);
        double bytes = film + switch (sampling.antialias()) {
            case OFF -> pixels * each;
            case EVERY -> pixels * each * sampling.samplesPerPixel();
            case EDGES -> pixels * each + Math.pow(side / SMALL_SIDE, edgeExponent) * edgeBytes * sampling.samplesPerPixel() / MIN_SAMPLES;
        };
        return Math.min((long) bytes, MemoryEstimate.upperBound(scene.withPicture(picture), options));
    }

    /** A small picture: its pixels, and the bytes of centers and of finer samples, with those of their colors. */
    private record SmallRender(long pixels, long centers, long fine) {
        static SmallRender of(Scene scene, RenderOptions options, int side, boolean edges) {
            PictureSettings picture = scene.picture();
            double shrink = (double) Math.max(picture.width(), picture.height()) / side;
            SamplingSettings coarse = new SamplingSettings(edges ? AntialiasMode.EDGES : AntialiasMode.OFF, SceneLimits.MIN_SAMPLES);
            PictureSettings small =
                    picture.withSize(Math.max(1, (int) (picture.width() / shrink)), Math.max(1, (int) (picture.height() / shrink)))
                            .withSampling(coarse);
            try (Renderer renderer = new Renderer(options.withMemory(Long.MAX_VALUE))) {
                renderer.render(scene.withPicture(small), Progress.NONE);
                PixelCache cache = renderer.cache();
                long centers = Arrays.stream(cache.tiles()).mapToLong(SmallRender::bytes).sum();
                return new SmallRender((long) small.width() * small.height(), centers,
                        cache.allTiles().stream().mapToLong(SmallRender::bytes).sum() - centers);
            }
        }

        private static long bytes(CachedTile tile) {
            return tile.bytes() + tile.colorBytes();
        }

        double bytesPerCenter() {
            return (double) centers / pixels;
        }
    }
}

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
 * Forecast of a scene's first pass memory, extrapolated from small pictures to any size and number of samples.
 *
 * <p>Rows of centers grow with the pixels, and samples of every pixel count as that many centers. The bytes per pixel decrease with
 * the picture's side. Tiles with an edge of a shape, texture or light have additional columns, and the share of such tiles
 * decreases once tiles are smaller than the regions between edges. Before that it decreases more slowly, so that small pictures
 * overestimate slightly.
 *
 * <p>Edge samples grow as a power of the picture's side: 1 for edges of shapes, which are lines, up to 2 for fine textures, which
 * fill areas. They also grow with the samples per pixel, because the centers alone determine the pixels on an edge.
 */
final class MemoryForecast {
    /** Longer side of the smaller picture, pixels; the other picture is twice as large. */
    private static final int SMALL_SIDE = 192;
    private static final int MIN_SAMPLES = SceneLimits.MIN_SAMPLES * SceneLimits.MIN_SAMPLES;

    private final Scene scene;
    private final RenderOptions options;
    /** Bytes per pixel center in a picture of any size, and the additional bytes per center for a longer side of one pixel. */
    private final double bytesPerCenter;
    private final double borderBytes;
    /** Bytes of edge samples in the small picture, at the minimum number of samples per pixel. */
    private final double edgeBytes;
    private final double edgeExponent;

    private MemoryForecast(Scene scene, RenderOptions options, SmallRender small, SmallRender large, double edges, double power) {
        this.scene = scene;
        this.options = options;
        borderBytes = Math.max(0, (small.bytesPerCenter() - large.bytesPerCenter()) * 2 * SMALL_SIDE);
        bytesPerCenter = large.bytesPerCenter() - borderBytes / (2 * SMALL_SIDE);
        this.edgeBytes = edges;
        this.edgeExponent = power;
    }

    /** Renders the small pictures; takes a fraction of a second once the code is warm. */
    static MemoryForecast of(Scene scene, RenderOptions options) {
        boolean edges = scene.picture().sampling().antialias() == AntialiasMode.EDGES;
        SmallRender small = SmallRender.of(scene, options, SMALL_SIDE, edges);
        SmallRender large = SmallRender.of(scene, options, 2 * SMALL_SIDE, false);
        if (!edges || small.fine == 0) {
            return new MemoryForecast(scene, options, small, large, 0, 2);
        }
        SmallRender half = SmallRender.of(scene, options, SMALL_SIDE / 2, true);
        double power = half.fine == 0 ? 2 : Math.clamp(Math.log((double) small.fine / half.fine) / Math.log(2), 1, 2);
        return new MemoryForecast(scene, options, small, large, small.fine, power);
    }

    /**
     * Returns the bytes of a first pass.
     *
     * @param picture settings with the anti-aliasing of the forecast's scene, or without
     */
    long bytes(PictureSettings picture) {
        SamplingSettings sampling = picture.sampling();
        double pixels = (double) picture.width() * picture.height();
        double film = sampling.isSupersampled() ? pixels * MemoryEstimate.BYTES_PER_COLOR : 0;
        double side = Math.max(picture.width(), picture.height());
        // A picture smaller than the measured ones needs little memory.
        double each = bytesPerCenter + borderBytes / Math.max(side, SMALL_SIDE);
        double bytes = film + switch (sampling.antialias()) {
            case OFF -> pixels * each;
            case EVERY -> pixels * each * sampling.samplesPerPixel();
            case EDGES -> pixels * each + Math.pow(side / SMALL_SIDE, edgeExponent) * edgeBytes * sampling.samplesPerPixel() / MIN_SAMPLES;
        };
        return Math.min((long) bytes, MemoryEstimate.upperBound(scene.withPicture(picture), options));
    }

    /** Small picture: its pixels, and the bytes of centers and of finer samples, colors included. */
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

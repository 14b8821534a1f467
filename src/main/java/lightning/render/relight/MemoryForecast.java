package lightning.render.relight;

import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.gather.ray.PathsTooLargeException;
import lightning.render.relight.tile.FilmMemory;
import lightning.render.trace.SampleCells;
import lightning.scene.AntialiasMode;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.value.SceneLimits;

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
 *
 * <p>The paths of indirect light are forecast on their own ({@link IndirectEstimate}), because samples share them.
 *
 * <p>An editor that renders centers first forecasts in two steps: the centers before the first pass, and their edge samples once
 * the bytes of the centers are known.
 *
 * @param bytesPerCenter     bytes per pixel center in a picture of any size
 * @param filmBytesPerCenter part of these bytes for kept films, which EVERY does not multiply by its samples
 * @param borderBytes        additional bytes per center for a longer side of one pixel
 * @param edgeBytes          bytes of edge samples in the small picture, at the minimum number of samples per pixel
 * @param edgeFilmBytes      bytes of their films: a mean of each pixel's first samples, and the pixel itself
 * @param isUpper            whether it is a forecast by {@link #upperOf}
 */
record MemoryForecast(Scene scene, RenderOptions options, PictureParts parts, double bytesPerCenter, double filmBytesPerCenter,
        double borderBytes, double edgeBytes, double edgeFilmBytes, double edgeExponent, boolean isUpper, IndirectEstimate indirect) {
    /** Longer side of the smaller picture, pixels; the other picture is twice as large. */
    private static final int SMALL_SIDE = 192;
    /** Factor of a tiny picture's bytes that a larger picture hardly exceeds. */
    private static final double TINY_MARGIN = 1.5;
    private static final int MIN_SAMPLES = SceneLimits.MIN_SAMPLES * SceneLimits.MIN_SAMPLES;
    /** Share of the pixels with samples whose first samples differ so much that they need all; rather too large. */
    private static final double REFINED_SHARE = 0.65;

    /** Renders the small pictures; takes a fraction of a second once the code is warm, unless the scene's rays are slow. */
    static MemoryForecast of(Scene scene, RenderOptions options) {
        return of(scene, options, PictureParts.ALL, SmallPictures.UNSEEN);
    }

    /** @throws PathsTooLargeException if not even the paths of the small pictures fit into the memory of the options */
    static MemoryForecast of(Scene scene, RenderOptions options, PictureParts parts, SmallPictures pictures) {
        boolean edges = scene.picture().sampling().antialias() == AntialiasMode.EDGES;
        boolean samples = edges && parts == PictureParts.ALL;
        SmallRender small = SmallRender.of(scene, options, SMALL_SIDE, edges, samples, pictures);
        SmallRender large = SmallRender.of(scene, options, 2 * SMALL_SIDE, edges && !samples, false, pictures);
        double border = Math.max(0, (small.bytesPerCenter() - large.bytesPerCenter()) * 2 * SMALL_SIDE);
        double center = large.bytesPerCenter() - border / (2 * SMALL_SIDE);
        return new MemoryForecast(scene, options, parts, center, large.filmBytesPerCenter(), border, small.fine, small.fineFilms,
                samples ? edgeExponent(scene, options, small, pictures) : 2, false,
                IndirectEstimate.of(small.indirect, large.indirect));
    }

    /**
     * Forecasts from one tiny picture, in a fraction of the time. The result is too large rather than too small.
     *
     * @throws PathsTooLargeException if not even the paths of the tiny picture fit into the memory of the options
     */
    static MemoryForecast upperOf(Scene scene, RenderOptions options, PictureParts parts, SmallPictures pictures) {
        boolean edges = scene.picture().sampling().antialias() == AntialiasMode.EDGES;
        SmallRender tiny = SmallRender.of(scene, options, SMALL_SIDE / 2, edges, edges && parts == PictureParts.ALL, pictures);
        return new MemoryForecast(scene, options, parts, TINY_MARGIN * tiny.bytesPerCenter(),
                TINY_MARGIN * tiny.filmBytesPerCenter(), 0, TINY_MARGIN * 4 * tiny.fine, TINY_MARGIN * 4 * tiny.fineFilms, 2, true,
                IndirectEstimate.upperOf(tiny.indirect, TINY_MARGIN));
    }

    /**
     * Forecasts the edge samples of existing centers.
     *
     * @param centerBytes bytes of these centers
     */
    static MemoryForecast ofSamples(Scene scene, long centerBytes, RenderOptions options, SmallPictures pictures) {
        double center = (double) centerBytes / scene.picture().width() / scene.picture().height();
        SmallRender small = SmallRender.of(scene, options, SMALL_SIDE, true, true, pictures);
        return new MemoryForecast(scene, options, PictureParts.ALL, center, 0, 0, small.fine, small.fineFilms,
                edgeExponent(scene, options, small, pictures),
                false, IndirectEstimate.upperOf(small.indirect, 1));
    }

    /** Forecasts the paths of indirect light alone. */
    static IndirectEstimate indirectOf(Scene scene) {
        return IndirectEstimate.of(smallPaths(scene, SMALL_SIDE), smallPaths(scene, 2 * SMALL_SIDE));
    }

    /** Forecasts the paths of indirect light from one tiny picture; rather too large. */
    static IndirectEstimate upperIndirectOf(Scene scene) {
        return IndirectEstimate.upperOf(smallPaths(scene, SMALL_SIDE / 2), TINY_MARGIN);
    }

    private static IndirectEstimate.Sample smallPaths(Scene scene, int side) {
        return SmallRender.of(scene, RenderOptions.DEFAULT, side, false, false, SmallPictures.UNSEEN).indirect;
    }

    private static double edgeExponent(Scene scene, RenderOptions options, SmallRender small, SmallPictures pictures) {
        if (small.fine == 0) {
            return 2;
        }
        SmallRender half = SmallRender.of(scene, options, SMALL_SIDE / 2, true, true, pictures);
        return half.fine == 0 ? 2 : Math.clamp(Math.log((double) small.fine / half.fine) / Math.log(2), 1, 2);
    }

    /** Returns whether this is a forecast of that scene or of one that adds indirect light, with these options, whatever their memory. */
    boolean isOf(Scene other, RenderOptions otherOptions, PictureParts otherParts) {
        return parts == otherParts && options.equals(otherOptions.withMemory(options.memory()))
                && (scene.equals(other) || GatherSettings.of(other).isEmpty() && scene.withoutIndirect().equals(other));
    }

    /** Returns whether this forecast includes a scene's edge samples, possibly under other lights. */
    boolean servesSamples(Scene other, RenderOptions otherOptions) {
        return parts == PictureParts.ALL && options.equals(otherOptions.withMemory(options.memory())) && scene.hasSameShapes(other)
                && scene.picture().sampling().antialias() == other.picture().sampling().antialias()
                && scene.lights().size() == other.lights().size();
    }

    /**
     * Returns the bytes of a first pass.
     *
     * @param picture settings with the anti-aliasing of the forecast's scene, or without
     */
    long bytes(PictureSettings picture) {
        SamplingSettings sampling = picture.sampling();
        double pixels = (double) picture.width() * picture.height();
        double film = sampling.isSupersampled() && parts == PictureParts.ALL ? pixels * MemoryEstimate.BYTES_PER_COLOR : 0;
        double side = Math.max(picture.width(), picture.height());
        // A picture smaller than the measured ones needs little memory.
        double each = bytesPerCenter + borderBytes / Math.max(side, SMALL_SIDE);
        double bytes = film + switch (sampling.antialias()) {
            case OFF -> pixels * each;
            case EVERY -> pixels * ((each - filmBytesPerCenter) * sampling.samplesPerPixel() + sampleFilms(sampling, 1) * filmsOfEvery());
            case EDGES -> pixels * each + Math.pow(side / SMALL_SIDE, edgeExponent) * (edgeBytes * samplesAtEdges(sampling) / MIN_SAMPLES
                    + edgeFilmBytes / 2 * sampleFilms(sampling, REFINED_SHARE));
        };
        double peak = Math.max(bytes + indirect.bytes(picture), indirect.buildBytes(picture));
        return Math.min((long) peak, MemoryEstimate.upperBound(scene.withPicture(picture), options, parts));
    }

    /** Returns the bytes in {@link #bytes} that indirect light needs besides the weights of rows. */
    long indirectBytes(PictureSettings picture) {
        return Math.min((long) Math.max(indirect.bytes(picture), indirect.buildBytes(picture)), bytes(picture));
    }

    /** Returns the copies of the films of a pixel with samples: of its first ones, of the rest of a share of pixels, and of all. */
    private static double sampleFilms(SamplingSettings sampling, double refinedShare) {
        return 2 + (SampleCells.rest(sampling.grid()).count() > 0 ? refinedShare : 0);
    }

    /** Returns the bytes of the films of a pixel; rather too large if centers do not keep them. */
    private double filmsOfEvery() {
        return filmBytesPerCenter > 0 ? filmBytesPerCenter : FilmMemory.bytesPerPixel(scene);
    }

    /** Returns the mean number of samples of a pixel that has several. */
    private double samplesAtEdges(SamplingSettings sampling) {
        double share = scene.camera().lens().isOpen() ? 1 : REFINED_SHARE;
        return SampleCells.first(sampling.grid()).count() + share * SampleCells.rest(sampling.grid()).count();
    }

    /**
     * Small picture: its pixels, the bytes of centers with colors and films and of these films, of finer samples without films and of their films,
     * and its indirect light.
     */
    private record SmallRender(long pixels, long centers, long centerFilms, long fine, long fineFilms, IndirectEstimate.Sample indirect) {
        /**
         * @param edges   true to detect edges
         * @param samples true to render the samples at these edges
         */
        static SmallRender of(Scene scene, RenderOptions options, int side, boolean edges, boolean samples, SmallPictures pictures) {
            PictureSettings picture = scene.picture();
            double shrink = (double) Math.max(picture.width(), picture.height()) / side;
            SamplingSettings coarse = new SamplingSettings(edges ? AntialiasMode.EDGES : AntialiasMode.OFF, SceneLimits.MIN_SAMPLES);
            PictureSettings small =
                    picture.withSize(Math.max(1, (int) (picture.width() / shrink)), Math.max(1, (int) (picture.height() / shrink)))
                            .withSampling(coarse);
            try (Renderer renderer = Renderer.unchecked(options.withMemory(pathMemory(picture, small, options.memory())))) {
                renderer.setSharedGeometry(pictures.geometry());
                PlannedUpdate plan = renderer.plan(scene.withPicture(small));
                if (samples) {
                    renderer.render(plan, pictures.cancellation());
                } else {
                    renderer.renderCenters(plan, pictures.cancellation());
                }
                pictures.listener().accept(renderer.film());
                PixelCache cache = renderer.cache();
                long centers = cache.centerBytes();
                long fineFilms = cache.sampleFilmBytes();
                return new SmallRender((long) small.width() * small.height(), centers, cache.centerFilmBytes(),
                        cache.bytes() + cache.colorBytes() - centers - cache.indirectBytes() - fineFilms, fineFilms,
                        IndirectEstimate.Sample.of(small, cache.indirect()));
            }
        }

        /** Returns the bytes that paths of the small picture may use: those of the picture, or more if the picture is smaller. */
        private static long pathMemory(PictureSettings picture, PictureSettings small, long memory) {
            double pixels = (double) picture.width() * picture.height();
            return (long) (memory * Math.max(1, small.width() * small.height() / pixels));
        }

        double bytesPerCenter() {
            return (double) centers / pixels;
        }

        double filmBytesPerCenter() {
            return (double) centerFilms / pixels;
        }
    }
}

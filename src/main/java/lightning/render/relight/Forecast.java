package lightning.render.relight;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.Options;
import lightning.scene.Antialias;
import lightning.scene.Limits;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/**
 * What first passes of a scene will take, from small ones: once those are made, any size and any number of samples is
 * arithmetic. Rows of centres grow with the pixels, and samples of every pixel are as many centres. What is kept of a pixel falls
 * with the picture's side: tiles in which something ends, a shape, a texture or a light, have columns that others need not have,
 * and of all tiles their share falls with the side once tiles are smaller than what lies between; before that it falls more slowly,
 * so that two small pictures tell rather too much. Samples at edges grow as a
 * power of the picture's side between 1, for edges of shapes are lines, and 2, for those of fine textures fill areas; and with
 * the samples of a pixel, for which pixels lie on an edge is told by the centres alone.
 */
final class Forecast {
    /** The longer side of the smaller of two pictures, pixels; that of the other is twice as long. */
    private static final int SIDE = 192;
    private static final int FEWEST = Limits.MIN_SAMPLES * Limits.MIN_SAMPLES;

    private final Scene scene;
    private final Options options;
    /** Bytes for each pixel's centre in a picture of any size, and what that is more where the longer side is one pixel. */
    private final double center;
    private final double rim;
    /** Bytes of the samples at the small picture's edges, as few for each pixel as there can be. */
    private final double edges;
    private final double power;

    private Forecast(Scene scene, Options options, Small small, Small twice, double edges, double power) {
        this.scene = scene;
        this.options = options;
        rim = Math.max(0, (small.center() - twice.center()) * 2 * SIDE);
        center = twice.center() - rim / (2 * SIDE);
        this.edges = edges;
        this.power = power;
    }

    /** Makes the small pictures: a fraction of a second once the code is warm. */
    static Forecast of(Scene scene, Options options) {
        boolean edges = scene.picture().sampling().antialias() == Antialias.EDGES;
        Small small = Small.of(scene, options, SIDE, edges);
        Small twice = Small.of(scene, options, 2 * SIDE, false);
        if (!edges || small.fine == 0) {
            return new Forecast(scene, options, small, twice, 0, 2);
        }
        Small half = Small.of(scene, options, SIDE / 2, true);
        double power = half.fine == 0 ? 2 : Math.clamp(Math.log((double) small.fine / half.fine) / Math.log(2), 1, 2);
        return new Forecast(scene, options, small, twice, small.fine, power);
    }

    /**
     * The bytes that a first pass will take.
     *
     * @param picture with the anti-aliasing of the scene that the forecast is of, or with none
     */
    long bytes(Picture picture) {
        Sampling sampling = picture.sampling();
        double pixels = (double) picture.width() * picture.height();
        double film = sampling.isFine() ? pixels * MemoryNeed.COLOR : 0;
        double side = Math.max(picture.width(), picture.height());
        // A picture smaller than the small ones is cheap, whatever it takes.
        double each = center + rim / Math.max(side, SIDE);
        double bytes = film + switch (sampling.antialias()) {
            case OFF -> pixels * each;
            case EVERY -> pixels * each * sampling.perPixel();
            case EDGES -> pixels * each + Math.pow(side / SIDE, power) * edges * sampling.perPixel() / FEWEST;
        };
        return Math.min((long) bytes, MemoryNeed.most(scene.withPicture(picture), options));
    }

    /** A small picture: its pixels, and the bytes of centres and of finer samples, with those of their colours. */
    private record Small(long pixels, long centers, long fine) {
        static Small of(Scene scene, Options options, int side, boolean edges) {
            Picture picture = scene.picture();
            double shrink = (double) Math.max(picture.width(), picture.height()) / side;
            Sampling few = new Sampling(edges ? Antialias.EDGES : Antialias.OFF, Limits.MIN_SAMPLES);
            Picture small = picture.withSize(Math.max(1, (int) (picture.width() / shrink)), Math.max(1, (int) (picture.height() / shrink)))
                    .withSampling(few);
            try (Renderer renderer = new Renderer(options.withMemory(Long.MAX_VALUE))) {
                renderer.render(scene.withPicture(small), Progress.NONE);
                PixelCache cache = renderer.cache();
                long centers = Arrays.stream(cache.tiles()).mapToLong(Small::bytes).sum();
                return new Small((long) small.width() * small.height(), centers,
                        cache.all().stream().mapToLong(Small::bytes).sum() - centers);
            }
        }

        private static long bytes(CachedTile tile) {
            return tile.bytes() + tile.colorBytes();
        }

        double center() {
            return (double) centers / pixels;
        }
    }
}

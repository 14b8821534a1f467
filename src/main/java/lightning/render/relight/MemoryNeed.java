package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.trace.HitRows.Part;
import lightning.render.trace.MeshMemory;
import lightning.scene.Antialias;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/**
 * How much memory a picture takes, before any work begins: by the formula of docs/architecture.md, where every ray hits and every
 * light falls on everything; and where that is too much, by a {@link Forecast}, which knows what is hit.
 */
public final class MemoryNeed {
    /** Bytes of a colour in a film or a row. */
    static final long COLOR = 3L * Float.BYTES;
    /** What a suggested size is shrunk by until it fits: samples at edges shrink more slowly than pixels do. */
    private static final double STEP = 0.9;

    private MemoryNeed() {}

    /**
     * The most bytes that rows, layers, samples and film of a first pass can take.
     *
     * @param scene as the view shows it
     */
    public static long most(Scene scene, Options options) {
        Picture picture = scene.picture();
        Sampling sampling = picture.sampling();
        boolean mirrors = picture.depth() > 0 && scene.materials().stream().anyMatch(Material::bouncesRays);
        boolean clear = mirrors && scene.materials().stream().anyMatch(m -> m.clarity().isClear());
        boolean edges = sampling.antialias() == Antialias.EDGES;
        boolean tinted = scene.materials().stream().anyMatch(m -> m.clarity().tintsLight());
        boolean metallic = scene.materials().stream().anyMatch(Material::isMetallic);
        long lights = scene.rig().actingLights().stream().mapToLong(light -> options.method().bytesPerRow(light, metallic, tinted)).sum();
        long row = Part.HIT.bytesPerRow() + Part.TEXEL.bytesPerRow() + (edges ? Part.CODE.bytesPerRow() : 0)
                + (scene.lights().stream().allMatch(l -> l.illuminates().isAll()) ? 0 : Part.OWNER.bytesPerRow())
                + (clear ? Part.CLEAR.bytesPerRow() : 0) + lights;
        // Of a clear surface two rays go on, and of each of these two again.
        long levels = clear ? (2L << picture.depth()) - 2 : mirrors ? picture.depth() : 0;
        long mirrored =
                mirrors ? (clear ? 2 : 1) * COLOR + levels * (options.storage().keepsRows() ? row : Integer.BYTES) : 0;
        long samples = switch (sampling.antialias()) {
            case OFF -> 1;
            case EDGES -> 1L + sampling.perPixel();
            case EVERY -> sampling.perPixel();
        };
        // Samples keep their colours where errors are bounded.
        long colored = !options.accuracy().isExact() ? samples : sampling.antialias() == Antialias.EVERY ? 0 : 1;
        return pixels(picture)
                * (samples * (row + mirrored) + colored * COLOR + codes(sampling) + (sampling.isFine() ? COLOR : 0));
    }

    /** The bytes that a kept picture takes: columns, colours and film. */
    public static long of(PixelCache cache) {
        Picture picture = cache.scene().picture();
        return cache.bytes() + cache.colorBytes() + (picture.sampling().isFine() ? COLOR * pixels(picture) : 0);
    }

    /**
     * About how many bytes a first pass will take, by small ones: a fraction of a second.
     *
     * @param scene as the view shows it
     */
    public static long forecast(Scene scene, Options options) {
        return Forecast.of(scene, options).bytes(scene.picture());
    }

    /** The pixels of whole tiles. */
    private static long pixels(Picture picture) {
        return padded(picture.width()) * padded(picture.height());
    }

    private static long padded(int side) {
        return (side + Film.TILE - 1L) / Film.TILE * Film.TILE;
    }

    /** What is kept of each pixel to know its edges. */
    private static long codes(Sampling sampling) {
        return sampling.antialias() == Antialias.EDGES ? 4L * Integer.BYTES : 0;
    }

    /**
     * Refuses a picture that does not fit.
     *
     * @param scene as the view shows it
     * @throws PictureTooLarge if its first pass takes more than {@link Options#memory}, less what the scene's meshes and their trees
     *                         take; the message says what would fit
     */
    public static void check(Scene scene, Options options) {
        long memory = options.memory() - MeshMemory.bytes(scene);
        long most = most(scene, options);
        if (most <= memory) {
            return;
        }
        if (memory <= 0) {
            throw new PictureTooLarge(most, memory, List.of());
        }
        Forecast forecast = Forecast.of(scene, options);
        long need = forecast.bytes(scene.picture());
        if (need > memory) {
            List<PictureTooLarge.Way> ways = new ArrayList<>();
            size(scene, forecast, need, memory, ways);
            samples(scene.picture(), forecast, memory, ways);
            Options shapes = options.withStorage(MirrorStorage.SMALLEST);
            if (options.storage().keepsRows() && Forecast.of(scene, shapes).bytes(scene.picture()) <= memory) {
                ways.add(new PictureTooLarge.Way.Shapes());
            }
            throw new PictureTooLarge(need, memory, ways);
        }
    }

    /**
     * Refuses a picture whose film alone does not fit: what a trace that keeps nothing takes.
     *
     * @param memory bytes that it may take
     * @throws PictureTooLarge if it takes more
     */
    public static void checkFilm(Picture picture, long memory) {
        long each = COLOR + codes(picture.sampling());
        long need = pixels(picture) * each;
        if (need > memory) {
            double shrink = Math.sqrt((double) Math.max(memory, 0) / need);
            // Whole tiles, as they are reckoned.
            int width = (int) (picture.width() * shrink) / Film.TILE * Film.TILE;
            int height = (int) (picture.height() * shrink) / Film.TILE * Film.TILE;
            throw new PictureTooLarge(need, memory,
                    Math.min(width, height) < 1 ? List.of() : List.of(new PictureTooLarge.Way.Size(width, height)));
        }
    }

    private static void size(Scene scene, Forecast forecast, long need, long available, List<PictureTooLarge.Way> ways) {
        Picture picture = scene.picture();
        for (double shrink = Math.sqrt((double) Math.max(available, 0) / need); shrink * Math.min(picture.width(), picture.height()) >= 1;
                shrink *= STEP) {
            Picture smaller = picture.withSize((int) (picture.width() * shrink), (int) (picture.height() * shrink));
            if (forecast.bytes(smaller) <= available) {
                ways.add(new PictureTooLarge.Way.Size(smaller.width(), smaller.height()));
                return;
            }
        }
    }

    private static void samples(Picture picture, Forecast forecast, long available, List<PictureTooLarge.Way> ways) {
        if (!picture.sampling().isFine()) {
            return;
        }
        for (int grid = picture.sampling().grid() - 1; grid >= Limits.MIN_SAMPLES; grid--) {
            if (forecast.bytes(picture.withSampling(new Sampling(picture.sampling().antialias(), grid))) <= available) {
                ways.add(new PictureTooLarge.Way.Samples(grid));
                return;
            }
        }
        if (forecast.bytes(picture.withSampling(Sampling.DEFAULT)) <= available) {
            ways.add(new PictureTooLarge.Way.NoAntialias());
        }
    }
}

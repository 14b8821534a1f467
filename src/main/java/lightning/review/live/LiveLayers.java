package lightning.review.live;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.PictureFilms;
import lightning.render.relight.Renderer;
import lightning.review.HalfPlanes;
import lightning.review.LightWeights;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/**
 * Layers of a live page: the light of each light, also of one that is off, and the rest of the picture. The rest is what is missing from the
 * exact picture, so the page shows it in the state of the scene. Immutable.
 *
 * @param base  the scene whose lights the layers are: all are on, none is black
 * @param parts layers of the lights, in the scene's order
 * @param rest  what the parts with the weights of {@code shown} leave of its picture
 * @param shown the scene of the picture
 */
record LiveLayers(Scene base, List<Part> parts, Layer rest, Scene shown) {
    /**
     * An image as a page receives it.
     *
     * @param id hash of the text
     */
    record Layer(String id, byte[] text) {
        static Layer of(short[] halves) {
            byte[] text = HalfPlanes.encode(halves, 3).getBytes(StandardCharsets.US_ASCII);
            try {
                return new Layer(HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text)), text);
            } catch (NoSuchAlgorithmException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    /**
     * Layer of a light.
     *
     * @param halves {@code short[3 * width * height]}: the image as it is after its transfer
     */
    record Part(Contribution light, short[] halves, Layer layer) {}

    /**
     * Returns the layers of a picture.
     *
     * @param before layers of an earlier picture of the scene; those of lights are used again if only intensities, colors and switches differ
     * @throws CancellationException if {@code progress} requested cancellation
     */
    static LiveLayers of(PixelCache cache, RenderOptions options, List<LiveLayers> before, Progress progress) {
        Scene scene = cache.scene();
        for (LiveLayers earlier : before) {
            if (LightWeights.neutral(earlier.base).equals(LightWeights.neutral(scene))) {
                return new LiveLayers(earlier.base, earlier.parts, rest(cache.film(), scene, earlier.base, earlier.parts), scene);
            }
        }
        Scene base = LightWeights.allOn(scene);
        PixelCache lit = base.equals(scene) ? cache : render(cache, base, options, progress);
        List<Part> parts = new ArrayList<>();
        new PictureFilms(lit, options).forEachShining(progress, (light, film) -> {
            short[] halves = HalfPlanes.halves(film.toScanlines());
            parts.add(new Part(light, halves, Layer.of(halves)));
        });
        return new LiveLayers(base, List.copyOf(parts), rest(cache.film(), scene, base, parts), scene);
    }

    private static PixelCache render(PixelCache cache, Scene base, RenderOptions options, Progress progress) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.restore(cache);
            renderer.renderWithSameSamples(base, progress.cancellationOnly());
            return renderer.cache();
        }
    }

    private static Layer rest(Film picture, Scene scene, Scene base, List<Part> parts) {
        float[] rest = picture.toScanlines();
        for (Part part : parts) {
            float[] weight = LightWeights.of(scene, base, part.light());
            short[] halves = part.halves();
            for (int i = 0; i < rest.length; i++) {
                rest[i] -= weight[i % 3] * Float.float16ToFloat(halves[i]);
            }
        }
        return Layer.of(HalfPlanes.halves(rest));
    }
}

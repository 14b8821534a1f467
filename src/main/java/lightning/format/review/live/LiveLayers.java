package lightning.format.review.live;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleUnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.review.HalfPlanes;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.LightFilms;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;

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
    record Part(String light, short[] halves, Layer layer) {}

    /**
     * Returns the layers of a picture.
     *
     * @param before layers of an earlier picture of the scene; those of lights are used again if only intensities, colors and switches differ
     * @throws CancellationException if {@code progress} requested cancellation
     */
    static LiveLayers of(PixelCache cache, RenderOptions options, List<LiveLayers> before, Progress progress) {
        Scene scene = cache.scene();
        for (LiveLayers earlier : before) {
            if (neutral(earlier.base).equals(neutral(scene)) && hasAll(earlier.base, scene)) {
                return new LiveLayers(earlier.base, earlier.parts, rest(cache.film(), scene, earlier.base, earlier.parts), scene);
            }
        }
        Scene base = allOn(scene);
        PixelCache lit = base.equals(scene) ? cache : render(cache, base, options, progress);
        List<Part> parts = new ArrayList<>();
        LightFilms.forEach(lit, options, _ -> true, progress, (name, film) -> {
            short[] halves = HalfPlanes.halves(film.toScanlines());
            parts.add(new Part(name, halves, Layer.of(halves)));
        });
        return new LiveLayers(base, List.copyOf(parts), rest(cache.film(), scene, base, parts), scene);
    }

    private static PixelCache render(PixelCache cache, Scene base, RenderOptions options, Progress progress) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.restore(cache);
            renderer.render(base, progress.cancellationOnly());
            return renderer.cache();
        }
    }

    private static Layer rest(Film picture, Scene scene, Scene base, List<Part> parts) {
        float[] rest = picture.toScanlines();
        for (Part part : parts) {
            float[] weight = weight(scene, base, part.light());
            short[] halves = part.halves();
            for (int i = 0; i < rest.length; i++) {
                rest[i] -= weight[i % 3] * Float.float16ToFloat(halves[i]);
            }
        }
        return Layer.of(HalfPlanes.halves(rest));
    }

    /** Returns the factors of red, green and blue of a light's layer in the picture of a scene, {@code float[3]}. */
    static float[] weight(Scene scene, Scene base, String name) {
        Light light = scene.light(name).orElse(null);
        if (light == null) {
            double share = scene.rig().isEnvironmentActive() ? scene.world().intensity() / base.world().intensity() : 0;
            return new float[] {(float) share, (float) share, (float) share};
        }
        if (!scene.isActive(light)) {
            return new float[3];
        }
        Light from = base.light(name).orElseThrow();
        double share = light.intensity() / from.intensity() * groupIntensity(scene, light) / groupIntensity(base, light);
        Rgb color = light.color();
        return new float[] {(float) (share * color.r() / from.color().r()), (float) (share * color.g() / from.color().g()),
            (float) (share * color.b() / from.color().b())};
    }

    static double groupIntensity(Scene scene, Light light) {
        return scene.rig().lightGroup(light.lightGroup()).map(LightGroup::intensity).orElse(1.0);
    }

    /** Returns whether a light that a scene shows is in the layers, even if it is dark there. */
    private static boolean hasAll(Scene base, Scene scene) {
        return scene.world().lightIntensity() == 0 || base.world().lightIntensity() > 0;
    }

    /** Returns a scene in which all lights shine in all channels. */
    private static Scene allOn(Scene scene) {
        return withLights(scene, intensity -> intensity > 0 ? intensity : 1, false);
    }

    /** Returns a scene without what a page can change. */
    private static Scene neutral(Scene scene) {
        Scene neutral = withLights(scene, _ -> 1, true);
        return neutral.withPicture(neutral.picture().withView(neutral.picture().view().withExposure(0)));
    }

    private static Scene withLights(Scene scene, DoubleUnaryOperator intensity, boolean isWhite) {
        List<Light> lights = scene.lights().stream().map(light -> {
            Rgb color = light.color();
            boolean hasAll = color.r() > 0 && color.g() > 0 && color.b() > 0;
            return light.withOn(true).withSolo(false).withIntensity(intensity.applyAsDouble(light.intensity()))
                    .withColor(hasAll && !isWhite ? color : Rgb.WHITE);
        }).toList();
        Scene changed = scene.withLights(lights);
        for (LightGroup group : scene.rig().lightGroups()) {
            changed = changed.withRig(changed.rig()
                    .with(group.withOn(true).withSolo(false).withIntensity(intensity.applyAsDouble(group.intensity()))));
        }
        return changed.withWorld(changed.world().withSolo(false).withIntensity(intensity.applyAsDouble(scene.world().intensity())));
    }
}

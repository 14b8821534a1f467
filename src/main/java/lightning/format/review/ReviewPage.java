package lightning.format.review;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.concurrent.CancellationException;
import lightning.base.file.AtomicFile;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightFilms;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A page that shows a picture as the sum of its lights, with a fader for each: one HTML file, which needs no server and no network. Its content
 * security policy allows its own script and styles only. Names are data, never markup.
 */
public final class ReviewPage {
    /** Version of the data in pages and in reviews. */
    static final int VERSION = 1;
    /** Layers of a page: graphics hardware has room for at least 256. */
    private static final int MAX_LIGHTS = 255;
    /** Share of the bytes of halves that remains after compression, and the growth by Base64, about. */
    private static final double COMPRESSION = 0.55 * 4 / 3;

    private ReviewPage() {}

    /** Returns the bytes of a page, about. */
    public static long estimatedBytes(Scene scene) {
        long pixels = (long) scene.picture().width() * scene.picture().height();
        return Math.round(COMPRESSION * 6 * pixels * (LightFilms.names(scene).size() + 1));
    }

    /**
     * Writes the page of a picture, atomically.
     *
     * @param title    name of the scene
     * @param cache    cache of a finished picture
     * @param options  options of its render
     * @param view     view transform of its display
     * @param progress counts lights
     * @throws IOException           if the file cannot be written, or there are too many lights; the message is a sentence for the user
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static void write(Path file, String title, PixelCache cache, RenderOptions options, ViewTransform view, Progress progress)
            throws IOException {
        int lights = LightFilms.names(cache.scene()).size();
        if (lights > MAX_LIGHTS) {
            throw new IOException("a review page has room for " + MAX_LIGHTS + " lights that shine, the scene has " + lights);
        }
        byte[] page = page(data(title, cache, options, view, progress), "'none'").getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(file, out -> out.write(page));
    }

    private static ObjectNode data(String title, PixelCache cache, RenderOptions options, ViewTransform view, Progress progress) {
        Scene scene = cache.scene();
        Film picture = cache.film();
        float[] rest = picture.toScanlines();
        JsonMapper json = new JsonMapper();
        ObjectNode data = json.createObjectNode();
        data.put("version", VERSION).put("title", title).put("width", picture.width()).put("height", picture.height());
        data.set("view", ReviewView.json(view));
        ArrayNode lights = data.putArray("lights");
        LightFilms.forEach(cache, options, _ -> true, progress, (name, film) -> {
            float[] part = film.toScanlines();
            for (int i = 0; i < part.length; i++) {
                rest[i] -= part[i];
            }
            ObjectNode light = lights.addObject().put("name", name);
            scene.light(name).ifPresentOrElse(l -> describe(l, light), () -> light.put("intensity", scene.world().intensity()));
            light.put("pixels", HalfPlanes.encode(film));
        });
        data.put("rest", HalfPlanes.encode(Film.ofScanlines(picture.width(), picture.height(), rest)));
        return data;
    }

    private static void describe(Light light, ObjectNode to) {
        Rgb color = light.color();
        to.put("group", light.lightGroup()).put("intensity", light.intensity());
        to.putArray("color").add(color.r()).add(color.g()).add(color.b());
    }

    /** Returns a page that asks its server for a picture, and follows it ({@code live/}). */
    public static String livePage() throws IOException {
        return page(new JsonMapper().createObjectNode().put("live", true).put("version", VERSION), "'self'");
    }

    /** @param connect what the page may connect to, in the words of a content security policy */
    private static String page(ObjectNode data, String connect) throws IOException {
        String style = resource("review.css");
        String script = resource("review.js");
        // A script of data ends at the next tag, so no character of it may begin one.
        String json = new JsonMapper().writeValueAsString(data).replace("<", "\\u003c");
        return resource("review.html").replace("{{style-hash}}", hash(style)).replace("{{script-hash}}", hash(script))
                .replace("{{connect}}", connect)
                .replace("{{style}}", style)
                .replace("{{script}}", script).replace("{{data}}", json);
    }

    private static String hash(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return "sha256-" + Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String resource(String name) throws IOException {
        try (InputStream in = ReviewPage.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the resource " + name + " is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}

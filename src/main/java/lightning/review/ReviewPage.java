package lightning.review;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.file.AtomicFile;
import lightning.base.math.Rgb;
import lightning.base.text.HtmlPage;
import lightning.base.text.Language;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A page that shows pictures as the sums of their lights, with a fader for each light: one HTML file, which needs no server and no network. Its
 * content security policy allows its own script and styles only. Names are data, never markup.
 */
public final class ReviewPage {
    /** Version of the data in pages and in reviews: before 2, all environments had one fader. */
    static final int VERSION = 2;
    private static final String LAYERS = "{{layers}}";
    private static final List<String> SCRIPTS = List.of("page/texts.js", "page/layers.js", "page/state.js", "page/picture.js",
            "page/faders.js", "page/notes.js", "page/compare.js", "page/film.js", "page/save.js", "page/file.js", "page/live.js",
            "page/start.js");

    private ReviewPage() {}

    /**
     * Renders what a page shows and writes it, atomically.
     *
     * @param renderer renders with {@code options}; if it has the picture already, this is not rendered again
     * @param progress counts parts of pictures
     * @throws IOException           if the file cannot be written, or the page has no room; the message is a sentence for the user
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static void write(Path file, ReviewContent content, Renderer renderer, RenderOptions options, Progress progress)
            throws IOException {
        content.check();
        String frame = frame("'none'");
        int at = frame.indexOf(LAYERS);
        AtomicFile.write(file, out -> {
            out.write(frame.substring(0, at).getBytes(StandardCharsets.UTF_8));
            ObjectNode data = data(content);
            ArrayNode pictures = data.putArray("pictures");
            var writer = new PagePictures(renderer, options, new LayerBlocks(out), content.hasThumbnails());
            int count = content.pictures().size();
            var whole = new ProgressPart(progress, 0, 1);
            for (int i = 0; i < count; i++) {
                pictures.add(writer.write(content.pictures().get(i), whole.section(2 * i, 2 * count), whole.section(2 * i + 1, 2 * count)));
            }
            out.write(withData(frame.substring(at + LAYERS.length()), data).getBytes(StandardCharsets.UTF_8));
        });
    }

    private static ObjectNode data(ReviewContent content) {
        ObjectNode data = common(content.language()).put("title", content.title());
        data.set("view", ReviewView.json(content.view()));
        ArrayNode lights = data.putArray("lights");
        Scene base = content.base();
        for (Contribution part : content.lights()) {
            ObjectNode light = lights.addObject().put("name", part.name(base));
            part.light(base).ifPresentOrElse(l -> describe(l, light),
                    () -> light.put("environment", environment(part)).put("intensity", part.values(base).intensity()));
        }
        ArrayNode looks = data.putArray("looks");
        content.pictures().getFirst().looks().forEach(look -> looks.add(look.name()));
        return data;
    }

    /** Returns what an environment is in pages: the world's own, or a dome. */
    public static String environment(Contribution part) {
        return part.equals(Contribution.ENVIRONMENT) ? "world" : "dome";
    }

    private static ObjectNode common(Optional<Language> language) {
        ObjectNode data = new JsonMapper().createObjectNode().put("version", VERSION);
        language.ifPresent(chosen -> data.put("language", chosen.letters()));
        data.set("texts", PageTexts.json());
        return data;
    }

    private static void describe(Light light, ObjectNode to) {
        Rgb color = light.color();
        to.put("group", light.lightGroup()).put("intensity", light.intensity());
        put(to, "color", color);
        putWhite(light, to);
    }

    /** Adds a color: linear red, green and blue. */
    public static void put(ObjectNode to, String name, Rgb color) {
        to.putArray(name).add(color.r()).add(color.g()).add(color.b());
    }

    /** Adds the color of the light if its own color is white: that of its temperature. */
    public static void putWhite(Light light, ObjectNode to) {
        put(to, "white", light.emission().tinted(Rgb.WHITE));
    }

    /** Returns a page that asks its server for a picture, and follows it ({@code live/}). */
    public static String livePage() throws IOException {
        return withData(frame("'self'").replace(LAYERS, ""), common(Optional.empty()).put("live", true));
    }

    /**
     * Returns a page without its data.
     *
     * @param connect what the page may connect to, in the words of a content security policy
     */
    static String frame(String connect) throws IOException {
        return HtmlPage.withoutData(ReviewPage.class, "review.html", "review.css", SCRIPTS).replace("{{connect}}", connect);
    }

    private static String withData(String frame, ObjectNode data) {
        return HtmlPage.withData(frame, new JsonMapper().writeValueAsString(data));
    }
}

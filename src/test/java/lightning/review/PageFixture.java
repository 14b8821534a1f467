package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.sample.Browser;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightGroup;

/** Pages of a small scene, and what a browser shows of them. */
final class PageFixture {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private PageFixture() {}

    /** Returns a scene with a light, and a group of three. */
    static Scene scene() {
        return scene(60, 48);
    }

    static Scene scene(int width, int height) {
        Scene studio = StudioScene.withFourLights(width, height);
        return studio.withRig(studio.rig().addLightGroup(LightGroup.of("soft"))
                .withLights(
                        studio.lights().stream().map(light -> light.name().equals("sun") ? light : light.withLightGroup("soft")).toList()));
    }

    static void write(Path page, ReviewContent content) throws IOException {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            ReviewPage.write(page, content, renderer, OPTIONS, Progress.NONE);
        }
    }

    static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    /** Compares the shown pixels with those of the editor: equal within one step of 8 bits. */
    static void assertShows(Browser browser, Film film, ViewTransform view) {
        assertPixels(browser.pixels(), view.toPixels(film));
    }

    /**
     * Compares pixels: equal within one step of 8 bits.
     *
     * @param shown  red, green and blue of all pixels
     * @param wanted packed pixels
     */
    static void assertPixels(int[] shown, int[] wanted) {
        assertThat(shown).hasSize(3 * wanted.length);
        for (int i = 0; i < wanted.length; i++) {
            for (int c = 0; c < 3; c++) {
                assertThat(shown[3 * i + c]).as("pixel %d, channel %d", i, c).isCloseTo(wanted[i] >> 16 - 8 * c & 0xff, within(1));
            }
        }
    }

    static void setFader(Browser browser, String name, double stops) {
        browser.run("""
                const label = [...document.querySelectorAll(".strip label")].find((l) => l.textContent === arguments[0]);
                const fader = document.getElementById(label.htmlFor);
                fader.value = arguments[1];
                fader.dispatchEvent(new Event("input"));""", name, stops);
    }

    /** Sets a control by its id, as a reader does. */
    static void set(Browser browser, String id, Object value) {
        browser.run("""
                const control = document.getElementById(arguments[0]);
                control.value = arguments[1];
                control.dispatchEvent(new Event("input"));
                control.dispatchEvent(new Event("change"));""", id, value);
    }

    static List<?> texts(Browser browser, String selector) {
        return (List<?>) browser.run("return [...document.querySelectorAll(arguments[0])].map((e) => e.textContent)", selector);
    }
}

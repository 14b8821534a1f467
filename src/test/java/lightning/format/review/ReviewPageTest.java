package lightning.format.review;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.openqa.selenium.By;

/** Review pages in a real browser. */
@Slow
class ReviewPageTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    /** Names that are markup, script, or odd in other ways. */
    private static final List<String> HOSTILE =
            List.of("<script>alert(1)</script>", "</script><h1>x", "\"><img src=x onerror=alert(1)>", "&lt;b&gt;",
                    "{{data}}", "{{script}}", "${7*7}", "`x`", "' onclick='x", "<!--", "-->", "]]>", "javascript:alert(1)", "\u202Eabc",
                    "__proto__",
                    "constructor", "a\u0301", "𝔘𝔫𝔦", "%3Cscript%3E", "\\u003cb\\u003e");

    @TempDir
    private Path folder;

    private static Scene scene() {
        Scene studio = StudioScene.withFourLights(60, 48);
        return studio.withRig(studio.rig().addLightGroup(LightGroup.of("soft"))
                .withLights(
                        studio.lights().stream().map(light -> light.name().equals("sun") ? light : light.withLightGroup("soft")).toList()));
    }

    private Film write(Scene scene, ViewTransform view, Path page) throws IOException {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            ReviewPage.write(page, ReviewContent.of("studio.jen", ReviewPicture.of(scene), view), renderer, OPTIONS, Progress.NONE);
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    private static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    /** Compares the shown pixels with those of the editor: equal within one step of 8 bits. */
    private static void assertShows(Browser browser, Film film, ViewTransform view) {
        int[] shown = browser.pixels();
        int[] wanted = view.toPixels(film);
        assertThat(shown).hasSize(3 * wanted.length);
        for (int i = 0; i < wanted.length; i++) {
            for (int c = 0; c < 3; c++) {
                assertThat(shown[3 * i + c]).as("pixel %d, channel %d", i, c).isCloseTo(wanted[i] >> 16 - 8 * c & 0xff, within(1));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = DisplayCurve.class, names = "FALSE", mode = EnumSource.Mode.EXCLUDE)
    void page_showsThePictureOfTheEditor(DisplayCurve curve) throws IOException {
        Path page = folder.resolve("page.html");
        ViewTransform view = new ViewTransform(0.5, curve);
        Film film = write(scene(), view, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            assertShows(browser, film, view);
            assertThat(browser.messages()).isEmpty();
            assertThat(browser.requests()).allMatch(url -> url.startsWith("file:") || url.startsWith("data:") || url.startsWith("blob:"));
            assertThat(browser.requests().stream().filter(url -> url.startsWith("file:")).distinct().count()).isLessThanOrEqualTo(1);
        }
    }

    @Test
    void faders_moveThePictureAsEditsDo() throws IOException {
        Path page = folder.resolve("page.html");
        Scene scene = scene();
        write(scene, ViewTransform.DEFAULT, page);
        Light sun = scene.light("sun").orElseThrow();
        Light fill = scene.light("fill").orElseThrow();
        LightGroup soft = scene.rig().lightGroup("soft").orElseThrow();
        Scene edited = scene.withLight(sun.withIntensity(2 * sun.intensity())).withLight(fill.withOn(false));
        edited = edited.withRig(edited.rig().with(soft.withIntensity(0.5)));
        try (Browser browser = Browser.open(page, folder, 390, 844)) {
            setFader(browser, "sun", 1);
            setFader(browser, "soft", -1);
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            assertShows(browser, film(edited), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("as-sent")).click();
            assertShows(browser, film(scene), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("as-sent")).click();
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            browser.driver().findElement(By.cssSelector("[aria-label='Solo sun']")).click();
            Scene solo = scene.withLight(sun.withIntensity(2 * sun.intensity()).withSolo(true));
            assertShows(browser, film(solo), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("reset")).click();
            assertShows(browser, film(scene), ViewTransform.DEFAULT);
            assertThat(browser.messages()).isEmpty();
        }
    }

    private static void setFader(Browser browser, String name, double stops) {
        browser.run("""
                const label = [...document.querySelectorAll(".strip label")].find((l) => l.textContent === arguments[0]);
                const fader = document.getElementById(label.htmlFor);
                fader.value = arguments[1];
                fader.dispatchEvent(new Event("input"));""", name, stops);
    }

    @Test
    void savedReview_makesTheSceneThatTheReviewerSaw() throws Exception {
        Path page = folder.resolve("page.html");
        Scene scene = scene();
        write(scene, ViewTransform.DEFAULT, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            setFader(browser, "sun", -1.5);
            setFader(browser, "key", -8);
            browser.run("const e = document.getElementById('exposure'); e.value = 0.5; e.dispatchEvent(new Event('input'));");
            browser.run(
                    "const c = document.querySelector(\"[aria-label='Color of back']\"); c.value = '#ff8040'; c.dispatchEvent(new Event('input'));");
            browser.driver().findElement(By.id("reviewer")).sendKeys("Ada <b>");
            browser.driver().findElement(By.id("add-note")).click();
            browser.driver().findElement(By.cssSelector("#notes textarea")).sendKeys("more rim here");
            browser.driver().findElement(By.id("save")).click();
            Path saved = folder.resolve("review.json");
            for (int i = 0; i < 100 && !Files.exists(saved); i++) {
                Thread.sleep(100);
            }
            Review review = ReviewReader.read(saved);
            assertThat(review.reviewer()).isEqualTo("Ada <b>");
            assertThat(review.notes()).containsExactly(new Review.Note(0.5, 0.5, "more rim here"));
            ReviewedScene reviewed = ReviewedScene.of(scene, review);
            assertThat(reviewed.notes()).isEmpty();
            assertThat(reviewed.scene().light("key").orElseThrow().on()).isFalse();
            assertThat(reviewed.scene().picture().view().exposure()).isCloseTo(0.5, within(1e-9));
            assertShows(browser, film(reviewed.scene()), new ViewTransform(0.5));
        }
    }

    @Test
    void hostileNames_areText() throws IOException {
        Path page = folder.resolve("page.html");
        Scene studio = StudioScene.withFourLights(8, 6);
        Light sun = studio.light("sun").orElseThrow();
        List<Light> lights = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (String name : HOSTILE) {
            try {
                lights.add(sun.withName(name));
                names.add(name);
            } catch (IllegalArgumentException e) {
                // Scenes do not allow the name.
            }
        }
        assertThat(names).hasSizeGreaterThan(10);
        write(studio.withLights(lights), ViewTransform.DEFAULT, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            Object shown = browser.run("return [...document.querySelectorAll('.strip label')].map((l) => l.textContent)");
            assertThat((List<?>) shown)
                    .isEqualTo(java.util.stream.Stream.concat(java.util.stream.Stream.of("Exposure"), names.stream()).toList());
            assertThat((Object) browser.run("return document.querySelectorAll('img, h1 + h1, script:not([type])').length")).isEqualTo(1L);
            assertThat(browser.messages()).isEmpty();
        }
    }

    @Test
    void page_worksWithTheKeyboard() throws IOException {
        Path page = folder.resolve("page.html");
        write(scene(), ViewTransform.DEFAULT, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            Object unnamed = browser.run("""
                    return [...document.querySelectorAll("button, input, textarea")]
                      .filter((e) => !(e.labels && e.labels.length) && !e.getAttribute("aria-label") && !e.textContent.trim()).length""");
            assertThat(unnamed).isEqualTo(0L);
            browser.run("document.querySelector('#lights input[type=range]').focus()");
            org.openqa.selenium.WebElement fader = browser.driver().switchTo().activeElement();
            fader.sendKeys(org.openqa.selenium.Keys.ARROW_RIGHT);
            assertThat((Object) browser.run("return document.activeElement.value")).isEqualTo("0.05");
        }
    }
}

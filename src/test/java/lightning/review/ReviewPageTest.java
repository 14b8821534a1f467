package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.Browser;
import lightning.sample.JenScenes;
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
    /** Names that are markup, script, or odd in other ways. */
    private static final List<String> HOSTILE =
            List.of("<script>alert(1)</script>", "</script><h1>x", "\"><img src=x onerror=alert(1)>", "&lt;b&gt;",
                    "{{data}}", "{{script}}", "${7*7}", "`x`", "' onclick='x", "<!--", "-->", "]]>", "javascript:alert(1)", "\u202Eabc",
                    "__proto__",
                    "constructor", "a\u0301", "𝔘𝔫𝔦", "%3Cscript%3E", "\\u003cb\\u003e");

    @TempDir
    private Path folder;

    private static Film write(Scene scene, ViewTransform view, Path page) throws IOException {
        PageFixture.write(page, ReviewContent.of("studio.jen", ReviewPicture.of(scene), view));
        return PageFixture.film(scene);
    }

    @ParameterizedTest
    @EnumSource(value = DisplayCurve.class, names = "FALSE", mode = EnumSource.Mode.EXCLUDE)
    void page_showsThePictureOfTheEditor(DisplayCurve curve) throws IOException {
        Path page = folder.resolve("page.html");
        ViewTransform view = new ViewTransform(0.5, curve);
        Film film = write(PageFixture.scene(), view, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            PageFixture.assertShows(browser, film, view);
            assertThat(browser.messages()).isEmpty();
            List<String> requests = browser.requests();
            assertThat(requests).allMatch(url -> url.startsWith("file:") || url.startsWith("data:") || url.startsWith("blob:"));
            assertThat(requests.stream().filter(url -> url.startsWith("file:")).distinct().count()).isLessThanOrEqualTo(1);
        }
    }

    @Test
    void faders_moveThePictureAsEditsDo() throws IOException {
        Path page = folder.resolve("page.html");
        Scene scene = PageFixture.scene();
        write(scene, ViewTransform.DEFAULT, page);
        Light sun = scene.light("sun").orElseThrow();
        Light fill = scene.light("fill").orElseThrow();
        LightGroup soft = scene.rig().lightGroup("soft").orElseThrow();
        Scene edited = scene.withLight(sun.withIntensity(2 * sun.intensity())).withLight(fill.withOn(false));
        edited = edited.withRig(edited.rig().with(soft.withIntensity(0.5)));
        try (Browser browser = Browser.open(page, folder, 390, 844)) {
            PageFixture.setFader(browser, "sun", 1);
            PageFixture.setFader(browser, "soft", -1);
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            PageFixture.assertShows(browser, PageFixture.film(edited), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("as-sent")).click();
            PageFixture.assertShows(browser, PageFixture.film(scene), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("as-sent")).click();
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            browser.driver().findElement(By.cssSelector("[aria-label='Solo sun']")).click();
            Scene solo = scene.withLight(sun.withIntensity(2 * sun.intensity()).withSolo(true));
            PageFixture.assertShows(browser, PageFixture.film(solo), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("reset")).click();
            PageFixture.assertShows(browser, PageFixture.film(scene), ViewTransform.DEFAULT);
            assertThat(browser.messages()).isEmpty();
        }
    }

    @Test
    void savedReview_makesTheSceneThatTheReviewerSaw() throws Exception {
        Path page = folder.resolve("page.html");
        Scene scene = PageFixture.scene();
        write(scene, ViewTransform.DEFAULT, page);
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            PageFixture.setFader(browser, "sun", -1.5);
            PageFixture.setFader(browser, "key", -8);
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
            PageFixture.assertShows(browser, PageFixture.film(reviewed.scene()), new ViewTransform(0.5));
        }
    }

    /** Each environment has a fader, next to that of a light with its name. */
    @Test
    void fadersOfEnvironments_areSaved() throws Exception {
        Path page = folder.resolve("page.html");
        Scene lamp = JenScenes.withSky(PageFixture.scene());
        Scene scene = lamp.renameLight("sun", "environment").withWorld(lamp.world().withNamed(List.of(JenScenes.dome("studio", 2))));
        write(scene, ViewTransform.DEFAULT, page);
        Scene edited =
                scene.withWorld(scene.world().withOwn(own -> own.withIntensity(0.5)).withNamed(List.of(JenScenes.dome("studio", 4))));
        try (Browser browser = Browser.open(page, folder, 1280, 800)) {
            PageFixture.setFader(browser, "environment 2", -1);
            PageFixture.setFader(browser, "studio", 1);
            PageFixture.assertShows(browser, PageFixture.film(edited), ViewTransform.DEFAULT);
            browser.driver().findElement(By.id("save")).click();
            Path saved = folder.resolve("review.json");
            for (int i = 0; i < 100 && !Files.exists(saved); i++) {
                Thread.sleep(100);
            }
            ReviewedScene reviewed = ReviewedScene.of(scene, ReviewReader.read(saved));
            assertThat(reviewed.notes()).isEmpty();
            assertThat(reviewed.scene()).isEqualTo(edited);
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
}

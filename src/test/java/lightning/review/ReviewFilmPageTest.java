package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import lightning.base.text.Language;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.Browser;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;

/** Pages with several frames of a shot in a real browser. */
@Slow
class ReviewFilmPageTest {
    @TempDir
    private Path folder;
    private final Scene scene = PageFixture.scene(192, 160);
    private final Shot shot = shot();
    private Path page;

    /** The sun goes down, and the camera moves. */
    private static Shot shot() {
        return new Shot(1, 9, 24, List.of(
                track(new SceneElement.OfLight("sun"), "intensity", List.of(1.0), List.of(0.2)),
                track(SceneElement.CAMERA, "from", List.of(0.0, 2.0, 7.0), List.of(2.0, 2.0, 6.0))));
    }

    private static Track track(SceneElement<?> target, String attribute, List<Double> first, List<Double> last) {
        return new Track(target, attribute, List.of(new Keyframe(1, new KeyframeValue.Numbers(first), Interpolation.LINEAR),
                new Keyframe(9, new KeyframeValue.Numbers(last), Interpolation.LINEAR)));
    }

    @BeforeEach
    void write() throws IOException {
        page = folder.resolve("page.html");
        List<ReviewPicture> pictures = IntStream.of(1, 5, 9).mapToObj(
                frame -> new ReviewPicture(OptionalInt.of(frame), at(frame), List.of(new ReviewLook("night", night(at(frame)))))).toList();
        PageFixture.write(page, new ReviewContent("shot.jen", scene, pictures, ViewTransform.DEFAULT, Optional.of(Language.ENGLISH)));
    }

    private Scene at(int frame) {
        return shot.sceneAt(scene, frame);
    }

    private static Scene night(Scene of) {
        return of.withLight(of.light("sun").orElseThrow().withOn(false));
    }

    private Browser open() {
        return Browser.open(page, folder, 1280, 800);
    }

    private static void select(Browser browser, int frame) {
        browser.run("document.querySelector(`#frames input[value='${arguments[0]}']`).click()", frame);
        browser.waitFor("return document.getElementById('announcement').textContent === 'Frame " + frame + "'");
    }

    @Test
    void eachFrame_isThatOfTheShot() {
        try (Browser browser = open()) {
            assertThat(PageFixture.texts(browser, "#frames span")).asList().containsExactly("1", "5", "9");
            PageFixture.assertShows(browser, PageFixture.film(at(1)), ViewTransform.DEFAULT);
            select(browser, 9);
            PageFixture.assertShows(browser, PageFixture.film(at(9)), ViewTransform.DEFAULT);
            select(browser, 5);
            PageFixture.assertShows(browser, PageFixture.film(at(5)), ViewTransform.DEFAULT);
            assertThat(browser.messages()).isEmpty();
        }
    }

    @Test
    void faders_applyToAllFrames() {
        try (Browser browser = open()) {
            PageFixture.setFader(browser, "sun", 1);
            select(browser, 5);
            PageFixture.assertShows(browser, PageFixture.film(brighter(at(5))), ViewTransform.DEFAULT);
            PageFixture.set(browser, "side-a", "look-0");
            PageFixture.assertShows(browser, PageFixture.film(night(at(5))), ViewTransform.DEFAULT);
        }
    }

    private static Scene brighter(Scene of) {
        Light sun = of.light("sun").orElseThrow();
        return of.withLight(sun.withIntensity(2 * sun.intensity()));
    }

    @Test
    void thumbnails_followTheFaders() throws InterruptedException {
        try (Browser browser = open()) {
            PageFixture.setFader(browser, "sun", 1);
            Thread.sleep(1000);
            PageFixture.assertPixels(thumbnail(browser, 2), ViewTransform.DEFAULT.toPixels(halved(PageFixture.film(brighter(at(9))))));
            // Thumbnails are painted where the picture is.
            PageFixture.assertShows(browser, PageFixture.film(brighter(at(1))), ViewTransform.DEFAULT);
        }
    }

    private static int[] thumbnail(Browser browser, int index) {
        List<?> values = (List<?>) browser.run("""
                const canvas = document.querySelectorAll("#frames canvas")[arguments[0]];
                const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
                return [...bytes].filter((_, i) => i % 4 < 3);""", index);
        return values.stream().mapToInt(v -> ((Number) v).intValue()).toArray();
    }

    /** Returns the means of 2 × 2 pixels. */
    private static Film halved(Film film) {
        int width = film.width() / 2;
        float[] rgb = new float[3 * width * film.height() / 2];
        float[] from = film.toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            int at = 3 * (i / 3 / width * 2 * film.width() + i / 3 % width * 2) + i % 3;
            rgb[i] = (from[at] + from[at + 3] + from[at + 3 * film.width()] + from[at + 3 * film.width() + 3]) / 4;
        }
        return Film.ofScanlines(width, film.height() / 2, rgb);
    }

    @Test
    void notes_belongToTheirFrame() throws Exception {
        try (Browser browser = open()) {
            select(browser, 9);
            browser.driver().findElement(By.id("add-note")).click();
            browser.driver().findElement(By.cssSelector("#notes textarea")).sendKeys("too dark");
            select(browser, 1);
            assertThat(browser.driver().findElements(By.className("pin"))).isEmpty();
            browser.driver().findElement(By.cssSelector("[aria-label='Show frame 9 of note 1']")).click();
            browser.waitFor("return document.querySelectorAll('.pin').length === 1");
            browser.driver().findElement(By.id("save")).click();
            Path saved = folder.resolve("review.json");
            for (int i = 0; i < 100 && !Files.exists(saved); i++) {
                Thread.sleep(100);
            }
            assertThat(ReviewReader.read(saved).notes()).containsExactly(new Review.Note(OptionalInt.of(9), 0.5, 0.5, "too dark"));
        }
    }

    @Test
    void arrowKey_showsTheNextFrame() {
        try (Browser browser = open()) {
            browser.driver().findElement(By.cssSelector("#frames input")).sendKeys(Keys.ARROW_RIGHT);
            browser.waitFor("return document.getElementById('announcement').textContent === 'Frame 5'");
            PageFixture.assertShows(browser, PageFixture.film(at(5)), ViewTransform.DEFAULT);
        }
    }

    @Test
    void graphicsMemory_hasTheLayersOfOneFrame() {
        try (Browser browser = open()) {
            browser.run("""
                    window.textures = 0;
                    const of = WebGL2RenderingContext.prototype;
                    const create = of.createTexture;
                    const remove = of.deleteTexture;
                    of.createTexture = function() { window.textures++; return create.call(this); };
                    of.deleteTexture = function(texture) { window.textures -= texture ? 1 : 0; return remove.call(this, texture); };""");
            for (int frame : new int[] {9, 5, 1, 9}) {
                select(browser, frame);
            }
            assertThat((Object) browser.run("return window.textures")).isEqualTo(0L);
        }
    }

    @ParameterizedTest
    @CsvSource({"1280,800", "390,844"})
    void page_fitsTheWindow(int width, int height) {
        try (Browser browser = Browser.open(page, folder, width, height)) {
            PageFixture.set(browser, "side-b", "look-0");
            assertThat((Object) browser.run("return document.documentElement.scrollWidth <= innerWidth")).isEqualTo(true);
            assertThat((Object) browser.run("return document.getElementById('picture').getBoundingClientRect().bottom <= innerHeight"))
                    .isEqualTo(true);
        }
    }

    @Test
    void newestChoice_wins() throws InterruptedException {
        try (Browser browser = open()) {
            browser.run(
                    "const all = document.querySelectorAll('#frames input'); all[1].click(); all[2].click(); all[0].click(); all[2].click();");
            Thread.sleep(1500);
            PageFixture.assertShows(browser, PageFixture.film(at(9)), ViewTransform.DEFAULT);
        }
    }
}

package lightning.review.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.URI;
import java.net.URL;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.review.Review;
import lightning.sample.Browser;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;

/** Live pages in a real browser. */
@Slow
class LivePageTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    @TempDir
    private Path folder;
    private final BlockingQueue<LiveChange> changes = new LinkedBlockingQueue<>();
    private final Renderer renderer = new Renderer(OPTIONS);
    private final Scene scene = scene();
    private final Light sun = scene.light("sun").orElseThrow();
    private LiveReview review;
    private ViewTransform view = ViewTransform.DEFAULT;

    private static Scene scene() {
        Scene studio = StudioScene.withFourLights(60, 48);
        return studio.withRig(studio.rig().addLightGroup(LightGroup.of("soft"))
                .withLights(
                        studio.lights().stream().map(light -> light.name().equals("sun") ? light : light.withLightGroup("soft")).toList()));
    }

    @BeforeEach
    void start() throws IOException {
        review = LiveReview.start("studio.jen", LiveAddress.LOCAL, true, changes::add);
    }

    @AfterEach
    void close() {
        review.close();
        renderer.close();
    }

    private Film show(Scene shown) {
        renderer.render(shown, Progress.NONE);
        review.show(shown, "");
        review.show(renderer.cache(), OPTIONS, view);
        return renderer.film();
    }

    private static Film film(Scene of) {
        try (Renderer other = new Renderer(OPTIONS)) {
            other.render(of, Progress.NONE);
            return other.film();
        }
    }

    /** Opens the page when it has a picture: before, the browser reports that it is missing. */
    private Browser open() throws Exception {
        URL picture = URI.create(review.url() + "data").toURL();
        while (((HttpURLConnection) picture.openConnection()).getResponseCode() != HttpURLConnection.HTTP_OK) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        return Browser.open(review.url(), folder, 1280, 800);
    }

    private static int largestDifference(Browser browser, Film film, ViewTransform view) {
        int[] shown = browser.pixels();
        int[] wanted = view.toPixels(film);
        if (shown.length != 3 * wanted.length) {
            return 255;
        }
        int largest = 0;
        for (int i = 0; i < shown.length; i++) {
            largest = Math.max(largest, Math.abs(shown[i] - (wanted[i / 3] >> 16 - 8 * (i % 3) & 0xff)));
        }
        return largest;
    }

    /** Waits until the page shows a film, within one step of 8 bits. */
    private void assertShows(Browser browser, Film film) throws InterruptedException {
        int difference = largestDifference(browser, film, view);
        for (int i = 0; i < 100 && difference > 1; i++) {
            TimeUnit.MILLISECONDS.sleep(50);
            difference = largestDifference(browser, film, view);
        }
        assertThat(difference).isLessThanOrEqualTo(1);
    }

    private static void setFader(Browser browser, String name, double stops) {
        browser.run("""
                const label = [...document.querySelectorAll(".strip label")].find((l) => l.textContent === arguments[0]);
                const fader = document.getElementById(label.htmlFor);
                fader.value = arguments[1];
                fader.dispatchEvent(new Event("input"));""", name, stops);
    }

    private LiveChange change() throws InterruptedException {
        LiveChange change = changes.poll(20, TimeUnit.SECONDS);
        assertThat(change).isNotNull();
        return change;
    }

    @Test
    void page_showsTheExactPicture() throws Exception {
        view = new ViewTransform(0.5, DisplayCurve.FILMIC);
        Scene lit = scene.withPicture(scene.picture().withView(scene.picture().view().withExposure(0.5)));
        Film film = show(lit);
        try (Browser browser = open()) {
            assertShows(browser, film);
            assertThat(browser.messages()).isEmpty();
            assertThat(browser.requests()).allMatch(url -> url.startsWith(review.url()) || url.startsWith("data:"));
        }
    }

    @Test
    void editOfTheArtist_movesThePageAtOnce() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            Scene edited = scene.withLight(sun.withIntensity(2 * sun.intensity()).withColor(new Rgb(1, 0.5, 0.25)))
                    .withLight(scene.light("fill").orElseThrow().withOn(false));
            // Values only: the exact picture is still to come.
            review.show(edited, "");
            assertShows(browser, film(edited));
            assertShows(browser, show(edited));
        }
    }

    @Test
    void lightThatIsOff_canBeSwitchedOnInThePage() throws Exception {
        show(scene.withLight(sun.withOn(false)));
        try (Browser browser = open()) {
            browser.driver().findElement(By.cssSelector("[aria-label='Mute sun']")).click();
            assertShows(browser, film(scene));
            assertThat(change().state().lights()).singleElement().matches(light -> light.name().equals("sun") && !light.mute());
        }
    }

    @Test
    void movedLight_reachesThePage() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            Light key = scene.light("key").orElseThrow();
            assertShows(browser, show(scene.withLight(key.withPosition(key.position().times(0.5)))));
        }
    }

    @Test
    void otherSize_reachesThePage() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            assertShows(browser, show(scene.withPicture(scene.picture().withSize(50, 30))));
        }
    }

    @Test
    void fader_movesTheSceneToWhatThePageShows() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            setFader(browser, "sun", 1);
            Scene edited = change().state().applyTo(scene);
            assertThat(edited.light("sun").orElseThrow().intensity()).isEqualTo(2 * sun.intensity());
            assertThat(edited.light("key")).isEqualTo(scene.light("key"));
            setFader(browser, "soft", -1);
            edited = change().state().applyTo(edited);
            assertThat(edited.rig().lightGroup("soft").orElseThrow().intensity()).isEqualTo(0.5);
            assertShows(browser, film(edited));
            assertShows(browser, show(edited));
            Object stops = browser.run("return [...document.querySelectorAll('.value')].map((o) => o.textContent).join(' ')");
            assertThat((String) stops).contains("+1.00").contains("-1.00");
            browser.driver().findElement(By.id("as-sent")).click();
            assertShows(browser, film(scene));
        }
    }

    @Test
    void notes_arrive() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            browser.driver().findElement(By.id("reviewer")).sendKeys("Ada <b>");
            browser.driver().findElement(By.id("add-note")).click();
            browser.driver().findElement(By.cssSelector("#notes textarea")).sendKeys("more rim here\t");
            LiveChange change = change();
            assertThat(change.reviewer()).isEqualTo("Ada <b>");
            assertThat(change.notes()).containsExactly(new Review.Note(0.5, 0.5, "more rim here"));
        }
    }

    @Test
    void readOnlyPage_keepsItsChangesUntilTheSceneChanges() throws Exception {
        try (LiveReview readOnly = LiveReview.start("studio.jen", LiveAddress.LOCAL, false, changes::add)) {
            renderer.render(scene, Progress.NONE);
            readOnly.show(renderer.cache(), OPTIONS, view);
            try (Browser browser = Browser.open(readOnly.url(), folder, 390, 844)) {
                setFader(browser, "sun", 1);
                Scene local = scene.withLight(sun.withIntensity(2 * sun.intensity()));
                assertShows(browser, film(local));
                Light key = scene.light("key").orElseThrow();
                readOnly.show(scene.withLight(key.withIntensity(0.5 * key.intensity())), "");
                assertShows(browser, film(local.withLight(key.withIntensity(0.5 * key.intensity()))));
                assertThat(changes).isEmpty();
            }
        }
    }

    @Test
    void end_isShown() throws Exception {
        show(scene);
        try (Browser browser = open()) {
            assertThat(review.pages()).isEqualTo(1);
            review.close();
            browser.waitFor("return document.getElementById('mode').textContent.includes('ended')");
        }
    }

    @Test
    void hostileNames_areText() throws Exception {
        Light renamed = sun.withName("<img src=x onerror=alert(1)>");
        show(scene.withLights(List.of(renamed)));
        try (Browser browser = open()) {
            assertThat((Object) browser.run("return document.querySelectorAll('img').length")).isEqualTo(0L);
            setFader(browser, renamed.name(), -2);
            assertThat(change().state().lights().getFirst().name()).isEqualTo(renamed.name());
        }
    }
}

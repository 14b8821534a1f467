package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.Browser;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;

/** Looks on a page in a real browser, and the comparison of two sides. */
@Slow
class ReviewLooksPageTest {
    private static final String HOSTILE = "</script><img src=x onerror=alert(1)>";

    @TempDir
    private Path folder;
    private final Scene scene = PageFixture.scene();
    private final Scene warm = warm();
    private final Scene moved = scene.withLight(light("key").withPosition(new Vec3(-3, 2, 1)));
    private Path page;

    private Light light(String name) {
        return scene.light(name).orElseThrow();
    }

    /** Differs in everything that faders show. */
    private Scene warm() {
        Scene warmer =
                scene.withLight(light("sun").withIntensity(3).withColor(new Rgb(1, 0.4, 0.1))).withLight(light("fill").withOn(false));
        LightGroup soft = scene.rig().lightGroup("soft").orElseThrow();
        return warmer.withRig(warmer.rig().with(soft.withIntensity(0.25).withColor(new Rgb(0.5, 0.8, 1))));
    }

    @BeforeEach
    void write() throws IOException {
        page = folder.resolve("page.html");
        List<ReviewLook> looks = List.of(new ReviewLook("warm", warm), new ReviewLook(HOSTILE, moved));
        PageFixture.write(page,
                ReviewContent.of("studio.jen", new ReviewPicture(OptionalInt.empty(), scene, looks), ViewTransform.DEFAULT));
    }

    private Browser open() {
        return Browser.open(page, folder, 390, 844);
    }

    @Test
    void lookOfFaders_isShownWithoutFurtherPixels() throws IOException {
        // Four lights, the rest, and the picture of the moved light.
        assertThat(Files.readString(page).split("id=\"layer-", -1)).hasSize(4 + 1 + 1 + 1);
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-a", "look-0");
            PageFixture.assertShows(browser, PageFixture.film(warm), ViewTransform.DEFAULT);
            assertThat(browser.messages()).isEmpty();
            assertThat(browser.requests()).allMatch(url -> url.startsWith("file:") || url.startsWith("data:") || url.startsWith("blob:"));
        }
    }

    @Test
    void otherLook_isAFixedPicture() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-a", "look-1");
            PageFixture.assertShows(browser, PageFixture.film(moved), ViewTransform.DEFAULT);
            assertThat(PageFixture.texts(browser, "#side-a option")).asList().containsExactly("Your Light", "As Sent", "warm",
                    HOSTILE + " (fixed picture)");
            assertThat(browser.driver().findElement(By.id("fixed")).isDisplayed()).isTrue();
            assertThat(browser.driver().findElement(By.id("use-look")).isDisplayed()).isFalse();
            assertThat((Object) browser.run("return document.querySelectorAll('img').length")).isEqualTo(0L);
        }
    }

    @Test
    void wipe_showsBothSides() {
        int[] left = ViewTransform.DEFAULT.toPixels(PageFixture.film(scene));
        int[] right = ViewTransform.DEFAULT.toPixels(PageFixture.film(moved));
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-b", "look-1");
            PageFixture.set(browser, "wipe", 25);
            PageFixture.assertPixels(browser.pixels(), joined(left, right, 15));
            browser.driver().findElement(By.tagName("body")).sendKeys("x");
            PageFixture.assertPixels(browser.pixels(), joined(right, left, 15));
        }
    }

    private int[] joined(int[] left, int[] right, int split) {
        int width = scene.picture().width();
        int[] both = new int[left.length];
        for (int i = 0; i < both.length; i++) {
            both[i] = i % width < split ? left[i] : right[i];
        }
        return both;
    }

    @Test
    void letterInAText_doesNotSwap() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-b", "look-1");
            browser.driver().findElement(By.id("reviewer")).sendKeys("Xx");
            assertThat((Object) browser.run("return document.getElementById('side-a').value")).isEqualTo("mine");
            browser.driver().findElement(By.id("swap")).sendKeys(Keys.ENTER);
            assertThat((Object) browser.run("return document.getElementById('side-a').value")).isEqualTo("look-1");
        }
    }

    @Test
    void usedLook_movesTheFaders_andTheyGoOnFromThere() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-a", "look-0");
            browser.driver().findElement(By.id("use-look")).click();
            assertThat((Object) browser.run("return document.getElementById('side-a').value")).isEqualTo("mine");
            PageFixture.assertShows(browser, PageFixture.film(warm), ViewTransform.DEFAULT);
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            PageFixture.assertShows(browser, PageFixture.film(warm.withLight(warm.light("fill").orElseThrow().withOn(true))),
                    ViewTransform.DEFAULT);
        }
    }

    @Test
    void fader_showsTheReadersLightAgain() {
        Film brighter = PageFixture.film(scene.withLight(light("sun").withIntensity(2 * light("sun").intensity())));
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-a", "look-1");
            PageFixture.setFader(browser, "sun", 1);
            PageFixture.assertShows(browser, brighter, ViewTransform.DEFAULT);
        }
    }

    @Test
    void exposure_isOfTheReadersSideOnly() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "exposure", 1);
            PageFixture.assertShows(browser, PageFixture.film(scene), new ViewTransform(1));
            PageFixture.set(browser, "side-a", "look-1");
            PageFixture.assertShows(browser, PageFixture.film(moved), ViewTransform.DEFAULT);
        }
    }
}

package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import lightning.base.text.Language;
import lightning.render.image.ViewTransform;
import lightning.sample.Browser;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;
import org.openqa.selenium.interactions.Actions;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What screen readers and the keyboard get of a page: the accessibility tree of Chromium. */
@Slow
class ReviewPageAccessTest {
    private static final List<String> CONTROLS = List.of("button", "slider", "ColorWell", "textbox", "radio", "combobox", "checkbox");

    @TempDir
    private Path folder;
    private final Scene scene = PageFixture.scene();
    private Path page;

    @BeforeEach
    void write() throws IOException {
        page = folder.resolve("page.html");
        Scene dark = scene.withLight(scene.light("key").orElseThrow().withOn(false));
        var picture = new ReviewPicture(OptionalInt.of(3), scene, List.of(new ReviewLook("dark", dark)));
        var next = new ReviewPicture(OptionalInt.of(4), scene, List.of(new ReviewLook("dark", dark)));
        PageFixture.write(page,
                new ReviewContent("studio.jen", scene, List.of(picture, next), ViewTransform.DEFAULT, Optional.empty()));
    }

    private Browser open() {
        return Browser.open(page, folder, 1280, 800);
    }

    /** A node of the tree. */
    private record Node(String role, String name, JsonNode properties) {
        boolean is(String otherRole, String otherName) {
            return role.equals(otherRole) && name.equals(otherName);
        }
    }

    private static List<Node> tree(Browser browser) {
        Map<String, Object> answer = browser.driver().executeCdpCommand("Accessibility.getFullAXTree", Map.of());
        List<Node> nodes = new ArrayList<>();
        for (JsonNode node : new JsonMapper().valueToTree(answer).get("nodes")) {
            if (!node.path("ignored").asBoolean(false)) {
                nodes.add(new Node(node.at("/role/value").asString(""), node.at("/name/value").asString(""), node.path("properties")));
            }
        }
        return nodes;
    }

    @Test
    void everyControl_hasANameOfItsOwn() {
        try (Browser browser = open()) {
            browser.driver().findElement(By.id("add-note")).click();
            List<Node> controls = tree(browser).stream().filter(node -> CONTROLS.contains(node.role())).toList();
            assertThat(controls).hasSizeGreaterThan(4 * 4 + 3).noneMatch(node -> node.name().isBlank());
            assertThat(controls.stream().map(node -> node.role() + " " + node.name())).doesNotHaveDuplicates();
            for (String light : List.of("sun", "key", "fill", "back")) {
                assertThat(controls).anyMatch(node -> node.is("slider", light)).anyMatch(node -> node.is("button", "Solo " + light))
                        .anyMatch(node -> node.is("button", "Mute " + light)).anyMatch(node -> node.is("ColorWell", "Color of " + light));
            }
        }
    }

    @Test
    void fader_speaksStops() {
        try (Browser browser = open()) {
            PageFixture.setFader(browser, "sun", -1.5);
            PageFixture.setFader(browser, "key", -8);
            // Chromium passes the attribute to screen readers, but its tree of tests has the number.
            assertThat(spoken(browser, "sun")).isEqualTo("by -1.50 stops");
            assertThat(spoken(browser, "key")).isEqualTo("off");
        }
    }

    private static Object spoken(Browser browser, String light) {
        return browser.run("""
                const label = [...document.querySelectorAll(".strip label")].find((l) => l.textContent === arguments[0]);
                return document.getElementById(label.htmlFor).getAttribute("aria-valuetext");""", light);
    }

    @Test
    void picture_isDescribed() {
        try (Browser browser = open()) {
            assertThat(tree(browser)).anyMatch(node -> node.is("image",
                    "Picture of studio.jen, frame 3. Your Light: no light is changed. Click to pin a note."));
            PageFixture.setFader(browser, "sun", 1);
            browser.driver().findElement(By.cssSelector("[aria-label='Mute fill']")).click();
            assertThat(tree(browser)).anyMatch(node -> node.is("image",
                    "Picture of studio.jen, frame 3. Your Light: fill is muted, sun by +1.00 stops. Click to pin a note.")
                    || node.is("image",
                            "Picture of studio.jen, frame 3. Your Light: sun by +1.00 stops, fill is muted. Click to pin a note."));
        }
    }

    @Test
    void notes_areAList() {
        try (Browser browser = open()) {
            browser.driver().findElement(By.id("add-note")).click();
            assertThat(tree(browser)).anyMatch(node -> node.role().equals("list")).anyMatch(node -> node.role().equals("listitem"))
                    .anyMatch(node -> node.is("textbox", "Text of note 1")).anyMatch(node -> node.is("button", "Note 1, frame 3"))
                    .anyMatch(node -> node.is("button", "Delete note 1"));
            browser.driver().findElement(By.cssSelector("[aria-label='Delete note 1']")).click();
            assertThat((Object) browser.run("return document.activeElement.id")).isEqualTo("add-note");
        }
    }

    @Test
    void changes_areAnnouncedPolitely() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-a", "look-0");
            assertThat(browser.driver().findElement(By.id("announcement")).getAttribute("textContent")).isEqualTo("Shows dark");
            List<Node> live = tree(browser).stream().filter(node -> node.role().equals("status")).toList();
            assertThat(live).isNotEmpty().allMatch(node -> property(node, "live").equals("polite"));
            assertThat(tree(browser)).anyMatch(node -> node.role().equals("StaticText") && node.name().equals("Shows dark"));
        }
    }

    private static String property(Node node, String name) {
        for (JsonNode property : node.properties()) {
            if (property.get("name").asString().equals(name)) {
                return property.at("/value/value").asString("");
            }
        }
        return "";
    }

    @Test
    void toggles_haveAState() {
        try (Browser browser = open()) {
            browser.driver().findElement(By.cssSelector("[aria-label='Solo sun']")).click();
            assertThat(tree(browser)).anyMatch(node -> node.is("button", "Solo sun") && property(node, "pressed").equals("true"))
                    .anyMatch(node -> node.is("button", "Solo key") && property(node, "pressed").equals("false"));
        }
    }

    @Test
    void tab_goesThroughAllControlsInTheirOrder() {
        try (Browser browser = open()) {
            PageFixture.set(browser, "side-b", "sent");
            List<String> order = new ArrayList<>();
            browser.run("document.activeElement.blur()");
            String last = "";
            for (int i = 0; i < 60 && !last.equals("add-note"); i++) {
                new Actions(browser.driver()).sendKeys(Keys.TAB).perform();
                last = (String) browser
                        .run("""
                                const e = document.activeElement;
                                return e.getAttribute("aria-label") || e.id.replace(/^fader-.*/, e.labels && e.labels[0] ? e.labels[0].textContent : "");""");
                order.add(last);
            }
            assertThat(order).containsSubsequence("reviewer", "as-sent", "reset", "save", "Frame 3", "side-a", "side-b", "swap", "wipe",
                    "exposure",
                    "sun", "Solo sun", "Mute sun", "Color of sun", "soft", "Solo soft", "Mute soft", "key", "Solo key", "add-note");
        }
    }

    @Test
    void sliderAndShortcut_workWithKeys() {
        try (Browser browser = open()) {
            browser.run("document.querySelector('#lights input[type=range]').focus()");
            browser.driver().switchTo().activeElement().sendKeys(Keys.ARROW_RIGHT);
            assertThat((Object) browser.run("return document.activeElement.value")).isEqualTo("0.05");
        }
    }

    @Test
    void german_isSpokenToo() throws IOException {
        PageFixture.write(page, new ReviewContent("studio.jen", scene, List.of(ReviewPicture.of(scene)), ViewTransform.DEFAULT,
                Optional.of(Language.GERMAN)));
        try (Browser browser = open()) {
            PageFixture.setFader(browser, "sun", 0.5);
            assertThat((Object) browser.run("return document.documentElement.lang")).isEqualTo("de");
            assertThat(tree(browser)).anyMatch(node -> node.is("button", "Farbe von sun") || node.is("ColorWell", "Farbe von sun"))
                    .anyMatch(node -> node.is("button", "Wie gesendet"));
            assertThat(spoken(browser, "sun")).isEqualTo("um +0,50 Blenden");
            assertThat(browser.messages()).isEmpty();
        }
    }
}

package lightning.editor.window.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelReader;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class LiveReviewPaneTest extends EditorFixture {
    private final HttpClient client = HttpClient.newHttpClient();

    @AfterEach
    void close() {
        client.close();
        if (!url().isEmpty()) {
            click("live-run");
        }
    }

    private String url() {
        return robot.lookup("#live-url").tryQuery().map(node -> ((TextField) node).getText()).orElse("");
    }

    private void start(boolean allowsEdits) {
        robot.interact(() -> model().commands().run(Command.LIVE_REVIEW));
        waitFor("the panel is open", () -> robot.lookup("#live-review").tryQuery().isPresent());
        robot.interact(() -> robot.lookup("#live-edits").<CheckBox>query().setSelected(allowsEdits));
        click("live-run");
        waitFor("the review has started", () -> !url().isEmpty());
    }

    private HttpResponse<String> get(String path) {
        return send(HttpRequest.newBuilder(URI.create(url() + path)).build());
    }

    private int post(String lights, String notes) {
        String body = "{\"page\":\"p\",\"reviewer\":\"Ada\",\"lights\":[" + lights + "],\"groups\":[],\"notes\":[" + notes + "]}";
        return send(HttpRequest.newBuilder(URI.create(url() + "change")).POST(HttpRequest.BodyPublishers.ofString(body)).build())
                .statusCode();
    }

    private HttpResponse<String> send(HttpRequest request) {
        try {
            return client.send(request, HttpResponse.BodyHandlers.ofString());
        } catch (java.io.IOException | InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private static String value(Light light, double intensity) {
        return "{\"name\":\"" + light.name() + "\",\"intensity\":" + intensity + ",\"color\":[1,1,1],\"mute\":false,\"solo\":false}";
    }

    @Test
    void page_getsThePictureAndEditsOfTheArtist() {
        start(false);
        waitFor("there is a picture", () -> get("data").statusCode() == 200);
        assertThat(get("data").body()).contains("\"name\":\"lamp\"").contains("\"edits\":false");
        String before = get("data").body();
        Light lamp = light("lamp");
        robot.interact(() -> model().editor().editOrReport(
                scene -> lightning.document.EditOutcome.of(() -> scene.withLight(lamp.withIntensity(3.25 * lamp.intensity())))));
        robot.interact(() -> model().editor().go());
        waitFor("the page has the new value", () -> !get("data").body().equals(before));
        assertThat(get("data").body()).contains("\"intensity\":" + 3.25 * lamp.intensity());
    }

    @Test
    void openInBrowser_opensTheAddress() {
        List<String> opened = new ArrayList<>();
        robot.interact(() -> model().setBrowser(opened::add));
        start(false);
        click("live-open");
        assertThat(opened).containsExactly(url());
        assertThat(robot.lookup("#live-code").<ImageView>query().isVisible()).as("code of an address for this computer only").isFalse();
    }

    /** A code has three squares of seven modules in its corners, and four light modules around it (ISO/IEC 18004). */
    @Test
    void code_hasItsCornersAndABorder() {
        PixelReader pixels = QrImage.of("https://192.168.1.5:8443/abcdef").getPixelReader();
        int side = (int) QrImage.of("https://192.168.1.5:8443/abcdef").getWidth() / 4;
        for (int i = 0; i < side; i++) {
            assertThat(pixels.getArgb(4 * i, 12)).isEqualTo(0xFFFFFFFF);
        }
        for (int[] corner : new int[][] {{4, 4}, {side - 11, 4}, {4, side - 11}}) {
            for (int i = 0; i < 7; i++) {
                assertThat(pixels.getArgb(4 * (corner[0] + i), 4 * corner[1])).isEqualTo(0xFF000000);
                boolean isDark = i != 1 && i != 5;
                assertThat(pixels.getArgb(4 * (corner[0] + i), 4 * (corner[1] + 3))).isEqualTo(isDark ? 0xFF000000 : 0xFFFFFFFF);
            }
        }
    }

    @Test
    void faderOfAPage_isOneEditThatUndoTakesBack() {
        Scene before = model().editor().scene();
        Light lamp = light("lamp");
        start(true);
        assertThat(post(value(lamp, 1.5), "")).isEqualTo(204);
        assertThat(post(value(lamp, 2.5), "")).isEqualTo(204);
        waitFor("the lamp follows", () -> light("lamp").intensity() == 2.5);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void readOnlyReview_keepsTheScene() {
        Scene before = model().editor().scene();
        start(false);
        assertThat(post(value(light("lamp"), 2.5), "")).isEqualTo(403);
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void note_isListed() {
        start(true);
        assertThat(post("", "{\"x\":0.5,\"y\":0.5,\"text\":\"more rim\"}")).isEqualTo(204);
        waitFor("the note is listed", () -> robot.lookup("#live-notes").<ListView<String>>query().getItems().stream()
                .anyMatch(line -> line.startsWith("Ada") && line.endsWith("more rim")));
    }

    @Test
    void addressForOthers_needsACertificate() {
        robot.interact(() -> model().commands().run(Command.LIVE_REVIEW));
        waitFor("the panel is open", () -> robot.lookup("#live-review").tryQuery().isPresent());
        TextField address = robot.lookup("#live-address").query();
        robot.interact(() -> address.setText("0.0.0.0"));
        click("live-run");
        waitFor("the reason is shown", () -> text("live-state").contains("needs a certificate"));
        robot.interact(() -> address.setText(""));
        assertThat(url()).isEmpty();
    }
}

package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import lightning.base.work.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** Live review pages of a server's scenes. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ServedReviewTest {
    private static final String SCENE = "jen 1\npicture { size 8 8 }\nmaterial m {}\nsphere s { material m }\n"
            + "light key point { at 0 3 3 }\nlight fill point { at 3 0 3 }\n";
    private static final String CHANGE = """
            {"page": "p", "reviewer": "Ada", "groups": [], "notes": [{"x": 0.5, "y": 0.25, "text": "more key"}],
             "lights": [{"name": "key", "intensity": 3, "color": [1, 1, 1], "mute": false, "solo": false}]}""";

    private final HttpClient http = HttpClient.newHttpClient();
    private Server server;
    private TestClient client;
    private int scene;

    @BeforeEach
    void start() throws IOException {
        server = new Server(new ServerOptions(2, 500_000_000));
        client = new TestClient(server);
        scene = client.open(SCENE);
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        server.close();
        http.close();
    }

    private JsonNode review(String fields) throws IOException {
        return client.request("review", "'scene':" + scene + fields);
    }

    private HttpResponse<String> get(String url) throws Exception {
        return http.send(HttpRequest.newBuilder(URI.create(url)).build(), HttpResponse.BodyHandlers.ofString());
    }

    private int post(String url, String body) throws Exception {
        return http.send(HttpRequest.newBuilder(URI.create(url + "change")).POST(HttpRequest.BodyPublishers.ofString(body)).build(),
                HttpResponse.BodyHandlers.ofString()).statusCode();
    }

    /** Waits until the exact picture that pages get has a property. */
    private JsonNode picture(String url, Predicate<JsonNode> expected) throws Exception {
        while (true) {
            HttpResponse<String> answer = get(url + "data");
            if (answer.statusCode() == 200 && expected.test(JsonLines.JSON.readTree(answer.body()))) {
                return JsonLines.JSON.readTree(answer.body());
            }
            Thread.sleep(20);
        }
    }

    private static double intensity(JsonNode data) {
        return data.at("/state/lights/0/intensity").asDouble();
    }

    private String key() throws IOException {
        return client.request("get", "'scene':" + scene + ",'properties':'key.intensity'").at("/values/key.intensity").asString();
    }

    @Test
    void page_isOfThisComputerAndShowsTheScene() throws Exception {
        JsonNode review = review("");
        String url = review.get("url").asString();
        assertThat(url).startsWith("http://127.0.0.1:");
        assertThat(get(url).body()).contains("connect-src 'self'");
        assertThat(picture(url, _ -> true).get("lights").size()).isEqualTo(2);
        assertThat(review("").get("url").asString()).isEqualTo(url);
    }

    @Test
    void page_isReadOnlyUnlessAllowed() throws Exception {
        String url = review("").get("url").asString();
        assertThat(post(url, CHANGE)).isEqualTo(403);
        assertThat(key()).isEqualTo("1");
        String other = review(",'allow_edits':true").get("url").asString();
        assertThat(other).isNotEqualTo(url);
        assertThatIOException().isThrownBy(() -> get(url));
    }

    @Test
    void changeOfAPage_isAnEdit() throws Exception {
        String url = review(",'allow_edits':true").get("url").asString();
        assertThat(post(url, CHANGE)).isEqualTo(204);
        assertThat(post(url, CHANGE.replace("\"intensity\": 3", "\"intensity\": 4"))).isEqualTo(204);
        picture(url, data -> intensity(data) == 4);
        assertThat(key()).isEqualTo("4");
        JsonNode review = review(",'allow_edits':true");
        assertThat(review.get("changes").asInt()).isEqualTo(2);
        assertThat(review.get("notes")).hasToString("[{\"reviewer\":\"Ada\",\"x\":0.5,\"y\":0.25,\"text\":\"more key\"}]");
        client.request("undo", "'scene':" + scene);
        assertThat(key()).isEqualTo("1");
        picture(url, data -> intensity(data) == 1);
    }

    @Test
    void askingAgain_keepsThePageAndItsNotes() throws Exception {
        String url = review(",'allow_edits':true").get("url").asString();
        assertThat(post(url, CHANGE)).isEqualTo(204);
        picture(url, data -> intensity(data) == 3);
        JsonNode again = review("");
        assertThat(again.get("url").asString()).isEqualTo(url);
        assertThat(again.get("allow_edits").asBoolean()).isTrue();
        assertThat(again.get("notes").size()).isEqualTo(1);
        assertThat(post(url, CHANGE)).isEqualTo(204);
    }

    @Test
    void pageWithOtherRights_keepsTheNotes() throws Exception {
        String url = review(",'allow_edits':true").get("url").asString();
        assertThat(post(url, CHANGE)).isEqualTo(204);
        picture(url, data -> intensity(data) == 3);
        JsonNode other = review(",'allow_edits':false");
        assertThat(other.get("url").asString()).isNotEqualTo(url);
        assertThat(other.get("changes").asInt()).isEqualTo(1);
        assertThat(other.get("notes").size()).isEqualTo(1);
    }

    @Test
    void editOfAClient_reachesThePageWithoutARender() throws Exception {
        String url = review("").get("url").asString();
        client.request("set", "'scene':" + scene + ",'edits':'key.intensity=2'");
        picture(url, data -> intensity(data) == 2);
        client.request("replace", "'scene':" + scene + ",'text':'" + SCENE.replace("\n", "\\n").replace("size 8 8", "size 9 7") + "'");
        assertThat(picture(url, data -> data.get("width").asInt() == 9).get("height").asInt()).isEqualTo(7);
    }

    @Test
    void match_reachesThePage(@TempDir Path folder) throws Exception {
        Path reference = folder.resolve("reference.pfm");
        client.request("render", "'scene':" + scene + ",'file':'" + reference + "'");
        client.request("set", "'scene':" + scene + ",'edits':'key.intensity=2'");
        String url = review("").get("url").asString();
        assertThat(intensity(picture(url, _ -> true))).isEqualTo(2);
        client.request("match", "'scene':" + scene + ",'reference':'" + reference + "','lights':'key'");
        picture(url, data -> Math.abs(intensity(data) - 1) < 1e-3);
    }

    @Test
    void page_endsWithItsSceneOrBefore() throws Exception {
        String first = review("").get("url").asString();
        assertThat(review(",'end':true").size()).isZero();
        assertThatIOException().isThrownBy(() -> get(first));
        String second = review("").get("url").asString();
        client.request("close", "'scene':" + scene);
        assertThatIOException().isThrownBy(() -> get(second));
    }

    @Test
    void clientThatIsGone_endsThePage() throws Exception {
        String url = review("").get("url").asString();
        client.close();
        while (true) {
            try {
                get(url);
            } catch (IOException e) {
                return;
            }
            Thread.sleep(20);
        }
    }

    @Test
    void wrongFields_areRefused() throws IOException {
        assertThat(client.refused("review", "'scene':" + scene + ",'allow_edits':1").get("place").asString()).isEqualTo("allow_edits");
        assertThat(client.refused("review", "'scene':99").get("code").asString()).isEqualTo("unknown_scene");
    }
}

package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tools.jackson.databind.JsonNode;

/** Coarse pictures, which a client shows until the exact one follows. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class CoarseRequestTest {
    private Server server;
    private TestClient client;

    @BeforeEach
    void start() throws IOException {
        server = new Server(new ServerOptions(2, 900_000_000));
        client = new TestClient(server);
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        server.close();
    }

    private static Scene scene() throws Exception {
        return JenReader.read(ServerTest.SCENE, "text", Path.of("").toAbsolutePath()).scene();
    }

    private static float[] trace(Scene scene, JsonNode size) {
        return ServerTest.trace(scene.withPicture(scene.picture().withSize(size.get(0).asInt(), size.get(1).asInt()))).toScanlines();
    }

    @Test
    void coarsePicture_isThatOfASmallerSize() throws Exception {
        client.open(ServerTest.SCENE);
        JsonNode first = client.request("render", "'scene':1,'memory':true,'coarse':20");
        // About 250 pixels before the speed is known.
        assertThat(first.get("size").toString()).isEqualTo("[18,13]");
        assertThat(first.get("memory").get("shape").toString()).isEqualTo("[13,18,3]");
        assertThat(TestClient.floats(first)).isEqualTo(trace(scene(), first.get("size")));
        JsonNode exact = client.request("render", "'scene':1,'memory':true");
        assertThat(exact.get("plan").asString()).startsWith("full render");
        assertThat(TestClient.floats(exact)).isEqualTo(ServerTest.trace(scene()).toScanlines());
        client.request("set", "'scene':1,'edits':['ball.at=0.5 0 0','camera.from=1 1 -5']");
        Scene edited = PropertyEdit.apply(PropertyEdit.apply(scene(), "ball.at=0.5 0 0"), "camera.from=1 1 -5");
        JsonNode second = client.request("render", "'scene':1,'memory':true,'coarse':20");
        assertThat(TestClient.floats(second)).isEqualTo(trace(edited, second.get("size")));
        // It has a file of its own, so that the exact picture's stays mapped.
        assertThat(TestClient.floats(exact)).isEqualTo(ServerTest.trace(scene()).toScanlines());
        assertThat(client.picture(1, "")).isEqualTo(ServerTest.trace(edited).toScanlines());
    }

    @Test
    void coarsePicture_precedesACanceledExactOne() throws Exception {
        client.open(ServerTest.SCENE.replace("size 70 50", "size 1500 1500"));
        int coarse = client.send("render", "'scene':1,'memory':true,'coarse':1");
        int exact = client.send("render", "'scene':1,'memory':true");
        assertThat(client.answer(coarse).get("result").get("size").size()).isEqualTo(2);
        client.send("cancel", "'request':" + exact);
        int edit = client.send("set", "'scene':1,'edits':'picture.size=70 50'");
        assertThat(client.answer(edit).has("result")).isTrue();
        assertThat(client.others().toString()).contains("\"code\":\"canceled\"");
        assertThat(client.picture(1, "")).isEqualTo(ServerTest.trace(scene()).toScanlines());
    }

    @Test
    void otherFields_areRefused() throws IOException {
        client.open(ServerTest.SCENE);
        for (String field : new String[] {"'region':[0,0,9,9]", "'light':'key'", "'file':'a.png'", "'bits':8", "'layers':true"}) {
            JsonNode error = client.refused("render", "'scene':1,'memory':true,'coarse':20," + field);
            assertThat(error.get("code").asString()).isEqualTo("bad_request");
            assertThat(error.get("message").asString()).contains("whole picture");
        }
        assertThat(client.refused("render", "'scene':1,'coarse':20").get("place").asString()).isEqualTo("memory");
        for (String value : new String[] {"0", "1001", "true", "'fast'", "1.5"}) {
            assertThat(client.refused("render", "'scene':1,'memory':true,'coarse':" + value).get("place").asString()).isEqualTo("coarse");
        }
    }
}

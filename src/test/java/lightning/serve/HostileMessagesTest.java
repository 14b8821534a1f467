package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** Messages that no client should send: each gets one error, and the scene stays as it is. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class HostileMessagesTest {
    @TempDir
    private Path folder;
    private Server server;
    private TestClient client;
    private String text;

    @BeforeEach
    void start() throws IOException {
        server = new Server(new ServerOptions(1, 500_000_000));
        client = new TestClient(server);
        client.open(ServerTest.SCENE);
        client.request("set", "'scene':1,'edits':'key.intensity=0.7'");
        text = client.request("save", "'scene':1").toString();
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        server.close();
    }

    @Test
    void misspelledWords_haveSuggestions() throws IOException {
        assertThat(client.refused("rendr", "'scene':1").get("message").asString()).endsWith(", did you mean 'render'?");
        assertThat(client.refused("render", "'scene':1,'memry':true").get("message").asString()).endsWith(", did you mean 'memory'?");
    }

    private void assertUnchanged() throws IOException {
        assertThat(client.request("save", "'scene':1")).hasToString(text);
        assertThat(client.request("list", "").get("scenes").size()).isEqualTo(1);
        assertThat(client.request("undo", "'scene':1").get("steps").asInt()).isZero();
    }

    private void assertBadMessage() throws IOException {
        JsonNode answer = client.read();
        assertThat(answer.get("id").isNull()).isTrue();
        assertThat(answer.get("error").get("code").asString()).as(answer.toString()).isEqualTo("bad_message");
        assertUnchanged();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"nonsense", "{", "[]", "null", "1", "\"text\"", "{}", "{\"method\":\"list\"}", "{\"id\":null,\"method\":\"list\"}",
                "{\"id\":1.5,\"method\":\"list\"}", "{\"id\":[1],\"method\":\"list\"}", "{\"id\":true,\"method\":\"list\"}",
                "{\"id\":99999999999999999999999,\"method\":\"list\"}", "{\"id\":1e400,\"method\":\"list\"}",
                "{\"id\":5,\"method\":\"undo\",\"scene\":1} {\"id\":6}", "{\"id\":5,\"method\":\"undo\",\"scene\":1,\"scene\":1}",
                "{\"id\":5,\"method\":\"undo\",\"scene\":1,}", "{\"id\":5,'method':\"undo\",\"scene\":1}", "{\"id\":NaN}",
                "\u0000\u0001\u0002", "GET / HTTP/1.1"})
    void lineThatIsNoRequest_isRefused(String line) throws IOException {
        client.sendLine(line);
        assertBadMessage();
    }

    @Test
    void deepNesting_isRefused() throws IOException {
        client.sendLine("{\"id\":5,\"method\":\"undo\",\"scene\":" + "[".repeat(100_000) + "]".repeat(100_000) + "}");
        assertBadMessage();
    }

    @Test
    void longId_isRefused() throws IOException {
        client.sendLine("{\"id\":\"" + "x".repeat(1000) + "\",\"method\":\"list\"}");
        assertBadMessage();
    }

    @Test
    void hugeLine_isSkipped() throws IOException {
        Thread sender = new Thread(() -> {
            try {
                byte[] part = "x".repeat(1 << 20).getBytes(StandardCharsets.US_ASCII);
                for (int i = 0; i < 20; i++) {
                    client.sendBytes(part);
                }
                client.sendLine("");
            } catch (IOException e) {
                throw new java.io.UncheckedIOException(e);
            }
        });
        sender.start();
        assertBadMessage();
    }

    @Test
    void invalidUtf8_isRefused() throws IOException {
        client.sendBytes("{\"id\":5,\"method\":\"und".getBytes(StandardCharsets.US_ASCII));
        client.sendBytes(new byte[] {(byte) 0xC0, (byte) 0x80, (byte) 0xFF, '"', '}', '\n'});
        assertBadMessage();
    }

    @Test
    void randomBytes_getErrorsOnly() throws IOException {
        var random = new Random(1);
        for (int i = 0; i < 200; i++) {
            byte[] line = new byte[1 + random.nextInt(300)];
            random.nextBytes(line);
            for (int b = 0; b < line.length; b++) {
                line[b] = line[b] == '\n' ? 1 : line[b];
            }
            line[0] = 'x';
            client.sendBytes(line);
            client.sendLine("");
            assertThat(client.read().get("error").get("code").asString()).isEqualTo("bad_message");
        }
        assertUnchanged();
    }

    @Test
    void changedBytesOfARequest_neverBreakTheServer() throws IOException {
        var random = new Random(2);
        byte[] request = "{\"id\":7,\"method\":\"set\",\"scene\":1,\"edits\":[\"key.color=1 0 0\"]}".getBytes(StandardCharsets.US_ASCII);
        for (int i = 0; i < 500; i++) {
            byte[] line = request.clone();
            for (int change = random.nextInt(3); change >= 0; change--) {
                int at = random.nextInt(line.length);
                line[at] = (byte) (32 + random.nextInt(200));
            }
            client.sendBytes(line);
            client.sendLine("");
            JsonNode answer = client.read();
            assertThat(answer.has("result") || answer.has("error")).isTrue();
            assertThat(answer.toString()).doesNotContain("internal");
        }
        client.picture(1, "");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "unknown | | method",
        "SET | 'scene':1,'edits':'key.on=no' | method",
        "set | 'edits':'key.on=no' | scene",
        "set | 'scene':'1','edits':'key.on=no' | scene",
        "set | 'scene':1.0,'edits':'key.on=no' | scene",
        "set | 'scene':0,'edits':'key.on=no' | scene",
        "set | 'scene':7,'edits':'key.on=no' | scene",
        "set | 'scene':1 | edits",
        "set | 'scene':1,'edits':[] | edits",
        "set | 'scene':1,'edits':[1] | edits[0]",
        "set | 'scene':1,'edits':['key.on=no',null] | edits[1]",
        "set | 'scene':1,'edits':{'key.on':'no'} | edits",
        "set | 'scene':1,'edits':'key.on=no','more':1 | more",
        "set | 'scene':1,'edits':['key.on=no','key.on'] | edits[1]",
        "set | 'scene':1,'edits':['key.on=no','key.on=perhaps'] | edits[1]",
        "set | 'scene':1,'edits':['key.on=no','key.intensity=1e999'] | edits[1]",
        "set | 'scene':1,'edits':['key.on=no','material:floor.texture=\\'/\\''] | edits[1]",
        "set | 'scene':1,'edits':'key.on=no','gesture':5 | gesture",
        "undo | 'scene':1,'steps':0 | steps",
        "undo | 'scene':1,'steps':'all' | steps",
        "render | 'scene':1,'file':5 | file",
        "render | 'scene':1,'file':'a.gif' | ",
        "render | 'scene':1,'file':'/none/a.png' | ",
        "render | 'scene':1,'file':'a\\u0000b.png' | ",
        "render | 'scene':1,'layers':true | file",
        "render | 'scene':1,'layers':true,'file':'a.png' | layers",
        "render | 'scene':1,'bits':8 | file",
        "render | 'scene':1,'progress':1 | progress",
        "render | 'scene':1,'memory':[] | memory",
        "render | 'scene':1,'memory':'/none/a' | ",
        "explain | 'scene':1,'pixel':5 | pixel",
        "match | 'scene':1 | reference",
        "match | 'scene':1,'reference':'none.png' | ",
        "match | 'scene':1,'reference':'none.png','lights':['none'] | lights[0]",
        "match | 'scene':1,'reference':'none.png','change':['size'] | change",
        "match | 'scene':1,'reference':'none.png','white':'maybe' | white",
        "match | 'scene':1,'reference':'none.png','region':[1,2] | region",
        "explain | 'scene':1,'pixel':[1] | pixel",
        "explain | 'scene':1,'pixel':[1,'2'] | pixel[1]",
        "frame | 'scene':1,'frame':1 | frame",
        "open | | file",
        "open | 'file':'a.jen','text':'jen 1' | file",
        "open | 'file':'none.jen' | ",
        "open | 'file':'scenes' | ",
        "open | 'file':'scenes','keep':'yes' | keep",
        "open | 'file':'/dev/zero' | ",
        "open | 'text':'jen 1 sphere' | text:1:13",
        "close | 'scene':1,'now':true | now",
        "cancel | | request",
        "cancel | 'request':{} | request",
        "save | 'scene':1,'file':'scene.txt' | file",
        "get | 'scene':1,'properties':'key.none' | properties[0]",
        "get | 'scene':1,'properties':'key' | properties[0]"})
    void badField_isNamed_andChangesNothing(String method, String fields, String place) throws IOException {
        JsonNode error = client.refused(method, fields == null ? "" : fields);
        assertThat(error.get("place").asString()).as(error.toString()).isEqualTo(place == null ? "" : place);
        assertThat(error.get("code").asString()).isNotEqualTo("internal");
        assertThat(error.get("message").asString()).isNotEmpty().doesNotContain("\n", "lightning.", "java.");
        assertUnchanged();
    }

    @Test
    void folderOfAPicture_isRefused() throws IOException {
        Path png = folder.resolve("a.png");
        java.nio.file.Files.createDirectory(png);
        assertThat(client.refused("render", "'scene':1,'file':'" + png + "'").get("message").asString()).contains("expected a file");
        assertThat(client.refused("render", "'scene':1,'memory':'" + png + "'").get("code").asString()).isEqualTo("file");
        assertUnchanged();
    }

    @Test
    void idInUse_isRefused() throws IOException {
        client.request("set", "'scene':1,'edits':'picture.size=1000 1000'");
        client.sendLine("{\"id\":\"a\",\"method\":\"render\",\"scene\":1}");
        client.sendLine("{\"id\":\"a\",\"method\":\"render\",\"scene\":1}");
        JsonNode first = client.read();
        assertThat(first.get("id").asString()).isEqualTo("a");
        assertThat(first.get("error").get("place").asString()).isEqualTo("id");
        assertThat(client.read().has("result")).isTrue();
    }

    @Test
    void tooManyScenes_areRefused() throws IOException {
        for (int i = 1; i < Server.MAX_SCENES; i++) {
            client.open(ServerTest.SCENE);
        }
        assertThat(client.refused("open", "'file':'scenes/bird.jen'").get("code").asString()).isEqualTo("limit");
        client.request("close", "'scene':1");
        client.request("open", "'file':'scenes/bird.jen'");
    }

    /** The server stops reading a client that does not read, and goes on with the others. */
    @Test
    void clientThatReadsNothing_stopsNoOther() throws Exception {
        try (TestClient deaf = new TestClient(server)) {
            Thread sender = new Thread(() -> {
                try {
                    while (true) {
                        deaf.sendLine("{\"id\":1,\"method\":\"list\",\"x\":\"" + "y".repeat(1000) + "\"}");
                    }
                } catch (IOException e) {
                    // Closed.
                }
            });
            sender.start();
            Thread.sleep(300);
            assertUnchanged();
        }
    }
}

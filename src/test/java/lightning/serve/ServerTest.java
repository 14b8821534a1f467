package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrReader;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.format.json.PixelReporter;
import lightning.format.json.ReportMapper;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.ContributionScene;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.explanation.PointReport;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ServerTest {
    static final String SCENE = """
            jen 1
            picture { size 70 50 depth 2 }
            camera { from 0 1 -5 to 0 0 0 }
            world { ambience 0.1 background 0.1 0.2 0.3 }
            light key point { at 2 4 -3 intensity 0.8 }
            light fill directional { direction 1 -1 1 intensity 0.3 }
            material floor { diffuse 0.7 0.7 0.6 }
            material mirror { diffuse 0.2 0.2 0.2 reflective 0.6 0.6 0.6 shininess 40 }
            plane ground { at 0 -1 0 material floor }
            sphere ball { at 0 0 0 scale 1 1 1 material mirror }
            """;
    /** Large enough to be canceled. */
    private static final String LARGE = SCENE.replace("size 70 50", "size 1500 1500");
    private static final ServerOptions OPTIONS = new ServerOptions(2, 900_000_000);

    @TempDir
    private Path folder;
    private Server server;
    private TestClient client;

    @BeforeEach
    void start() throws IOException {
        server = new Server(OPTIONS);
        client = new TestClient(server);
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        server.close();
    }

    static Film trace(Scene scene) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
        }
    }

    private static Scene scene() throws Exception {
        return JenReader.read(SCENE, "text", Path.of("").toAbsolutePath()).scene();
    }

    @Test
    void open_describesTheScene() throws IOException {
        JsonNode opened = client.request("open", "'file':'scenes/dusk.jen'");
        assertThat(opened.get("scene").asInt()).isEqualTo(1);
        assertThat(opened.get("lights").toString()).contains("\"sun\"", "\"left light\"");
        assertThat(opened.get("frames").toString()).startsWith("[1,");
        assertThat(opened.get("size").size()).isEqualTo(2);
    }

    @Test
    void render_equalsFullTraceInEveryBit() throws Exception {
        int number = client.open(SCENE);
        assertThat(client.picture(number, "")).isEqualTo(trace(scene()).toScanlines());
        JsonNode set = client.request("set", "'scene':1,'edits':['key.color=1 0.5 0','fill.intensity=0.7']");
        assertThat(set.get("steps").asInt()).isEqualTo(1);
        assertThat(set.get("changed").asBoolean()).isTrue();
        Scene edited = PropertyEdit.apply(PropertyEdit.apply(scene(), "key.color=1 0.5 0"), "fill.intensity=0.7");
        JsonNode result = client.request("render", "'scene':1,'memory':true");
        assertThat(TestClient.floats(result)).isEqualTo(trace(edited).toScanlines());
        assertThat(result.get("plan").asString()).contains("key: weight");
        client.request("undo", "'scene':1");
        assertThat(client.picture(number, "")).isEqualTo(trace(scene()).toScanlines());
        client.request("redo", "'scene':1");
        assertThat(client.picture(number, "")).isEqualTo(trace(edited).toScanlines());
    }

    @Test
    void region_isPartOfThePicture() throws Exception {
        int number = client.open(SCENE);
        float[] all = trace(scene()).toScanlines();
        float[] part = client.picture(number, "'region':[30,10,37,25]");
        assertThat(part).hasSize(37 * 25 * 3);
        for (int y = 0; y < 25; y++) {
            assertThat(Arrays.copyOfRange(part, y * 37 * 3, (y + 1) * 37 * 3))
                    .isEqualTo(Arrays.copyOfRange(all, ((y + 10) * 70 + 30) * 3, ((y + 10) * 70 + 67) * 3));
        }
        Path file = folder.resolve("part.pfm");
        client.request("render", "'scene':1,'region':[69,49,1,1],'file':'" + file + "'");
        assertThat(ImageFile.read(file).toScanlines()).isEqualTo(Arrays.copyOfRange(all, all.length - 3, all.length));
        for (String bad : new String[] {"[0,0,71,1]", "[70,0,1,1]", "[0,0,0,1]", "[0,0,1]", "[0,0,1,2147483647]", "[-1,0,1,1]", "'all'"}) {
            assertThat(client.refused("render", "'scene':1,'region':" + bad).get("place").asString()).startsWith("region");
        }
    }

    @Test
    void file_hasTheBitsOfTheCommand() throws Exception {
        client.open(SCENE);
        Path file = folder.resolve("a.exr");
        JsonNode result = client.request("render", "'scene':1,'bits':32,'file':'" + file + "'");
        assertThat(result.get("file").asString()).isEqualTo(file.toString());
        assertThat(ImageFile.read(file).hasSameBits(trace(scene()))).isTrue();
        client.request("render", "'scene':1,'bits':32,'layers':true,'file':'" + file + "'");
        assertThat(ImageFile.read(file).hasSameBits(trace(scene()))).isTrue();
        assertThat(Files.readString(file, StandardCharsets.ISO_8859_1).contains("key_diffuse.R")).isTrue();
    }

    @Test
    void light_isItsPartOfThePicture() throws Exception {
        client.open(SCENE);
        assertThat(client.picture(1, "'light':'key'")).isEqualTo(trace(ContributionScene.of(scene(), "key")).toScanlines());
        assertThat(client.refused("render", "'scene':1,'light':'no'").get("place").asString()).isEqualTo("light");
    }

    @Test
    void memory_isReusedUntilTheSizeChanges_andRemovedWithTheScene() throws Exception {
        client.open(SCENE);
        JsonNode memory = client.request("render", "'scene':1,'memory':true").get("memory");
        Path path = Path.of(memory.get("path").asString());
        assertThat(Files.size(path)).isEqualTo(memory.get("bytes").asLong()).isEqualTo(70 * 50 * 12);
        assertThat(memory.get("shape").toString()).isEqualTo("[50,70,3]");
        if (Files.getFileStore(path).supportsFileAttributeView("posix")) {
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path))).isEqualTo("rw-------");
        }
        assertThat(client.request("render", "'scene':1,'memory':true").get("memory")).isEqualTo(memory);
        client.request("set", "'scene':1,'edits':'picture.size=40 30'");
        JsonNode smaller = client.request("render", "'scene':1,'memory':true").get("memory");
        assertThat(smaller.get("shape").toString()).isEqualTo("[30,40,3]");
        assertThat(path).doesNotExist();
        client.request("close", "'scene':1");
        assertThat(Path.of(smaller.get("path").asString())).doesNotExist();
    }

    /** All channels have the values of a layered file, and the layers add up to the picture. */
    @Test
    void memoryWithLayers_hasThePlanesOfALayeredFile() throws Exception {
        client.open(SCENE);
        JsonNode result = client.request("render", "'scene':1,'memory':true,'layers':true");
        JsonNode memory = result.get("memory");
        float[] planes = TestClient.floats(result);
        List<String> channels = memory.get("channels").valueStream().map(JsonNode::asString).toList();
        assertThat(memory.get("shape").toString()).isEqualTo("[" + channels.size() + ",50,70]");
        assertThat(channels).contains("R", "key_diffuse.R", "fill_specular.B", "N.X", "P.Z", "Z", "shape.id");
        assertThat(memory.get("lights").get("key_diffuse").asString()).isEqualTo("key");
        assertThat(memory.get("shapes").toString()).isEqualTo("[\"ground\",\"ball\"]");
        Path file = folder.resolve("layers.exr");
        client.request("render", "'scene':1,'layers':true,'bits':32,'file':'" + file + "'");
        try (ExrReader reader = new ExrReader(file)) {
            reader.read(channels, (x, y, values) -> {
                for (int c = 0; c < values.length; c++) {
                    assertThat(planes[(c * 50 + y) * 70 + x]).isEqualTo(values[c]);
                }
            });
        }
        for (String color : List.of("R", "G", "B")) {
            float[] sum = new float[70 * 50];
            memory.get("sum").valueStream().forEach(layer -> {
                int plane = channels.indexOf(layer.asString() + "." + color) * sum.length;
                for (int i = 0; i < sum.length; i++) {
                    sum[i] += planes[plane + i];
                }
            });
            int plane = channels.indexOf(color) * sum.length;
            assertThat(sum).isEqualTo(Arrays.copyOfRange(planes, plane, plane + sum.length));
        }
    }

    @Test
    void describe_followsTheEdits() throws Exception {
        client.open(SCENE);
        client.request("add", "'scene':1,'light':'rim point at=0 3 2'");
        JsonNode described = client.request("describe", "'scene':1");
        assertThat(described.get("lights").toString()).isEqualTo("[\"key\",\"fill\",\"rim\"]");
        assertThat(described.get("steps").asInt()).isEqualTo(1);
    }

    @Test
    void memoryPath_neverReplacesAnotherFile() throws Exception {
        client.open(SCENE);
        Path mine = folder.resolve("picture.rgb");
        assertThat(client.request("render", "'scene':1,'memory':'" + mine + "'").get("memory").get("path").asString())
                .isEqualTo(mine.toString());
        client.request("render", "'scene':1,'memory':'" + mine + "'");
        Path other = Files.writeString(folder.resolve("letter.txt"), "Dear reader");
        JsonNode error = client.refused("render", "'scene':1,'memory':'" + other + "'");
        assertThat(error.get("code").asString()).isEqualTo("file");
        assertThat(error.get("message").asString()).contains("letter.txt: exists already");
        assertThat(other).hasContent("Dear reader");
    }

    @Test
    void failedEdit_changesNothing() throws Exception {
        client.open(SCENE);
        String before = client.request("save", "'scene':1").get("text").asString();
        JsonNode error = client.refused("set", "'scene':1,'edits':['key.intensity=5','kee.color=1 0 0']");
        assertThat(error.get("code").asString()).isEqualTo("bad_edit");
        assertThat(error.get("place").asString()).isEqualTo("edits[1]");
        assertThat(error.get("message").asString()).contains("'kee'", "did you mean 'key'");
        assertThat(client.request("save", "'scene':1").get("text").asString()).isEqualTo(before);
        assertThat(client.request("undo", "'scene':1").get("steps").asInt()).isZero();
    }

    @Test
    void gesture_isOneStep() throws Exception {
        client.open(SCENE);
        for (int i = 1; i <= 5; i++) {
            client.request("set", "'scene':1,'edits':'key.intensity=0." + i + "','gesture':'drag'");
        }
        assertThat(client.request("set", "'scene':1,'edits':'key.on=no'").get("steps").asInt()).isEqualTo(2);
        assertThat(client.request("set", "'scene':1,'edits':'key.intensity=3','gesture':'drag'").get("steps").asInt()).isEqualTo(3);
        client.request("undo", "'scene':1,'steps':3");
        assertThat(client.request("get", "'scene':1,'properties':['key.intensity','key.on','picture.size']").get("values").toString())
                .isEqualTo("{\"key.intensity\":\"0.8\",\"key.on\":\"yes\",\"picture.size\":\"70 50\"}");
    }

    @Test
    void addAndDelete_takeTheEditsOfTheCommandLine() throws Exception {
        client.open(SCENE);
        client.request("add", "'scene':1,'light':'rim spot at=0 3 3 angle=30 intensity=2'");
        client.request("delete", "'scene':1,'light':'key'");
        Scene expected = PropertyEdit.delete(PropertyEdit.add(scene(), "rim spot at=0 3 3 angle=30 intensity=2"), "key");
        assertThat(client.picture(1, "")).isEqualTo(trace(expected).toScanlines());
        assertThat(client.refused("delete", "'scene':1,'light':'key'").get("code").asString()).isEqualTo("bad_edit");
    }

    @Test
    void frames_showKeyframes() throws Exception {
        client.request("open", "'file':'scenes/dusk.jen'");
        client.request("set", "'scene':1,'edits':'picture.size=30 20'");
        float[] first = client.picture(1, "");
        client.request("frame", "'scene':1,'frame':20");
        assertThat(client.picture(1, "")).isNotEqualTo(first);
        client.request("frame", "'scene':1,'frame':1");
        assertThat(client.picture(1, "")).isEqualTo(first);
        assertThat(client.refused("frame", "'scene':1,'frame':0").get("place").asString()).isEqualTo("frame");
    }

    @Test
    void match_isOneStepAndRestoresTheLight() throws Exception {
        client.open(SCENE);
        Path reference = folder.resolve("reference.pfm");
        client.request("render", "'scene':1,'file':'" + reference + "'");
        client.request("set", "'scene':1,'edits':'key.intensity=4'");
        JsonNode result = client.request("match", "'scene':1,'reference':'" + reference + "','lights':'key'");
        assertThat(result.get("steps").asInt()).isEqualTo(2);
        assertThat(result.at("/lights/0/light").asString()).isEqualTo("key");
        double restored =
                Double.parseDouble(client.request("get", "'scene':1,'properties':'key.intensity'").at("/values/key.intensity").asString());
        assertThat(restored).isCloseTo(scene().light("key").orElseThrow().intensity(), within(1e-3));
    }

    @Test
    void explain_hasTheColorOfThePicture() throws Exception {
        client.open(SCENE);
        JsonNode result = client.request("explain", "'scene':1,'pixel':[35,25]");
        Film film = trace(scene());
        assertThat(result.at("/color_linear/0").floatValue()).isEqualTo(film.red(35, 25));
        assertThat(result.at("/color_linear/2").floatValue()).isEqualTo(film.blue(35, 25));
        assertThat(result.at("/center/object").asString()).isEqualTo("ball");
        assertThat(result.at("/center/lights/0/light").asString()).isEqualTo("key");
        assertThat(result.at("/center/reflected/hits").has("color")).isTrue();
        assertThat(client.refused("explain", "'scene':1,'pixel':[70,0]").get("place").asString()).isEqualTo("pixel");
    }

    /** Cutouts: the server's known geometry must report what a new one does. */
    @Test
    void explain_isTheRecordOfTheCommandLine() throws Exception {
        client.request("open", "'file':'scenes/arbor.jen'");
        client.request("set", "'scene':1,'edits':['picture.size=40 30','picture.antialias=off']");
        Scene scene = PropertyEdit.apply(PropertyEdit.apply(JenReader.read(Path.of("scenes/arbor.jen")).scene(), "picture.size=40 30"),
                "picture.antialias=off");
        var explainer = new PixelExplainer(scene);
        PointReport center = explainer.explainPixel(10, 10);
        assertThat(center.passedCutouts()).isNotEmpty();
        assertThat(client.request("explain", "'scene':1,'pixel':[10,10]").toString()).isEqualTo(ReportMapper.MAPPER
                .writeValueAsString(new PixelReporter(scene, explainer).report(10, 10, center, center.color())));
    }

    @Test
    void scenes_areIndependent() throws Exception {
        int first = client.open(SCENE);
        int second = client.open(SCENE.replace("intensity 0.8", "intensity 0.4"));
        float[] before = client.picture(second, "");
        client.request("set", "'scene':" + first + ",'edits':'key.color=0 0 1'");
        assertThat(client.picture(first, "")).isNotEqualTo(before);
        assertThat(client.picture(second, "")).isEqualTo(before);
        assertThat(client.request("list", "").get("scenes").size()).isEqualTo(2);
        client.request("close", "'scene':" + first);
        assertThat(client.refused("render", "'scene':" + first).get("code").asString()).isEqualTo("unknown_scene");
        assertThat(client.picture(second, "")).isEqualTo(before);
    }

    @Test
    void requestsAfterOpen_waitForTheScene() throws Exception {
        client.sendLine("{\"id\":1,\"method\":\"open\",\"file\":\"scenes/bird.jen\"}");
        client.sendLine("{\"id\":2,\"method\":\"set\",\"scene\":1,\"edits\":\"picture.size=20 20\"}");
        client.sendLine("{\"id\":3,\"method\":\"render\",\"scene\":1}");
        assertThat(client.answer(3).get("result").get("size").toString()).isEqualTo("[20,20]");
    }

    @Test
    void canceledRender_changesNothing() throws Exception {
        client.open(LARGE);
        int render = client.send("render", "'scene':1,'progress':true");
        while (!client.read().has("progress")) {
            // Waits until it runs.
        }
        int cancel = client.send("cancel", "'request':" + render);
        assertThat(client.answer(cancel).get("result").get("canceled").asBoolean()).isTrue();
        assertThat(client.answer(render).get("error").get("code").asString()).isEqualTo("canceled");
        assertThat(client.request("cancel", "'request':" + render).get("canceled").asBoolean()).isFalse();
        client.request("set", "'scene':1,'edits':['picture.size=70 50','picture.antialias=off']");
        assertThat(client.picture(1, "")).isEqualTo(trace(scene()).toScanlines());
    }

    @Test
    void waitingRender_canBeCanceled() throws Exception {
        client.open(LARGE);
        client.open(SCENE);
        int large = client.send("render", "'scene':1,'progress':true");
        while (!client.read().has("progress")) {
            // Waits until it runs: each scene has a thread of its own, and the second one could be first.
        }
        int small = client.send("render", "'scene':2");
        client.send("cancel", "'request':" + small);
        assertThat(client.answer(small).has("error")).isTrue();
        client.send("cancel", "'request':" + large);
        assertThat(client.answer(large).get("error").get("code").asString()).isEqualTo("canceled");
        assertThat(client.picture(2, "")).isEqualTo(trace(scene()).toScanlines());
    }

    @Test
    void pictureThatDoesNotFit_isRefusedInOneSentence() throws Exception {
        client.open(SCENE);
        client.open(SCENE);
        client.picture(2, "");
        client.request("set", "'scene':1,'edits':['picture.size=16000 16000']");
        JsonNode error = client.refused("render", "'scene':1");
        assertThat(error.get("code").asString()).isEqualTo("memory");
        assertThat(error.get("message").asString()).startsWith("the picture needs about").contains("it would fit with a size of")
                .doesNotContain("\n");
        client.request("undo", "'scene':1");
        assertThat(client.picture(1, "")).isEqualTo(trace(scene()).toScanlines());
    }

    @Test
    void memoryOfOtherScenes_counts() throws Exception {
        String scene = SCENE.replace("size 70 50", "size 256 256");
        client.open(scene);
        client.request("render", "'scene':1");
        long bytes = client.request("list", "").get("scenes").get(0).get("bytes").asLong();
        try (Server small = new Server(new ServerOptions(1, bytes * 3 / 2)); TestClient other = new TestClient(small)) {
            other.open(scene);
            other.open(scene);
            other.request("render", "'scene':1");
            assertThat(other.refused("render", "'scene':2").get("code").asString()).isEqualTo("memory");
            other.request("close", "'scene':1");
            other.request("render", "'scene':2");
        }
    }

    @Test
    void sceneOfAClientThatIsGone_isClosed_andItsRequestsEnd() throws Exception {
        try (TestClient other = new TestClient(server)) {
            other.open(LARGE);
            other.request("open", "'file':'scenes/bird.jen','keep':true");
            other.send("render", "'scene':1");
        }
        JsonNode scenes;
        do {
            scenes = client.request("list", "").get("scenes");
        } while (scenes.size() > 1);
        assertThat(scenes.get(0).get("scene").asInt()).isEqualTo(2);
        // Another client uses it, and the server is free again.
        client.request("set", "'scene':2,'edits':'picture.size=20 20'");
        client.request("render", "'scene':2");
    }

    @Test
    void endOfInput_waitsForAnswers() throws Exception {
        client.open(SCENE);
        int render = client.send("render", "'scene':1,'file':'" + folder.resolve("a.png") + "'");
        client.finish();
        assertThat(client.answer(render).has("result")).isTrue();
        assertThat(folder.resolve("a.png")).exists();
    }

    @Test
    void history_startsAgainAfterManySteps() throws Exception {
        client.open(SCENE);
        for (int i = 0; i <= SceneEditing.MAX_STEPS; i++) {
            client.send("set", "'scene':1,'edits':'key.intensity=0." + (i % 9 + 1) + "'");
            client.read();
        }
        assertThat(client.request("undo", "'scene':1").get("steps").asInt()).isLessThan(SceneEditing.MAX_STEPS);
    }

    @Test
    void save_writesTheEditedScene() throws Exception {
        Path file = folder.resolve("edited.jen");
        client.open(SCENE);
        client.request("set", "'scene':1,'edits':'key.intensity=0.25'");
        client.request("save", "'scene':1,'file':'" + file + "'");
        assertThat(Files.readString(file)).isEqualTo(SCENE.replace("intensity 0.8", "intensity 0.25"));
        assertThat(client.refused("save", "'scene':1,'file':'" + folder + "'").get("place").asString()).isEqualTo("file");
    }
}

package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** Requests that open another program's file, and that replace an open scene. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
class ReplaceTest {
    /** Two triangles over four vertices, as base64 of their positions. */
    private static final String MODEL = """
            {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
             "nodes": [{"name": "sheet", "mesh": 0, "translation": [0, 0, -5]}],
             "meshes": [{"name": "sheet", "primitives": [{"attributes": {"POSITION": 0}, "mode": 5, "material": 0}]}],
             "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1], "metallicFactor": 0}}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
             "bufferViews": [{"buffer": 0, "byteLength": 48}],
             "buffers": [{"byteLength": 48, "uri": "data:application/octet-stream;base64,\
            AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAvwAAgD8AAAAAAACAPwAAgD8AAAAA"}],
             "extras": {"lightning": {"picture": {"size": [40, 30]}, "lights": [
               {"name": "key", "type": "point", "at": [1, 2, -2], "intensity": 0.7, "radius": 0.2}]}}}
            """;

    @TempDir
    private Path folder;
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

    private String fields(String model) throws IOException {
        Path file = Files.writeString(folder.resolve("model.gltf"), model);
        return "'file':'" + file + "','output':'" + folder.resolve("model.jen") + "','indirect':'off'";
    }

    /** Returns a full trace of the scene file that the command would write. */
    private float[] traced(String model) throws Exception {
        Path source = Files.writeString(Files.createDirectories(folder.resolve("command")).resolve("model.gltf"), model);
        Path output = source.resolveSibling("model.jen");
        SceneImporter.read(source, output, LightUnits.CANDELA, Progress.NONE).write();
        return ServerTest.trace(JenReader.read(output).scene()).toScanlines();
    }

    @Test
    void importedFile_isWhatTheCommandWrites() throws Exception {
        JsonNode opened = client.request("open", fields(MODEL));
        assertThat(opened.get("lights").toString()).isEqualTo("[\"key\"]");
        assertThat(opened.get("size").toString()).isEqualTo("[40,30]");
        assertThat(client.picture(1, "")).isEqualTo(traced(MODEL));
        assertThat(folder.resolve("model.jen")).doesNotExist();
    }

    @Test
    void chosenCamera_isThatOfTheFile() throws Exception {
        String cameras = MODEL.replace("\"nodes\": [0]", "\"nodes\": [0, 1, 2]").replace("\"translation\": [0, 0, -5]}",
                "\"translation\": [0, 0, -5]}, {\"name\": \"near\", \"camera\": 0}, {\"name\": \"far\", \"camera\": 0,"
                        + " \"translation\": [0, 0, 3]}")
                .replace("\"materials\"", "\"cameras\": [{\"type\": \"perspective\", \"perspective\": {\"yfov\": 1,"
                        + " \"znear\": 1}}], \"materials\"");
        client.request("open", fields(cameras) + ",'camera':'far'");
        assertThat(client.request("get", "'scene':1,'properties':'camera.from'").toString()).contains("0 0 3");
        assertThat(client.refused("open", fields(cameras) + ",'camera':'no'").toString()).contains("has 'near', 'far'");
        assertThat(client.refused("open", fields(cameras) + ",'frame':'x'").get("place").asString()).isEqualTo("frame");
    }

    @Test
    void replacedScene_recomputesWhatChanged_andEqualsAFullTrace() throws Exception {
        client.request("open", fields(MODEL));
        client.picture(1, "");
        String painted = MODEL.replace("[0.5, 0.6, 0.7, 1]", "[0.9, 0.1, 0.2, 1]");
        client.request("replace", "'scene':1," + fields(painted));
        JsonNode render = client.request("render", "'scene':1,'memory':true");
        assertThat(render.get("rays").asInt()).isZero();
        assertThat(render.get("plan").asString()).contains("paint");
        assertThat(TestClient.floats(render)).isEqualTo(traced(painted));
        for (String edited : new String[] {painted.replace("[0, 0, -5]", "[0.5, 0, -4]"), painted.replace("[1, 2, -2]", "[-1, 2, -2]"),
            painted.replace("AACAvwAAgL8A", "AACAPwAAgL8A"), painted.replace("[40, 30]", "[30, 40]")}) {
            client.request("replace", "'scene':1," + fields(edited));
            assertThat(client.picture(1, "")).isEqualTo(traced(edited));
        }
    }

    @Test
    void movedObject_keepsTheView_andTheRaysOfOthers() throws Exception {
        String two = MODEL.replace("\"nodes\": [0]", "\"nodes\": [0, 1]").replace("\"translation\": [0, 0, -5]}",
                "\"translation\": [0, 0, -5]}, {\"name\": \"flap\", \"mesh\": 0, \"translation\": [3, 0, -6]}, {\"camera\": 0}")
                .replace("[0, 1]", "[0, 1, 2]")
                .replace("\"materials\"", "\"cameras\": [{\"type\": \"perspective\", \"perspective\": {\"yfov\": 1,"
                        + " \"znear\": 1}}], \"materials\"")
                .replace("\"picture\"", "\"distance\": 10, \"picture\"");
        client.request("open", fields(two));
        client.picture(1, "");
        String moved = two.replace("[3, 0, -6]", "[2.5, 1, -6]");
        client.request("replace", "'scene':1," + fields(moved));
        JsonNode render = client.request("render", "'scene':1,'memory':true");
        assertThat(render.get("plan").asString()).doesNotContain("full render");
        assertThat(TestClient.floats(render)).isEqualTo(traced(moved));
    }

    @Test
    void replacedByText_startsItsHistoryAgain() throws Exception {
        client.request("open", fields(MODEL));
        client.request("set", "'scene':1,'edits':'key.intensity=2'");
        client.request("replace", "'scene':1,'text':'jen 1'");
        assertThat(client.request("undo", "'scene':1").get("steps").asInt()).isZero();
        assertThat(client.request("save", "'scene':1").get("text").asString()).doesNotContain("key");
    }

    @Test
    void failedReplacement_changesNothing() throws Exception {
        client.request("open", fields(MODEL));
        float[] before = client.picture(1, "");
        assertThat(client.refused("replace", "'scene':1," + fields("{}")).get("code").asString()).isEqualTo("bad_scene");
        assertThat(
                client.refused("replace", "'scene':1,'file':'" + folder.resolve("none.glb") + "','output':'x.jen'").get("code").asString())
                .isEqualTo("file");
        assertThat(client.refused("replace", "'scene':1,'file':'model.gltf'").get("place").asString()).isEqualTo("output");
        assertThat(client.refused("replace", "'scene':1,'file':'a.glb','output':'a.txt'").get("place").asString()).isEqualTo("output");
        assertThat(client.refused("replace", "'scene':1,'file':'a.glb','output':'a.jen','indirect':'maybe'").get("place").asString())
                .isEqualTo("indirect");
        assertThat(client.refused("open", "'text':'jen 1','output':'a.jen'").get("place").asString()).isEqualTo("output");
        assertThat(client.picture(1, "")).isEqualTo(before);
    }

    @Test
    void changedTexture_isReadAgain() throws Exception {
        String textured = MODEL.replace("\"metallicFactor\": 0", "\"metallicFactor\": 0, \"baseColorTexture\": {\"index\": 0}")
                .replace("\"materials\"", "\"textures\": [{\"source\": 0}], \"images\": [{\"uri\": \"paint.png\"}], \"materials\"")
                .replace("{\"POSITION\": 0}", "{\"POSITION\": 0, \"TEXCOORD_0\": 1}")
                .replace("\"VEC3\"}]", "\"VEC3\"}, {\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC2\"}]");
        Path image = folder.resolve("paint.png");
        Files.createDirectories(folder.resolve("command"));
        float[] last = null;
        for (String texture : new String[] {"brick.png", "marble.png"}) {
            Files.write(image, Files.readAllBytes(Path.of("textures", texture)));
            Files.write(folder.resolve("command/paint.png"), Files.readAllBytes(image));
            client.request(last == null ? "open" : "replace", (last == null ? "" : "'scene':1,") + fields(textured));
            float[] picture = client.picture(1, "");
            assertThat(picture).isEqualTo(traced(textured)).isNotEqualTo(last);
            last = picture;
        }
    }
}

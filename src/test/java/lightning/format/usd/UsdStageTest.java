package lightning.format.usd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks of what the converter wrote, which a hostile stage decides. */
class UsdStageTest {
    private static final Path SOURCE = Path.of("shot.usda");
    @TempDir
    private Path folder;

    /** Four points of a square, one face of four corners, its corners. */
    @BeforeEach
    void writeArrays() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(68).order(ByteOrder.nativeOrder());
        for (float v : new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
            bytes.putFloat(v);
        }
        bytes.putInt(4).putInt(0).putInt(1).putInt(2).putInt(3);
        Files.write(folder.resolve("arrays.bin"), bytes.array());
    }

    private List<Mesh> mesh(String json, ConversionNotes notes) throws IOException, MeshException {
        Files.writeString(folder.resolve("stage.json"), "{\"version\": 1, \"mesh\": " + json + "}");
        return UsdStage.open(SOURCE, folder, stage -> UsdMesh.read(stage, stage.root().get("mesh"), 0, List.of(new int[] {7, -1}), notes));
    }

    @Test
    void polygon_becomesTriangles() throws Exception {
        var notes = new ConversionNotes();
        List<Mesh> parts = mesh("{\"points\": [0, 48], \"counts\": [48, 4], \"indices\": [52, 16]}", notes);
        assertThat(parts.getFirst().triangleCount()).isEqualTo(2);
        assertThat(parts.getLast()).isNull();
        assertThat(notes.counts()).isEmpty();
    }

    @Test
    void leftHandedFaces_turnRound() throws Exception {
        String square = "{\"points\": [0, 48], \"counts\": [48, 4], \"indices\": [52, 16], \"smooth\": true, \"left\": ";
        assertThat(mesh(square + "false}", new ConversionNotes()).getFirst().normals()[2]).isEqualTo(1);
        assertThat(mesh(square + "true}", new ConversionNotes()).getFirst().normals()[2]).isEqualTo(-1);
    }

    @Test
    void damagedArrays_leaveTheMeshOut() throws Exception {
        for (String json : List.of("{\"points\": [0, 48], \"counts\": [52, 16], \"indices\": [52, 16]}",
                "{\"points\": [0, 36], \"counts\": [48, 4], \"indices\": [52, 16]}",
                "{\"points\": [0, 48], \"counts\": [0, 48], \"indices\": [52, 16]}",
                "{\"points\": [0, 480], \"counts\": [48, 4], \"indices\": [52, 16]}",
                "{\"points\": [-4, 48], \"counts\": [48, 4], \"indices\": [52, 16]}",
                "{\"points\": [0, 47], \"counts\": [48, 4], \"indices\": [52, 16]}",
                "{\"points\": [0, 48], \"counts\": [48, 4], \"indices\": [52, 16], \"normals\": {\"values\": [0, 12]}}",
                "{\"points\": 7, \"counts\": [48, 4], \"indices\": [52, 16]}")) {
            var notes = new ConversionNotes();
            assertThat(mesh(json, notes).getFirst()).as(json).isNull();
            assertThat(notes.counts()).as(json).containsKey("meshes with damaged arrays or numbers beyond the limits");
        }
    }

    @Test
    void damagedDescription_isOneSentence() throws Exception {
        for (String json : List.of("", "{", "[]", "{\"version\": 2}", "{\"version\": \"1\"}", "[".repeat(5000))) {
            Files.writeString(folder.resolve("stage.json"), json);
            assertThatThrownBy(() -> UsdStage.open(SOURCE, folder, UsdStage::root)).as(json).isInstanceOf(MeshException.class)
                    .hasMessageStartingWith("shot.usda: ");
        }
    }

    @Test
    void layer_isText() {
        var layer = new UsdLayer();
        layer.metadata("upAxis", UsdLayer.quoted("Y"));
        layer.prim("/World/key").set("float inputs:intensity", UsdLayer.number(0.1));
        layer.prim("/new").define("Scope").metadata("doc", UsdLayer.quoted("a \"b\" \\"));
        assertThat(layer.text()).isEqualTo("""
                #usda 1.0
                (
                    upAxis = "Y"
                )

                over "World"
                {
                    over "key"
                    {
                        float inputs:intensity = 0.1
                    }
                }

                def Scope "new" (
                    doc = "a \\"b\\" \\\\"
                )
                {
                }
                """);
    }
}

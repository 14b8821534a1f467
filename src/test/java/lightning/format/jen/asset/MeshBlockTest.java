package lightning.format.jen.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.format.jen.Problem;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Mesh blocks of scene files: the search path of their files, and messages for unusable ones. */
public class MeshBlockTest {
    /** File of one triangle. */
    public static final String TRIANGLE = """
            ply
            format ascii 1.0
            element vertex 3
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            0 0 0
            1 0 0
            0 1 0
            3 0 1 2
            """;

    @TempDir
    Path root;
    private Path scenes;

    @BeforeEach
    void makeFolder() throws IOException {
        scenes = Files.createDirectories(root.resolve("project/scenes"));
        Files.writeString(scenes.resolve("a.ply"), TRIANGLE);
    }

    private Scene read(String text) throws JenException {
        return JenReader.read("jen 1 " + text, "s.jen", scenes).scene();
    }

    private List<Problem> notes(String text) throws JenException {
        return JenReader.read("jen 1 " + text, "s.jen", scenes).notes();
    }

    private static Solid.TriangleMesh solid(Scene scene, int shape) {
        return (Solid.TriangleMesh) ((Shape) scene.nodes().get(shape)).solid();
    }

    @Test
    void meshNextToScene_isRead() throws Exception {
        Solid.TriangleMesh solid = solid(read("mesh m { file \"a.ply\" }"), 0);
        assertThat(solid.file()).isEqualTo("a.ply");
        assertThat(solid.part()).isEmpty();
        assertThat(solid.mesh().triangleCount()).isEqualTo(1);
    }

    @Test
    void meshInMeshesFolder_isRead() throws Exception {
        Path meshes = Files.createDirectories(root.resolve("project/meshes/sub"));
        Files.writeString(meshes.resolve("b.ply"), TRIANGLE);
        assertThat(solid(read("mesh m { file \"sub/b.ply\" }"), 0).mesh().vertexCount()).isEqualTo(3);
    }

    @Test
    void repeatedFile_isLoadedOnce() throws Exception {
        Scene scene = read("mesh m { file \"a.ply\" } mesh n { file \"a.ply\" part mesh at 1 0 0 }");
        assertThat(solid(scene, 0).mesh()).isSameAs(solid(scene, 1).mesh());
    }

    @Test
    void mesh_roundTrips() throws Exception {
        Scene scene = read("mesh m { file \"a.ply\" part mesh scale 2 2 2 } mesh n { file \"a.ply\" }");
        assertThat(JenReader.read(JenWriter.write(scene), "again", scenes).scene()).isEqualTo(scene);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "mesh m { } | mesh 'm': expected a file, found none",
        "mesh m { file a } | mesh 'm': file: expected a file name in quotes, found 'a'",
        "sphere m { file \"a.ply\" } | sphere 'm': unknown property 'file'"})
    void invalidFile_isReportedWithLocation(String text, String message) {
        assertThatThrownBy(() -> read(text)).isInstanceOf(JenException.class).message().startsWith("s.jen:1:").contains(message);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "mesh m { file \"b.ply\" } | there is no mesh file 'b.ply' in the folder 'scenes'",
        "mesh m { file \"../a.ply\" } | mesh 'm': mesh file must be a path without empty names, . and .., was '../a.ply'",
        "mesh m { file \"/etc/passwd\" } | mesh 'm': mesh file must be a file next to the scene or in its meshes folder",
        "mesh m { file \"a.ply\" part head } | mesh 'm': mesh file 'a.ply' has no part 'head'",
        "mesh m { file \"bad.ply\" } | bad.ply"})
    void unusableFile_isNotedWithLocation(String text, String message) throws Exception {
        Files.writeString(scenes.resolve("bad.ply"), TRIANGLE.replace("3 0 1 2", "3 0 1 3"));
        assertThat(notes(text)).singleElement().asString().startsWith("s.jen:1:").contains(message).endsWith("; left out");
    }

    @Test
    void linkOutOfFolder_isRejected() throws Exception {
        Files.writeString(root.resolve("secret.ply"), TRIANGLE);
        Files.createSymbolicLink(scenes.resolve("b.ply"), root.resolve("secret.ply"));
        assertThat(notes("mesh m { file \"b.ply\" }")).singleElement().asString().contains("a link to another folder");
    }

    @Test
    void fileSetByEdit_isReadFromFolder() throws Exception {
        Files.writeString(scenes.resolve("b.ply"), TRIANGLE.replace("0 1 0", "0 2 0"));
        Scene scene = read("mesh m { file \"a.ply\" }");
        Scene edited = PropertyEdit.apply(scene, "m.file=\"b.ply\"", scenes);
        assertThat(solid(edited, 0).mesh().positions()[7]).isEqualTo(2);
        assertThat(PropertyEdit.apply(scene, "m.at=1 2 3").stage().shapeCount()).isEqualTo(1);
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "m.file=\"b.ply\""))
                .hasMessageContaining("file must be one that the scene already has");
    }

    @Test
    void mergedMeshes_retainTrianglesAndAttributes() {
        Mesh flat = new Mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, new int[] {0, 1, 2, 2, 1, 3}, null, null, null);
        Mesh smooth = new Mesh(new float[] {0, 0, 5, 1, 0, 5, 0, 1, 5}, new int[] {0, 1, 2}, new float[] {1, 0, 0, 1, 0, 0, 1, 0, 0},
                new float[] {1, 2, 3, 4, 5, 6}, null);
        Mesh merged = MeshMerger.merge(List.of(flat, smooth));
        assertThat(merged.triangleCount()).isEqualTo(3);
        assertThat(merged.normals()).startsWith(0, 0, 1).endsWith(1, 0, 0);
        assertThat(merged.coordinates()).startsWith(0, 0).endsWith(1, 2, 3, 4, 5, 6);
        assertThat(merged.positions()[3 * merged.triangles()[8] + 2]).isEqualTo(5);
    }
}

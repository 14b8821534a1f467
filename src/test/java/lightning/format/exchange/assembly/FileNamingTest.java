package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.exchange.SceneImporter;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Imports next to files of the user. */
class FileNamingTest {
    private static final byte[] FOREIGN = "my own model".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;
    private Path model;
    private Path scene;

    @BeforeEach
    void createFolders() throws IOException {
        model = Files.createDirectory(folder.resolve("in")).resolve("a.glb");
        scene = Files.createDirectory(folder.resolve("out")).resolve("a.jen");
    }

    private void send(float width) throws Exception {
        byte[] data = GltfFixtures.SQUARE.clone();
        ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN).putFloat(3 * Float.BYTES, width);
        Files.write(model, GltfFixtures.binary(GltfFixtures.SQUARE_JSON, data));
        SceneImporter.read(model, scene, LightUnits.CANDELA, Progress.NONE).keepingOthers((_, _) -> {}).writeReplacing();
    }

    private float width(Path file) throws Exception {
        Shape floor = JenReader.read(file).scene().stage().shapes().getFirst();
        return ((Solid.TriangleMesh) floor.solid()).mesh().positions()[3];
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(scene.getParent())) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void fileOfAnotherProgram_stays_andSceneUsesAnotherName() throws Exception {
        Path foreign = Files.write(scene.resolveSibling("a.glb"), FOREIGN);
        send(2);
        assertThat(foreign).hasBinaryContent(FOREIGN);
        assertThat(width(scene)).isEqualTo(2);
        assertThat(files()).containsExactly("2 a.glb", "a.glb", "a.jen");
        send(3);
        assertThat(foreign).hasBinaryContent(FOREIGN);
        assertThat(width(scene)).isEqualTo(3);
        assertThat(files()).as("its own file is replaced").containsExactly("2 a.glb", "a.glb", "a.jen");
    }

    @Test
    void fileOfEarlierImport_isReplaced() throws Exception {
        send(2);
        send(3);
        assertThat(width(scene)).isEqualTo(3);
        assertThat(files()).containsExactly("a.glb", "a.jen");
    }

    @Test
    void fileThatChangedSinceImport_stays() throws Exception {
        send(2);
        Path changed = Files.write(scene.resolveSibling("a.glb"), FOREIGN);
        send(3);
        assertThat(changed).hasBinaryContent(FOREIGN);
        assertThat(width(scene)).isEqualTo(3);
    }

    @Test
    void fileThatAnotherSceneUses_stays() throws Exception {
        send(2);
        Path look = Files.copy(scene, scene.resolveSibling("look.jen"));
        send(3);
        assertThat(width(look)).isEqualTo(2);
        assertThat(width(scene)).isEqualTo(3);
        assertThat(files()).containsExactly("2 a.glb", "a.glb", "a.jen", "look.jen");
    }

    @Test
    void equalFileOfUser_isNoFileOfImport() throws Exception {
        send(2);
        Path user = Files.copy(scene.resolveSibling("a.glb"), folder.resolve("copy"));
        Files.delete(scene);
        send(2);
        send(3);
        assertThat(scene.resolveSibling("a.glb")).hasSameBinaryContentAs(user);
        assertThat(width(scene)).isEqualTo(3);
    }

    @Test
    void deletedScene_leavesItsFiles() throws Exception {
        send(2);
        byte[] before = Files.readAllBytes(scene.resolveSibling("a.glb"));
        Files.delete(scene);
        send(3);
        assertThat(scene.resolveSibling("a.glb")).hasBinaryContent(before);
    }
}

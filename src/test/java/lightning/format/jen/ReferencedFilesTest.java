package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import lightning.format.gltf.GltfFixtures;
import lightning.scene.Scene;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of scenes whose meshes name further files. */
class ReferencedFilesTest {
    private static final String TEXT = "jen 1 mesh floor { file \"parts/floor.gltf\" }";

    @TempDir
    Path root;
    private Path scenes;
    private Path parts;

    /** Writes a square whose buffer is a file of its own. */
    @BeforeEach
    void makeMesh() throws IOException {
        scenes = Files.createDirectories(root.resolve("scenes"));
        parts = Files.createDirectories(scenes.resolve("meshes/parts"));
        Files.createDirectories(parts.resolve("data"));
        Files.write(parts.resolve("data/floor.bin"), GltfFixtures.SQUARE);
        Files.writeString(parts.resolve("floor.gltf"),
                GltfFixtures.SQUARE_JSON.replace("'buffers': [{", "'buffers': [{'uri': 'data/floor.bin', ").replace('\'', '"'));
    }

    private static Scene read(Path folder) throws JenException {
        return JenReader.read(TEXT, "s.jen", folder).scene();
    }

    @Test
    void bufferOfMesh_hasNameBesideIt() throws Exception {
        SortedMap<String, Path> files = ReferencedFiles.of(read(scenes), scenes);
        assertThat(files.keySet()).containsExactly("parts/data/floor.bin", "parts/floor.gltf");
        assertThat(files.get("parts/data/floor.bin")).isEqualTo(parts.resolve("data/floor.bin").toRealPath());
    }

    @Test
    void copiedScene_isComplete() throws Exception {
        Path copy = Files.createDirectories(root.resolve("copy"));
        AssetCopies.copy(read(scenes), scenes, copy);
        assertThat(copy.resolve("meshes/parts/data/floor.bin")).hasSameBinaryContentAs(parts.resolve("data/floor.bin"));
        assertThat(((Solid.TriangleMesh) ((Shape) read(copy).nodes().getFirst()).solid()).mesh().triangleCount()).isEqualTo(2);
    }

    @Test
    void bufferWithImpossibleName_isReported() throws Exception {
        Scene scene = read(scenes);
        Files.copy(parts.resolve("data/floor.bin"), parts.resolve("data/floor~1.bin"));
        Path mesh = parts.resolve("floor.gltf");
        Files.writeString(mesh, Files.readString(mesh).replace("floor.bin", "floor~1.bin"));
        assertThatThrownBy(() -> ReferencedFiles.of(scene, scenes)).isInstanceOf(IOException.class)
                .hasMessageStartingWith("the file that 'parts/floor.gltf' names must be a file name");
    }
}

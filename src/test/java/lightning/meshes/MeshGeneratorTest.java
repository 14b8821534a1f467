package lightning.meshes;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeshGeneratorTest {
    @TempDir
    private Path folder;

    @Test
    void scenes_containGeneratedMeshes() throws Exception {
        MeshGenerator.main(new String[] {folder.toString()});
        try (Stream<Path> written = Files.walk(folder)) {
            for (Path file : written.filter(Files::isRegularFile).toList()) {
                assertThat(file).hasSameBinaryContentAs(Path.of("scenes").resolve(folder.relativize(file).toString()));
            }
        }
    }

    @Test
    void everyMesh_isUsedByAScene() throws Exception {
        var text = new StringBuilder();
        try (Stream<Path> scenes = Files.list(Path.of("scenes"))) {
            for (Path scene : scenes.filter(f -> f.toString().endsWith(".jen")).toList()) {
                text.append(Files.readString(scene));
            }
        }
        assertThat(SampleSolids.all().keySet()).allSatisfy(name -> assertThat(text).contains("\"" + name + ".ply\""));
    }
}

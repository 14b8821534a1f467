package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.gltf.GltfFixtures;
import lightning.format.mesh.MeshException;
import lightning.scene.NamedCamera;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Choice of a camera in glTF files. */
class GltfCamerasTest {
    /** Three cameras; the node of the last has no name. */
    private static final String JSON = """
            {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1, 3]}],
             'cameras': [{'type': 'perspective', 'name': 'lens', 'perspective': {'yfov': 1, 'znear': 0.1}}],
             'nodes': [{'name': 'front', 'camera': 0, 'translation': [0, 0, 9]}, {'children': [2]},
               {'name': 'side', 'camera': 0, 'translation': [8, 0, 0]}, {'camera': 0, 'translation': [0, 7, 0]}]}""";
    @TempDir
    private Path folder;

    private ImportedScene read(ImportOptions options) throws Exception {
        return SceneImporter.read(Files.write(folder.resolve("a.gltf"), GltfFixtures.text(JSON, new byte[0])), folder.resolve("a.jen"),
                options, Progress.NONE);
    }

    private Vec3 eye(String camera) throws Exception {
        return read(ImportOptions.DEFAULT.withCamera(camera)).scene().camera().from();
    }

    @Test
    void camera_isChosenByName() throws Exception {
        assertThat(eye("")).isEqualTo(new Vec3(0, 0, 9));
        assertThat(eye("side")).isEqualTo(new Vec3(8, 0, 0));
        assertThat(eye("lens")).isEqualTo(new Vec3(0, 7, 0));
    }

    @Test
    void allCameras_areKeptUnderTheirNames() throws Exception {
        Scene scene = read(ImportOptions.DEFAULT.withCamera("side")).scene();
        assertThat(scene.cameras()).extracting(NamedCamera::name).containsExactly("front", "side", "lens");
        assertThat(scene.cameras().get(1).camera()).isEqualTo(scene.camera());
        assertThat(scene.cameras().get(2).camera().from()).isEqualTo(new Vec3(0, 7, 0));
    }

    /** A glTF file does not say how its picture looks. */
    @Test
    void highlightsOfImports_doNotClip() throws Exception {
        assertThat(read(ImportOptions.DEFAULT).scene().picture().view().curve()).isEqualTo(ViewCurve.AGX);
    }

    @Test
    void unknownCamera_isRejectedWithTheNames() {
        assertThatThrownBy(() -> eye("no")).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the camera 'no', has 'front', 'side', 'lens'");
    }

    @Test
    void frame_isForStagesOnly() {
        assertThatThrownBy(() -> read(ImportOptions.DEFAULT.withFrame(OptionalDouble.of(3)))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must be a USD file to be read at one frame");
    }
}

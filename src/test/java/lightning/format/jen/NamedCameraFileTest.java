package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.NamedCamera;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Named cameras in scene files. */
class NamedCameraFileTest {
    private static JenDocument read(String text) throws JenException {
        return JenReader.read("jen 1\n" + text, "s.jen", Path.of("."));
    }

    @Test
    void namedCameras_areKeptBesideThatOfThePicture() throws JenException {
        Scene scene = read("camera side { from 9 0 0 }\ncamera { fov 20 }\ncamera \"from above\" { from 0 9 0  up 0 0 -1 }").scene();
        assertThat(scene.camera().fov()).isEqualTo(20);
        assertThat(scene.cameras()).extracting(NamedCamera::name).containsExactly("side", "from above");
        assertThat(scene.namedCamera("side").map(Camera::from)).contains(new Vec3(9, 0, 0));
    }

    @Test
    void pictureHasTheDefaultCamera_ifOnlyNamedOnesAreWritten() throws JenException {
        assertThat(read("camera side { from 9 0 0 }").scene().camera()).isEqualTo(Camera.DEFAULT);
    }

    @Test
    void repeatedName_isRefused() {
        assertThatThrownBy(() -> read("camera a {}\ncamera a {}")).isInstanceOf(JenException.class)
                .hasMessageContaining("camera 'a': names must be unique, found a camera with this name before");
    }

    @Test
    void sameNameAsALight_isAllowed() throws JenException {
        assertThat(read("camera key {}\nlight key point {}").scene().cameras()).hasSize(1);
    }

    @Test
    void replacedCamera_isPatchedInPlace() throws JenException {
        JenDocument document = read("# mine\ncamera side { from 9 0 0 }  # kept\ncamera { fov 20 }\n");
        Scene scene = document.scene();
        Scene edited = scene.withCameras(List.of(new NamedCamera("side", scene.cameras().getFirst().camera().withView(
                new Vec3(8, 0, 0), Vec3.ZERO, Vec3.Y))));
        assertThat(document.withScene(edited).text()).isEqualTo("jen 1\n# mine\ncamera side { from 8 0 0 }  # kept\ncamera { fov 20 }\n");
    }
}

package lightning.sample;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class FailedSceneRecorderTest {

    @Test
    void failingScene_isSavedAndReadable() throws Exception {
        Scene scene = StudioScene.of(LightType.SPOT);
        assertThatThrownBy(() -> FailedSceneRecorder.check("failed-scene", scene, s -> assertThat(s.lights()).isEmpty()))
                .isInstanceOf(AssertionError.class).hasMessageContaining("the scene was saved in").hasMessageContaining("light key spot");
        assertThat(JenReader.read(Path.of("target", "failures", "failed-scene", "scene.jen")).scene()).isEqualTo(scene);
    }

    @Test
    void passingScene_savesNothing() {
        FailedSceneRecorder.check("passed-scene", StudioScene.of(LightType.POINT), s -> assertThat(s.lights()).hasSize(1));
        assertThat(Path.of("target", "failures", "passed-scene")).doesNotExist();
    }

    @Test
    void storedScenes_areFound() throws Exception {
        assertThat(FailedSceneRecorder.storedScenes()).map(file -> file.getFileName().toString()).contains("lost-dot.jen",
                "turned-groups.jen");
    }
}

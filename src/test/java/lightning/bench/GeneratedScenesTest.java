package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class GeneratedScenesTest {
    private static final PictureSize SIZE = new PictureSize(30, 20);

    @Test
    void scene_hasRequestedCounts() {
        Scene scene = GeneratedScenes.of(1, SIZE, 50, 4, 7);
        assertThat(scene.placedShapes()).hasSize(50);
        assertThat(scene.lights()).extracting(Light::type).containsExactly(LightType.POINT, LightType.DIRECTIONAL, LightType.SPOT,
                LightType.POINT);
        assertThat(scene.picture().depth()).isEqualTo(7);
        assertThat(scene.picture().width()).isEqualTo(30);
        assertThat(GeneratedScenes.of(1, SIZE, 1, 1, 0).placedShapes()).hasSize(1);
    }

    @Test
    void sameSeed_givesSameScene() {
        assertThat(GeneratedScenes.of(3, SIZE, 20, 5, 1)).isEqualTo(GeneratedScenes.of(3, SIZE, 20, 5, 1));
        assertThat(GeneratedScenes.of(3, SIZE, 20, 5, 1)).isNotEqualTo(GeneratedScenes.of(4, SIZE, 20, 5, 1));
    }
}

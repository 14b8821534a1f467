package lightning.render.warmup;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.sample.StudioScene;
import lightning.scene.Antialias;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class LongPictureTest {

    @Test
    void rays_areOneOfEachPixelToEachLight() {
        assertThat(LongPicture.rays(scene(1920, 1080, lights(30)))).isEqualTo(1920L * 1080 * 31);
    }

    @Test
    void raysOfAnArea_areThoseOfItsSamples() {
        List<Light> lights = lights(1);
        Light area = lights.getFirst().withArea(lights.getFirst().area().withRadius(1).withSamples(64));
        assertThat(LongPicture.rays(scene(100, 100, List.of(area)))).isEqualTo(100L * 100 * 65);
    }

    @Test
    void raysOfFinerSamples_areThoseOfEachPixel() {
        Scene scene = scene(100, 100, lights(2));
        Scene fine = scene.withPicture(scene.picture().withSampling(new Sampling(Antialias.EDGES, 4)));
        assertThat(LongPicture.rays(fine)).isEqualTo(100L * 100 * 16 * 3);
    }

    @Test
    void pictureOfAHundredMillionRays_isLong() {
        assertThat(LongPicture.is(scene(10_000, 5_000, lights(1)))).isTrue();
        assertThat(LongPicture.is(scene(10_000, 4_999, lights(1)))).isFalse();
    }

    private static Scene scene(int width, int height, List<Light> lights) {
        return StudioScene.of(LightType.POINT).withLights(lights).withPicture(new Picture(width, height, 0));
    }

    private static List<Light> lights(int count) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            lights.add(Light.of("lamp" + i, LightType.POINT));
        }
        return lights;
    }
}

package lightning.render.warmup;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;

class LongRenderCheckTest {

    @Test
    void estimate_countsOneShadowRayPerPixelAndLight() {
        assertThat(LongRenderCheck.estimateRays(scene(1920, 1080, lights(30)))).isEqualTo(1920L * 1080 * 31);
    }

    @Test
    void estimate_areaLight_countsItsSamples() {
        List<Light> lights = lights(1);
        Light area = lights.getFirst().withArea(lights.getFirst().area().withRadius(1).withSamples(64));
        assertThat(LongRenderCheck.estimateRays(scene(100, 100, List.of(area)))).isEqualTo(100L * 100 * 65);
    }

    @Test
    void estimate_everyPixelSampled_countsAllSamples() {
        Scene scene = scene(100, 100, lights(2));
        Scene fine = scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 4)));
        assertThat(LongRenderCheck.estimateRays(fine)).isEqualTo(100L * 100 * 16 * 3);
    }

    @Test
    void estimate_edgesSampled_liesBetweenCentersAndAllSamples() {
        Scene scene = scene(100, 100, lights(2));
        Scene fine = scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 4)));
        assertThat(LongRenderCheck.estimateRays(fine)).isBetween(100L * 100 * 3, 100L * 100 * 16 * 3);
    }

    @Test
    void estimate_indirectLight_growsWithItsRaysAndTheirDensity() {
        Scene scene = scene(100, 100, lights(1));
        long direct = LongRenderCheck.estimateRays(scene);
        long coarse = LongRenderCheck.estimateRays(indirect(scene, 64, 8)) - direct;
        assertThat(coarse).isGreaterThan(100L * 100 * 20);
        assertThat(LongRenderCheck.estimateRays(indirect(scene, 256, 8)) - direct).isEqualTo(4 * coarse);
        assertThat(LongRenderCheck.estimateRays(indirect(scene, 64, 4)) - direct).isEqualTo(4 * coarse);
    }

    private static Scene indirect(Scene scene, int rays, int spacing) {
        return scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, rays, spacing, false))));
    }

    @Test
    void estimate_blurredReflections_countsTheirRays() {
        Scene scene = scene(100, 100, lights(1));
        Scene rough =
                scene.withMaterials(scene.materials().stream().map(m -> m.withModel(ShadingModel.PRINCIPLED).withRoughness(0.4)).toList());
        assertThat(LongRenderCheck.estimateRays(rough)).isGreaterThan(LongRenderCheck.estimateRays(scene));
    }

    @Test
    void twentyFiveMillionRays_isLong() {
        assertThat(LongRenderCheck.isLong(scene(5_000, 2_500, lights(1)))).isTrue();
        assertThat(LongRenderCheck.isLong(scene(5_000, 2_499, lights(1)))).isFalse();
    }

    private static Scene scene(int width, int height, List<Light> lights) {
        return StudioScene.of(LightType.POINT).withLights(lights).withPicture(new PictureSettings(width, height, 0));
    }

    private static List<Light> lights(int count) {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            lights.add(Light.of("lamp" + i, LightType.POINT));
        }
        return lights;
    }
}

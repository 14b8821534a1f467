package lightning.render.relight;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests lights whose intensity and gain are above 0 as floats, and their product is not. */
class TinyLightTest {
    @ParameterizedTest
    @EnumSource
    void lightWithoutAProduct_isDark_beforeAndAfterEdits(MirrorStorage storage) {
        Scene studio = StudioScene.of(LightType.POINT);
        Light key = studio.light(StudioScene.KEY).orElseThrow();
        Light tiny = key.withName("tiny").withIntensity(1e-45).withInfluence(key.influence().withDiffuse(0).withSpecular(0.3));
        Scene before = studio.withLights(List.of(tiny, key));
        Scene swapped = studio.withLights(List.of(key, tiny));
        Scene moved = swapped.withNodes(swapped.nodes().subList(1, swapped.nodes().size()));
        Scene bright = moved.withLight(tiny.withIntensity(2).withPosition(new Vec3(1, 2, 1)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withStorage(storage).withThreads(1))) {
            for (Scene scene : List.of(before, swapped, moved, bright, moved)) {
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "tiny");
            }
        }
    }
}

package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.cache.TileLevel;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.shading.layer.LightRows;
import lightning.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the layers of surfels, which send light diffusely only. */
class SurfelLayersTest {
    private static final String SHINY = "material ball { diffuse 0.8 0.5 0.2  specular 0.5 0.5 0.5  shininess 20 }";
    private static final String METAL = "material ball { model metallic  base 0.8 0.5 0.2  metalness 0.3  roughness 0.4 }";
    private static final String LAMP = "light lamp point { at 0.5 0.8 0.5 }";
    private static final String PANEL = "light panel rect { at 0.5 0.8 0.5  direction 0 -1 0  width 0.6  height 0.6  samples 16 }";

    private static Scene scene(String ball, String light) throws JenException {
        return JenReader.read("""
                jen 1
                picture { size 48 36  indirect { bounces 2  rays 16  spacing 4 } }
                camera { from 0 0.5 3  to 0 -0.4 0  fov 50 }
                material floor { diffuse 0.8 0.8 0.8 }
                plane floor { material floor  at 0 -1 0  scale 3 1 3 }
                sphere ball { material ball  at 0 -0.5 0  scale 0.5 0.5 0.5 }
                """ + ball + "\n" + light + "\n", "ball.jen", Path.of("")).scene();
    }

    @ParameterizedTest
    @ValueSource(strings = {SHINY, METAL})
    void layers_haveNoSpecularTerms(String ball) throws JenException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene(ball, LAMP), Progress.NONE);
            List<LightRows> layers = Arrays.stream(renderer.cache().indirect().surfels()).map(TileLevel::layers).flatMap(Arrays::stream)
                    .map(LightRows.class::cast).toList();
            assertThat(layers).anyMatch(layer -> layer.cosine != null)
                    .allMatch(layer -> layer.specular == null && layer.grazing == null);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {LAMP, PANEL})
    void metalThatBecomesPaintAndMetalAgain_equalsFullTrace(String light) throws JenException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            for (String ball : List.of(METAL, SHINY, METAL)) {
                Scene scene = scene(ball, light);
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), "metal");
            }
        }
    }
}

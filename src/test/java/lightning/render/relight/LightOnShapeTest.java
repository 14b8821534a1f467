package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that shadow rays to a light end on the shape that it is on, and that later rays do not. */
class LightOnShapeTest {
    private static final String TEXT = """
            jen 1
            picture { size 8 8  depth 2 }
            camera { from -1.8 2.6 7 }
            material m0 { diffuse 0 0 0  specular 1 1 1  shininess 1  reflective 1 1 1 }
            plane floor { material m0  at 0 -1 0  scale 14 1 14 }
            cone n1 { material m0  at -2 -1 -2  rotate 1000000 -304.5222688156504 1000000  scale 0.3 0.3 0.3 }
            light l0 point { intensity 0.15  at 0 -1 0  direction -2.2 -1.2 -2.2 }
            """;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void storedMirrorHits_stayAtSamePoints(boolean lanes) throws Exception {
        Engine engine = lanes ? Engines.LANES : Engines.SCALAR;
        Scene target = JenReader.read(TEXT, "on-a-shape.jen", Path.of(".")).scene();
        Scene before = target.withLight(target.lights().getFirst().withType(LightType.DIRECTIONAL));
        RenderOptions options = RenderOptions.DEFAULT.withStorage(MirrorStorage.HIT_SHAPES).withThreads(1).withEngines(_ -> engine);
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(before, Progress.NONE);
            assertThat(renderer.cache().tile(0).hitShapes()).isNotEmpty();
            renderer.render(target, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(target).trace(), "light-on-a-shape");
        }
    }
}

package lightning.render.engine.choice;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.warmup.WarmUp;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the scalar engine is used if Java has no vector module, or narrow vectors. */
@Slow
class NarrowVectorsTest {

    @ParameterizedTest
    @ValueSource(strings = {"-XX:+IgnoreUnrecognizedVMOptions", "--add-modules=jdk.incubator.vector -XX:MaxVectorSize=8",
        "--add-modules=jdk.incubator.vector -XX:MaxVectorSize=16 -XX:+IgnoreUnrecognizedVMOptions -XX:UseAVX=0"})
    void renderEditAndWarmUp_useScalarEngineAndMatchReference(String options) throws Exception {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        line.addAll(Arrays.asList(options.split(" ")));
        line.addAll(List.of("-Xmx200m", "-cp", System.getProperty("java.class.path"), NarrowVectorProcess.class.getName()));
        Process java = new ProcessBuilder(line).redirectErrorStream(true).start();
        assertThat(new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).endsWith(NarrowVectorProcess.WANTED);
        assertThat(java.waitFor()).isZero();
    }

    /** Main class of the second JVM. */
    static final class NarrowVectorProcess {
        private static final String WANTED = "first pass: same bits, edit: same bits, lanes: false, scalar: true";

        public static void main(String[] arguments) {
            Scene scene = StudioScene.of(LightType.SPOT);
            Scene edited = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withIntensity(0.3));
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
                String first = compare(renderer, scene);
                WarmUp.run(scene, renderer.cache().geometry(), Progress.NONE);
                System.out.print("first pass: " + first + ", edit: " + compare(renderer, edited) + ", lanes: " + Engines.hasLanes()
                        + ", scalar: " + (Engines.CURRENT.forTile(0) == Engines.SCALAR));
            }
        }

        private static String compare(Renderer renderer, Scene scene) {
            renderer.render(scene, Progress.NONE);
            return renderer.film().hasSameBits(new ReferenceTracer(scene).trace()) ? "same bits" : "other bits";
        }
    }
}

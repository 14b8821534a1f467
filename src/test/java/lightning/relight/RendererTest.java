package lightning.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.RandomEdits;
import lightning.RandomScenes;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.ReferenceTracer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RendererTest {
    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void currentReflections_equalTheReferenceAfterEachEdit(MirrorStorage storage) {
        for (int seed = 0; seed < 40; seed++) {
            RandomEdits edits = new RandomEdits(seed);
            Scene scene = new RandomScenes(seed).scene(50, 40, 5, seed % 5);
            Scene first = scene;
            Options options = Options.DEFAULT.withReflections(Reflections.CURRENT).withStorage(storage);
            try (Renderer renderer = new Renderer(options)) {
                renderer.render(scene, Progress.NONE);
                for (int i = 0; i < 12; i++) {
                    scene = i == 7 ? first : edits.edit(scene);
                    Update update = renderer.render(scene, Progress.NONE);
                    assertThat(renderer.film().sameBits(new ReferenceTracer(scene).trace()))
                            .as("seed " + seed + " edit " + i + ": " + update.plan().text()).isTrue();
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void staleReflections_showTheSceneOfTheirLastUpdate(MirrorStorage storage) {
        for (int seed = 0; seed < 40; seed++) {
            RandomEdits edits = new RandomEdits(seed + 1000);
            Random random = new Random(seed);
            Scene scene = new RandomScenes(seed + 1000).scene(50, 40, 5, seed % 5);
            Scene mirrored = scene;
            try (Renderer renderer = new Renderer(Options.DEFAULT.withStorage(storage))) {
                renderer.render(scene, Progress.NONE);
                for (int i = 0; i < 12; i++) {
                    int depth = scene.picture().depth();
                    scene = edits.edit(scene);
                    Update update = renderer.render(scene, Progress.NONE);
                    mirrored = scene.picture().depth() == depth ? mirrored : scene;
                    if (random.nextInt(5) == 0) {
                        renderer.updateReflections(Progress.NONE);
                        mirrored = scene;
                    }
                    assertThat(renderer.film().sameBits(new ReferenceTracer(scene, mirrored).trace()))
                            .as("seed " + seed + " edit " + i + ": " + update.plan().text()).isTrue();
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void ratio_staysWithinItsReportedBound(MirrorStorage storage) {
        double largest = 0;
        int scaled = 0;
        for (int seed = 0; seed < 60; seed++) {
            RandomEdits edits = new RandomEdits(seed + 2000);
            Scene scene = new RandomScenes(seed + 2000).scene(50, 40, 5, 1 + seed % 4);
            Options options = Options.DEFAULT.withAccuracy(Accuracy.RATIO).withReflections(Reflections.CURRENT).withStorage(storage);
            try (Renderer renderer = new Renderer(options)) {
                renderer.render(scene, Progress.NONE);
                for (int i = 0; i < 12; i++) {
                    scene = edits.edit(scene);
                    Update update = renderer.render(scene, Progress.NONE);
                    float[] expected = new ReferenceTracer(scene).trace().toScanlines();
                    float[] actual = renderer.film().toScanlines();
                    double error = 0;
                    for (int v = 0; v < expected.length; v++) {
                        error = Math.max(error, Math.abs((double) expected[v] - actual[v]));
                    }
                    assertThat(error).as("seed " + seed + " edit " + i + ": " + update.plan().text())
                            .isLessThanOrEqualTo(update.errorBound());
                    largest = Math.max(largest, error / Math.max(1e-30, update.errorBound()));
                    scaled += error > 0 ? 1 : 0;
                }
            }
        }
        assertThat(scaled).as("updates that differ from the exact picture").isGreaterThan(30);
    }
}

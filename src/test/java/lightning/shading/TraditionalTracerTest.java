package lightning.shading;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.RandomScenes;
import lightning.image.Film;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class TraditionalTracerTest {
    @Test
    void everyValueEqualsTheReferenceTrace() {
        try (Workers workers = new Workers(2)) {
            for (int seed = 0; seed < 60; seed++) {
                Scene scene = new RandomScenes(seed).scene(70, 45, 6, seed % 7);
                Film expected = new ReferenceTracer(scene).trace();
                Film actual = new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
                assertThat(actual.sameBits(expected)).as("seed " + seed).isTrue();
            }
        }
    }
}

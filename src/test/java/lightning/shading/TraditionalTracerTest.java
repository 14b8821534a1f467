package lightning.shading;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.RandomEdits;
import lightning.RandomScenes;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.trace.Geometry;
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

    @Test
    void mirrorsOfAnotherScene_equalTheReferenceTrace() {
        try (Workers workers = new Workers(2)) {
            for (int seed = 0; seed < 40; seed++) {
                Scene mirrored = new RandomScenes(seed).scene(50, 40, 6, seed % 5);
                RandomEdits edits = new RandomEdits(seed);
                Scene scene = mirrored;
                for (int i = 0; i < 5; i++) {
                    scene = edits.edit(scene);
                }
                scene = scene.withPicture(mirrored.picture());
                Film expected = new ReferenceTracer(scene, mirrored).trace();
                Film actual = new TraditionalTracer(scene, mirrored, new Geometry(scene)).trace(workers, Progress.NONE).film();
                assertThat(actual.sameBits(expected)).as("seed " + seed).isTrue();
            }
        }
    }
}

package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.sample.IndirectScenes;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class TraceMemoryTest {
    private static Scene room(int width, int height) {
        Scene room = IndirectScenes.all().get("room");
        return room.withPicture(room.picture().withSize(width, height));
    }

    private static long pathBytes(Scene scene) {
        try (var renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            return renderer.cache().indirect().structure().buildBytes();
        }
    }

    @Test
    void pathsThatDoNotFit_areRejectedWithFittingSize() {
        Scene scene = room(400, 300);
        long memory = MemoryEstimate.filmBytes(scene.picture()) + pathBytes(scene) / 2;
        assertThatCode(() -> MemoryEstimate.checkFilm(scene.picture(), memory)).doesNotThrowAnyException();
        assertThatThrownBy(() -> TraceMemory.check(scene, memory)).isInstanceOf(PictureTooLargeException.class).message()
                .satisfies(message -> {
                    Matcher size = Pattern.compile("it would fit with a size of (\\d+)x(\\d+)").matcher(message);
                    assertThat(size.find()).isTrue();
                    Scene smaller = room(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
                    assertThatCode(() -> TraceMemory.check(smaller, memory)).doesNotThrowAnyException();
                    assertThat(MemoryEstimate.filmBytes(smaller.picture()) + pathBytes(smaller)).isBetween(memory / 3, memory);
                });
    }

    @Test
    void densePaths_areRejectedWithSparserOnes() {
        Scene scene = room(400, 300);
        long memory = MemoryEstimate.filmBytes(scene.picture()) + 4 * pathBytes(scene);
        assertThatCode(() -> TraceMemory.check(scene, memory)).doesNotThrowAnyException();
        Scene dense = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withRays(1024))));
        assertThatThrownBy(() -> TraceMemory.check(dense, memory)).isInstanceOf(PictureTooLargeException.class)
                .hasMessageContaining("indirect light of ");
    }

    @Test
    void sceneWithoutIndirectLight_needsItsFilm() {
        Scene scene = room(800, 600).withoutIndirect();
        assertThatCode(() -> TraceMemory.check(scene, MemoryEstimate.filmBytes(scene.picture()))).doesNotThrowAnyException();
        assertThatThrownBy(() -> TraceMemory.check(scene, MemoryEstimate.filmBytes(scene.picture()) - 1))
                .isInstanceOf(PictureTooLargeException.class);
    }
}

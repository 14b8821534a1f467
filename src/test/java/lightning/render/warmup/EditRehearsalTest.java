package lightning.render.warmup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

class EditRehearsalTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    @Test
    void edits_changeIntensityColorAndPlaceOfOneLightEach() {
        Scene scene = DeskScene.scene();
        List<Scene> edits = EditRehearsal.edits(scene);
        assertThat(edits).hasSize(4).allSatisfy(edited -> {
            assertThat(edited.lights()).usingElementComparator((a, b) -> a.equals(b) ? 0 : 1).isNotEqualTo(scene.lights());
            assertThat(edited.hasSameView(scene)).isTrue();
        });
        assertThat(edits.getFirst().light("key").map(Light::intensity)).hasValueSatisfying(v -> assertThat(v).isLessThan(1));
        assertThat(edits.getLast().light("fill")).isNotEqualTo(scene.light("fill"));
    }

    @Test
    void sceneWithoutLightsThatAreOn_hasNoEdits() {
        Scene scene = DeskScene.scene();
        assertThat(EditRehearsal.edits(scene.withLights(scene.lights().stream().map(light -> light.withOn(false)).toList()))).isEmpty();
    }

    @Test
    void rehearsal_leavesThePictureAsItIs() {
        Scene scene = DeskScene.scene();
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            Film before = renderer.film().copy();
            EditRehearsal.run(renderer.cache(), OPTIONS, Progress.NONE);
            assertThat(renderer.film().hasSameBits(before)).isTrue();
            assertThat(renderer.scene()).isSameAs(scene);
        }
    }

    @Test
    void canceledRehearsal_stops() {
        var calls = new AtomicInteger();
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(DeskScene.scene(), Progress.NONE);
            assertThatThrownBy(() -> EditRehearsal.run(renderer.cache(), OPTIONS, Progress.cancellation(() -> calls.incrementAndGet() > 3)))
                    .isInstanceOf(CancellationException.class);
        }
    }
}

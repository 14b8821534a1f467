package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Memory checks of a renderer that renders pixel centers first. */
class MemoryCheckTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private static Scene scene(int width, int height, AntialiasMode antialias, int grid) {
        Scene scene = DeskScene.scene();
        return scene.withPicture(scene.picture().withSize(width, height).withSampling(new SamplingSettings(antialias, grid)));
    }

    private static long centerBytes(Scene scene) {
        try (var renderer = new Renderer(OPTIONS)) {
            renderer.renderCenters(renderer.plan(scene), Progress.NONE);
            return renderer.state().bytes();
        }
    }

    @Test
    void centersThatFit_areAcceptedWhateverTheirSamplesNeed() {
        Scene scene = scene(400, 300, AntialiasMode.EDGES, 8);
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(scene) * 5 / 4))) {
            renderer.requireMemory(scene, 0, Progress.NONE, _ -> {});
            renderer.renderCenters(renderer.plan(scene), Progress.NONE);
            Film centers = renderer.film();
            assertThatThrownBy(() -> renderer.finish(Progress.NONE)).isInstanceOf(PictureTooLargeException.class)
                    .hasMessageContaining("it would fit with");
            assertThat(renderer.state().isFinished()).isFalse();
            assertThat(renderer.film().hasSameBits(centers)).isTrue();
        }
    }

    @Test
    void picture_isCheckedWithItsSamples() {
        Scene scene = scene(400, 300, AntialiasMode.EDGES, 8);
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(scene) * 5 / 4))) {
            assertThatThrownBy(() -> renderer.render(scene, Progress.NONE)).isInstanceOf(PictureTooLargeException.class);
            assertThat(renderer.state().hasPicture()).isFalse();
        }
    }

    @Test
    void samplesThatAnEditAdds_areChecked() {
        Scene plain = scene(400, 300, AntialiasMode.OFF, 8);
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(plain) * 6 / 5))) {
            renderer.render(plain, Progress.NONE);
            assertThatThrownBy(() -> renderer.render(scene(400, 300, AntialiasMode.EDGES, 8), Progress.NONE))
                    .isInstanceOf(PictureTooLargeException.class);
            assertThat(renderer.scene()).isEqualTo(plain);
        }
    }

    @Test
    void centersThatDoNotFit_areRejectedWithSizeThatDoes() {
        Scene scene = scene(800, 600, AntialiasMode.EDGES, 4);
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(scene) / 2))) {
            assertThatThrownBy(() -> renderer.requireMemory(scene, 0, Progress.NONE, _ -> {}))
                    .isInstanceOf(PictureTooLargeException.class).hasMessageContaining("a size of").hasMessageNotContaining("samples");
        }
    }

    @Test
    void forecast_showsItsPicturesOnce() {
        Scene scene = scene(800, 600, AntialiasMode.OFF, 4);
        List<Film> seen = new ArrayList<>();
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(scene) * 6 / 5))) {
            renderer.requireMemory(scene, 0, Progress.NONE, seen::add);
            assertThat(seen).isNotEmpty().allSatisfy(film -> assertThat(film.width()).isLessThan(400));
            int count = seen.size();
            renderer.requireMemory(scene, 1000, Progress.NONE, seen::add);
            assertThat(seen).hasSize(count);
        }
    }

    @Test
    void forecast_isCancelable() {
        Scene scene = scene(800, 600, AntialiasMode.EDGES, 4);
        try (var renderer = new Renderer(OPTIONS.withMemory(centerBytes(scene) * 6 / 5))) {
            assertThatThrownBy(() -> renderer.requireMemory(scene, 0, new CancelingProgress(3), _ -> {}))
                    .isInstanceOf(CancellationException.class);
            assertThatCode(() -> renderer.requireMemory(scene, 0, Progress.NONE, _ -> {})).doesNotThrowAnyException();
        }
    }
}

package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class LitPicturesTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    /** A rough metal that reflects a wall; only reflections show an edit of its roughness. */
    private static Scene scene(double roughness) throws JenException {
        return JenReader.read("""
                jen 1
                picture { size 400 300 }
                camera { from 0 2 5  to 0 0 0  fov 40 }
                world { ambience 0 }
                material metal { model principled  base 0.9 0.9 0.9  metalness 1  roughness ROUGHNESS }
                material bright { diffuse 0 0 0  glow 1 1 1 }
                plane floor { material metal  scale 9 1 9 }
                plane back { material bright  at 0 0.5 -2  rotate 90 0 0  scale 3 1 0.5 }
                """.replace("ROUGHNESS", Double.toString(roughness)), "metal", Path.of(".")).scene();
    }

    private static double difference(Film a, Film b) {
        double sum = 0;
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                sum += Math.abs(a.red(x, y) - b.red(x, y));
            }
        }
        return sum;
    }

    @Test
    void previewOfARoughness_showsItsReflections() throws JenException {
        Scene before = scene(0.3);
        Scene after = scene(0.6);
        try (var renderer = new Renderer(OPTIONS); var preview = new EditPreview(renderer)) {
            renderer.render(before, Progress.NONE);
            preview.prepareLit(renderer.cache(), Progress.NONE);
            Film estimate = preview.traceLit(preview.before(), RenderedScenes.of(after), Progress.NONE).orElseThrow();
            Film last = renderer.film().copy();
            renderer.render(after, Progress.NONE);
            assertThat(difference(estimate, renderer.film())).isLessThan(0.5 * difference(last, renderer.film()));
        }
    }

    @Test
    void noPicture_isThereBeforeTheFirst() throws JenException {
        try (var pictures = new LitPictures(OPTIONS); var renderer = new Renderer(OPTIONS)) {
            Scene scene = scene(0.3);
            assertThat(pictures.of(scene, Progress.NONE)).isEmpty();
            assertThat(pictures.expectedSeconds(scene)).isInfinite();
            pictures.prepare(scene, renderer.prepare(scene), Progress.NONE);
            assertThat(pictures.of(scene, Progress.NONE)).isPresent();
            assertThat(pictures.expectedSeconds(scene)).isFinite();
            assertThat(pictures.expectedSeconds(scene.withCamera(scene.camera().withOrigin(new Vec3(0, 3, 5))))).isInfinite();
        }
    }

    @Test
    void sceneWithoutGatheredLight_hasNone() throws JenException {
        Scene scene = JenReader.read("jen 1\nsphere ball {}\n", "ball", Path.of(".")).scene();
        try (var pictures = new LitPictures(OPTIONS); var renderer = new Renderer(OPTIONS)) {
            pictures.prepare(scene, renderer.prepare(scene), Progress.NONE);
            assertThat(pictures.of(scene, Progress.NONE)).isEmpty();
        }
    }
}

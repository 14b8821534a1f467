package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Tests light contributions to a few pixels. */
@Slow
class LightThumbnailsTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void lightThumbnail_matchesLightImageBits(@ForAll("sessions") EditSession session, @ForAll Accuracy accuracy,
            @ForAll ReflectionMode reflections, @ForAll @IntRange(min = 1, max = 70) int width,
            @ForAll @IntRange(min = 1, max = 70) int height, @ForAll boolean indirect) {
        RenderOptions options = new RenderOptions(accuracy, reflections, MirrorStorage.FULL_ROWS, 1);
        try (Renderer renderer = new Renderer(options); Renderer direct = new Renderer(options)) {
            for (Scene drawn : session.timedScenes()) {
                Scene scene = drawn.picture().sampling().antialias() == AntialiasMode.EVERY ? drawn
                        : drawn.withPicture(drawn.picture().withSampling(lightning.scene.SamplingSettings.DEFAULT));
                Scene shown = indirect ? IndirectScenes.with(scene) : scene;
                renderer.render(shown, Progress.NONE);
                direct.render(scene, Progress.NONE);
                LightThumbnails small = LightThumbnails.of(renderer.cache(), width, height);
                LightThumbnails all = LightThumbnails.of(renderer.cache(), width, height, new IndirectByLight(renderer.cache()),
                        Progress.NONE);
                assertThat(all.hasAllLight()).isTrue();
                if (GatherSettings.of(shown).isPresent()) {
                    assertThat(small.hasAllLight()).isFalse();
                } else if (session.scenes().stream().allMatch(s -> s.world().environment().isEmpty())) {
                    // Else paths of an earlier environment may stay.
                    assertThat(small.hasAllLight()).isEqualTo(!indirect);
                }
                assertThat(small.width()).isLessThanOrEqualTo(width);
                assertThat(small.height()).isLessThanOrEqualTo(height);
                if (scene.picture().sampling().antialias() != AntialiasMode.EVERY) {
                    for (int l = 0; l < scene.lights().size(); l++) {
                        // Without indirect light, rough surfaces reflect lit ones.
                        if (GatherSettings.of(scene).map(settings -> !settings.reflections()).orElse(true)) {
                            assertPixels(small, small.lightImage(l), direct.lightImage(scene.lights().get(l).name(), Progress.NONE), scene);
                        }
                        assertPixels(all, all.lightImage(l), renderer.lightImage(scene.lights().get(l).name(), Progress.NONE), scene);
                    }
                }
                assertPixels(small, small.image(), renderer.film(), scene);
            }
        }
    }

    private static void assertPixels(LightThumbnails small, float[] found, Film film, Scene scene) {
        for (int y = 0; y < small.height(); y++) {
            for (int x = 0; x < small.width(); x++) {
                int px = (2 * x + 1) * scene.picture().width() / (2 * small.width());
                int py = (2 * y + 1) * scene.picture().height() / (2 * small.height());
                int i = 3 * (y * small.width() + x);
                assertThat(new float[] {found[i], found[i + 1], found[i + 2]}).as("pixel %d %d", px, py)
                        .containsExactly(film.red(px, py), film.green(px, py), film.blue(px, py));
            }
        }
    }
}

package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Tests contributions to a few pixels. */
@Slow
class LightThumbnailsTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void thumbnail_hasTheBitsOfTheContribution(@ForAll("sessions") EditSession session, @ForAll Accuracy accuracy,
            @ForAll ReflectionMode reflections, @ForAll @IntRange(min = 1, max = 70) int width,
            @ForAll @IntRange(min = 1, max = 70) int height, @ForAll boolean indirect) {
        RenderOptions options = new RenderOptions(accuracy, reflections, MirrorStorage.FULL_ROWS, 1);
        try (Renderer renderer = new Renderer(options)) {
            for (Scene drawn : session.timedScenes()) {
                Scene scene = indirect ? IndirectScenes.with(drawn) : drawn;
                renderer.render(scene, Progress.NONE);
                LightThumbnails small = LightThumbnails.of(renderer.cache(), options, width, height, Progress.NONE);
                assertThat(small.width()).isLessThanOrEqualTo(width);
                assertThat(small.height()).isLessThanOrEqualTo(height);
                for (Contribution contribution : Contribution.all(scene)) {
                    assertPixels(small, small.sum(List.of(contribution)), renderer.contribution(contribution, Progress.NONE), scene);
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

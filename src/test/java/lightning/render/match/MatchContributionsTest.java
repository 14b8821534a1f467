package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.sample.IndirectScenes;
import lightning.sample.StudioScene;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

class MatchContributionsTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private final Scene scene = IndirectScenes.with(StudioScene.withFourLights(30, 24));
    private final Light fill = scene.light("fill").orElseThrow();

    @Test
    void editedValues_onlyScale() {
        assertLikeNew(scene.withLight(fill.withIntensity(3).withColor(new Rgb(1, 0.5, 0.2))), 0);
    }

    @Test
    void movedLight_isComposedAlone() {
        assertLikeNew(scene.withLight(fill.withPosition(new Vec3(-3, 3, 1))), 1);
    }

    @Test
    void lightThatIsSwitchedOn_isComposedAlone() {
        assertLikeNew(scene.withLight(fill.withOn(false)), scene, 1);
    }

    /** A factor of the color of a black light is unknown. */
    @Test
    void lightThatWasBlack_isComposedAlone() {
        assertLikeNew(scene.withLight(fill.withColor(new Rgb(0, 1, 1))), scene, 1);
    }

    @Test
    void otherDepthOfReflections_composesAll() {
        assertLikeNew(scene.withPicture(scene.picture().withDepth(1)), 4);
    }

    private void assertLikeNew(Scene edited, int composed) {
        assertLikeNew(scene, edited, composed);
    }

    private static void assertLikeNew(Scene before, Scene edited, int composed) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(before, Progress.NONE);
            MatchContributions known = MatchContributions.of(renderer.cache(), OPTIONS, Optional.empty(), Progress.NONE);
            renderer.render(edited, Progress.NONE);
            List<Integer> totals = new ArrayList<>();
            Progress counting = new Progress() {
                @Override
                public void report(int done, int total) {
                    totals.add(total);
                }

                @Override
                public boolean isCanceled() {
                    return false;
                }
            };
            MatchContributions reused = MatchContributions.of(renderer.cache(), OPTIONS, Optional.of(known), counting);
            assertThat(totals.getLast()).isEqualTo(composed);
            MatchContributions fresh = MatchContributions.of(renderer.cache(), OPTIONS, Optional.empty(), Progress.NONE);
            for (Contribution part : Contribution.shining(edited)) {
                for (int c = 0; c < 3; c++) {
                    for (int i = 0; i < 30 * 24; i++) {
                        float expected = fresh.image(part)[c][i];
                        assertThat(reused.image(part)[c][i]).isCloseTo(expected, within(1e-5f * expected + 1e-9f));
                    }
                }
            }
        }
    }
}

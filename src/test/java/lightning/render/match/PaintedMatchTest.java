package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import org.junit.jupiter.api.Test;

/** Paint on a floor where two spots light two separate places, seen from above: x grows to the right in the picture. */
class PaintedMatchTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final int WIDTH = 40;
    private static final int HEIGHT = 20;
    private static final String FLOOR = """
            jen 1
            picture { size 40 20 }
            camera { from 0 10 0  to 0 0 0  up 0 0 -1  fov 40 }
            world { ambience 0 }
            material paint { diffuse 1 1 1 }
            plane floor { material paint  scale 40 1 40 }
            """;
    private static final String SPOTS = """
            light left spot { at -3 4 0  direction 0 -1 0  angle 15 }
            light right spot { at 3 4 0  direction 0 -1 0  angle 15 }
            """;
    private static final String FILL = "light fill directional { direction 0 -1 0  intensity 0.3 }\n";
    private static final Set<MatchChange> COLORS = Set.of(MatchChange.COLORS);

    private static Scene scene(String lights) {
        try {
            return JenReader.read(FLOOR + lights, "floor.jen", Path.of("scenes")).scene();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private record Painted(Scene scene, Film before, BrushDab.Wish[] wishes, MatchResult result) {
        /** Returns the mean of a channel of pixels with paint, or without it, relative to what it was; only lit ones count. */
        double change(boolean isPainted, int channel) {
            float[] was = before.toScanlines();
            float[] now = film(MatchedScene.of(scene, result)).toScanlines();
            double sum = 0;
            int count = 0;
            for (int i = channel; i < was.length; i += 3) {
                if (was[i] > 0 && wishes[i / 3] != null == isPainted) {
                    sum += now[i] / was[i];
                    count++;
                }
            }
            return sum / count;
        }

        LightFactor factor(String light) {
            return result.factors().stream().filter(f -> f.light().equals(new SceneElement.OfLight(light))).findFirst().orElseThrow();
        }
    }

    private static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film().copy();
        }
    }

    /** Paints a short stroke at the place of the left spot. */
    private static Painted paintLeft(String lights, BrushDab.Wish wish, Set<MatchChange> changes) {
        Scene scene = scene(lights);
        int center = left(scene);
        List<BrushDab> dabs = new ArrayList<>();
        for (int i = -1; i <= 1; i++) {
            dabs.add(new BrushDab(wish, center + i + 0.5, HEIGHT / 2.0, 1.5));
        }
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            Film film = renderer.film().copy();
            MatchResult result = LightMatch.of(renderer.cache(), OPTIONS, PaintedReference.of(film, dabs),
                    new MatchSettings(Optional.empty(), changes, MatchSettings.Reference.FIXED, MatchSettings.Reference.FIXED,
                            MatchSettings.PAINTED),
                    Progress.NONE);
            return new Painted(scene, film, PaintedReference.wishes(WIDTH, HEIGHT, dabs), result);
        }
    }

    /** Returns the column where the left spot is brightest. */
    private static int left(Scene scene) {
        Film film = film(scene);
        int best = 0;
        for (int x = 0; x < WIDTH / 2; x++) {
            best = film.green(x, HEIGHT / 2) > film.green(best, HEIGHT / 2) ? x : best;
        }
        return best;
    }

    @Test
    void brighterPaint_raisesOnlyTheSpotThere() {
        Painted painted = paintLeft(SPOTS, BrushDab.Wish.BRIGHTER, Set.of());
        assertThat(painted.factor("left").red()).isCloseTo(2, within(0.1));
        assertThat(painted.factor("right")).isEqualTo(new LightFactor(new SceneElement.OfLight("right"), 1, 1, 1));
    }

    @Test
    void fillThatLightsAll_staysWhereASpotCanDoIt() {
        Painted painted = paintLeft(SPOTS + FILL, BrushDab.Wish.BRIGHTER, Set.of());
        assertThat(painted.factor("fill")).isEqualTo(new LightFactor(new SceneElement.OfLight("fill"), 1, 1, 1));
        assertThat(painted.factor("right")).isEqualTo(new LightFactor(new SceneElement.OfLight("right"), 1, 1, 1));
        assertThat(painted.change(true, 1)).isCloseTo(2, within(0.1));
        assertThat(painted.change(false, 1)).isCloseTo(1, within(0.05));
    }

    @Test
    void darkerPaint_dimsOnlyTheSpotThere() {
        Painted painted = paintLeft(SPOTS + FILL, BrushDab.Wish.DARKER, Set.of());
        assertThat(painted.factor("fill")).isEqualTo(new LightFactor(new SceneElement.OfLight("fill"), 1, 1, 1));
        assertThat(painted.factor("left").red()).isLessThan(0.6);
        assertThat(painted.change(true, 1)).isCloseTo(0.5, within(0.1));
        assertThat(painted.change(false, 1)).isCloseTo(1, within(0.05));
    }

    @Test
    void warmerAndCoolerPaint_tintOnlyTheSpotThere() {
        for (BrushDab.Wish wish : List.of(BrushDab.Wish.WARMER, BrushDab.Wish.COOLER)) {
            Painted painted = paintLeft(SPOTS + FILL, wish, COLORS);
            assertThat(painted.factor("fill")).isEqualTo(new LightFactor(new SceneElement.OfLight("fill"), 1, 1, 1));
            assertThat(painted.factor("right")).isEqualTo(new LightFactor(new SceneElement.OfLight("right"), 1, 1, 1));
            for (int c = 0; c < 3; c++) {
                assertThat(painted.change(true, c)).isCloseTo(wish.factor(c), within(0.06));
                assertThat(painted.change(false, c)).isCloseTo(1, within(0.03));
            }
        }
    }

    /** Without a spot there, the only light that can do it changes. */
    @Test
    void onlyLightThere_changesThoughItLightsAll() {
        Painted painted = paintLeft(FILL, BrushDab.Wish.BRIGHTER, Set.of());
        assertThat(painted.factor("fill").red()).isBetween(1.85, 2.0);
    }

    @Test
    void lightThatDoesNotReachPaint_isNotDimmedToBalanceIt() {
        Painted painted = paintLeft(FILL + "light right spot { at 3 4 0  direction 0 -1 0  angle 15 }\n", BrushDab.Wish.BRIGHTER, Set.of());
        assertThat(painted.factor("right")).isEqualTo(new LightFactor(new SceneElement.OfLight("right"), 1, 1, 1));
    }

    @Test
    void keepPaint_changesNothing() {
        Painted painted = paintLeft(SPOTS + FILL, BrushDab.Wish.KEEP, Set.of());
        assertThat(painted.result().factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(1, within(1e-3)));
    }

    @Test
    void errors_areThoseOfThePaint() {
        Painted painted = paintLeft(SPOTS, BrushDab.Wish.BRIGHTER, Set.of());
        assertThat(painted.result().errorBefore()).as("half of what is asked for").isCloseTo(0.5, within(0.05));
        assertThat(painted.result().errorAfter()).isLessThan(0.05);
    }
}

package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.FineTile;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.scene.Contribution;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.light.Light;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Tests the contributions of lights and environments that add up to a picture. */
@Slow
class PictureFilmsTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    /** Relative rounding of the sums of some lights at some levels of mirrors. */
    private static final float ROUNDING = 1e-4f;

    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.oneOf(List.of(EditSession.mixedSessions(), EditSession.environmentSessions(), EditSession.fogSessions()));
    }

    /** What no light and no environment sends is the picture of the scene without them: glowing materials, ambient light, a background. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void contributionsAndLightlessPicture_addUpToThePicture(@ForAll("sessions") EditSession session) {
        try (Renderer renderer = new Renderer(OPTIONS); Renderer lightless = new Renderer(OPTIONS)) {
            for (Scene scene : session.timedScenes()) {
                Scene single = withoutEdges(scene);
                renderer.render(single, Progress.NONE);
                lightless.restore(renderer.cache());
                lightless.render(dark(single), Progress.NONE);
                assertAddUp(renderer.film(), lightless.film(), films(renderer.cache()), session);
            }
        }
    }

    /** Pictures are divided with and without finer samples, after each edit. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void contributions_needNoFinerSamples(@ForAll("sessions") EditSession session) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            for (Scene scene : session.timedScenes()) {
                renderer.render(scene, Progress.NONE);
                PixelCache cache = renderer.cache();
                Map<Contribution, Film> films = films(cache);
                assertThat(films.keySet()).containsExactlyInAnyOrderElementsOf(Contribution.shining(scene));
                if (cache.tileCount() > 0) {
                    PixelCache centers = cache.withFineTiles(new FineTile[0]);
                    assertThat(films(centers)).hasSameSizeAs(films);
                    assertThat(LightShares.of(centers, OPTIONS, Progress.NONE).of(new Contribution.OfRest())).isBetween(0.0, 1.0);
                    assertThat(LightContributions.of(centers, OPTIONS, ViewTransform.DEFAULT,
                            LightContributions.Region.ofFilm(centers.film()), Progress.NONE).lights())
                            .hasSameSizeAs(Contribution.sources(scene));
                }
            }
        }
    }

    private static Map<Contribution, Film> films(PixelCache cache) {
        Map<Contribution, Film> films = new HashMap<>();
        new PictureFilms(cache, OPTIONS).forEachShining(Progress.NONE, films::put);
        return films;
    }

    private static void assertAddUp(Film picture, Film lightless, Map<Contribution, Film> films, EditSession session) {
        float[] sum = lightless.toScanlines();
        float[] scale = lightless.toScanlines();
        for (Film film : films.values()) {
            float[] part = film.toScanlines();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += part[i];
                scale[i] = Math.max(scale[i], part[i]);
            }
        }
        float[] whole = picture.toScanlines();
        for (int i = 0; i < sum.length; i++) {
            assertThat(sum[i]).as("%s at %s", session, i).isCloseTo(whole[i], within(ROUNDING * (scale[i] + whole[i]) + 1e-6f));
        }
    }

    private static Scene withoutEdges(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
    }

    /** Returns the scene without the light of what shines; what a solo darkens stays as it is. */
    private static Scene dark(Scene scene) {
        List<Contribution> shining = Contribution.shining(scene);
        List<Light> lights = new ArrayList<>(scene.lights().stream().map(light -> light.withOn(false)).toList());
        Scene dark = scene.withLights(lights);
        for (Contribution environment : Contribution.environments(scene)) {
            dark = shining.contains(environment) ? environment.with(dark, v -> v.withIntensity(0))
                    : dark.withWorld(withoutGain(dark.world(), environment));
        }
        return dark;
    }

    private static World withoutGain(World world, Contribution environment) {
        return environment instanceof SceneElement.OfDome(String name)
                ? world.withDome(name, world.domeOrOwn(name).orElseThrow().withGain(0))
                : world.withOwn(own -> own.withGain(0));
    }
}

package lightning.review.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.PictureFilms;
import lightning.render.relight.Renderer;
import lightning.review.LightWeights;
import lightning.sample.JenScenes;
import lightning.sample.StudioScene;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class LiveLayersTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private static Scene scene() {
        Scene studio = StudioScene.withFourLights(24, 16);
        return studio.withRig(studio.rig().addLightGroup(LightGroup.of("soft"))
                .withLights(
                        studio.lights().stream().map(light -> light.name().equals("sun") ? light : light.withLightGroup("soft")).toList()));
    }

    private static PixelCache cache(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return renderer.cache();
        }
    }

    /** Asserts that the layers with their weights are the lights of the picture, apart from their rounding to halves. */
    private static void assertShow(LiveLayers layers, PixelCache cache) {
        Map<Contribution, float[]> films = new HashMap<>();
        new PictureFilms(cache, OPTIONS).forEachShining(Progress.NONE, (name, film) -> films.put(name, film.toScanlines()));
        for (LiveLayers.Part part : layers.parts()) {
            float[] weight = LightWeights.of(cache.scene(), layers.base(), part.light());
            float[] wanted = films.getOrDefault(part.light(), new float[part.halves().length]);
            for (int i = 0; i < wanted.length; i++) {
                float shown = weight[i % 3] * Float.float16ToFloat(part.halves()[i]);
                assertThat(shown).isCloseTo(wanted[i], within(wanted[i] / 1000 + 1e-6f));
            }
        }
    }

    @Property(tries = 20)
    void layers_areTheLightsOfThePicture(@ForAll @IntRange(max = 3) int which, @ForAll @DoubleRange(max = 3) double intensity,
            @ForAll @DoubleRange(max = 1) double red, @ForAll boolean on, @ForAll boolean solo, @ForAll boolean groupOn) {
        Scene scene = scene();
        Light light = scene.lights().get(which);
        Scene edited = scene.withLight(light.withIntensity(intensity).withColor(new Rgb(red, 1, 0)).withOn(on).withSolo(solo));
        edited = edited.withRig(edited.rig().with(edited.rig().lightGroup("soft").orElseThrow().withOn(groupOn)));
        LiveLayers first = LiveLayers.of(cache(scene), OPTIONS, List.of(), Progress.NONE);
        assertShow(first, cache(scene));
        LiveLayers second = LiveLayers.of(cache(edited), OPTIONS, List.of(first), Progress.NONE);
        assertThat(second.parts()).isSameAs(first.parts());
        assertShow(second, cache(edited));
        assertShow(LiveLayers.of(cache(edited), OPTIONS, List.of(), Progress.NONE), cache(edited));
    }

    @Test
    void environments_haveTheirOwnLayers() {
        Scene sky = JenScenes.withSky(scene());
        Scene scene = sky.withWorld(sky.world().withNamed(List.of(JenScenes.dome("studio", 2), JenScenes.dome("off", 1).withOn(false))));
        LiveLayers first = LiveLayers.of(cache(scene), OPTIONS, List.of(), Progress.NONE);
        assertThat(first.parts()).extracting(LiveLayers.Part::light).isEqualTo(Contribution.sources(scene));
        assertShow(first, cache(scene));
        Contribution studio = new SceneElement.OfDome("studio");
        for (Scene edited : List.of(studio.with(scene, v -> v.withIntensity(0.5)), studio.with(scene, v -> v.withSolo(true)),
                studio.with(scene, v -> v.withOn(false)), Contribution.ENVIRONMENT.with(scene, v -> v.withIntensity(0)),
                new SceneElement.OfDome("off").with(scene, v -> v.withOn(true)))) {
            LiveLayers second = LiveLayers.of(cache(edited), OPTIONS, List.of(first), Progress.NONE);
            assertThat(second.parts()).isSameAs(first.parts());
            assertShow(second, cache(edited));
        }
    }

    @Test
    void movedLight_getsItsLayerAgain() {
        Scene scene = scene();
        LiveLayers first = LiveLayers.of(cache(scene), OPTIONS, List.of(), Progress.NONE);
        Light key = scene.light("key").orElseThrow();
        Scene moved = scene.withLight(key.withPosition(key.position().times(0.5)));
        LiveLayers second = LiveLayers.of(cache(moved), OPTIONS, List.of(first), Progress.NONE);
        for (int i = 0; i < first.parts().size(); i++) {
            boolean isKey = first.parts().get(i).light().equals(Contribution.of(key));
            assertThat(second.parts().get(i).layer().id().equals(first.parts().get(i).layer().id())).isEqualTo(!isKey);
        }
    }

    @Test
    void values_ofASceneLeaveItAsItIs() {
        Scene scene = scene();
        assertThat(LiveState.of(scene).applyTo(scene)).isEqualTo(scene);
    }
}

package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Tests when the films of a scene are kept whose pixels are composed quickly. */
class KeptFilmsTest {
    private static final Scene SCENE = StudioScene.of(LightType.POINT);
    private static final Light LIGHT = SCENE.lights().getFirst();
    private final Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));

    @AfterEach
    void close() {
        renderer.close();
    }

    private boolean keepsFilmsOf(Scene scene) {
        renderer.render(scene, Progress.NONE);
        return renderer.cache().keepsFilms();
    }

    @Test
    void firstPass_keepsNone() {
        assertThat(keepsFilmsOf(SCENE)).isFalse();
    }

    @Test
    void editsOfWeights_keepThem() {
        keepsFilmsOf(SCENE);
        assertThat(keepsFilmsOf(SCENE.withLight(LIGHT.withIntensity(1.01 * LIGHT.intensity())))).isTrue();
        assertThat(keepsFilmsOf(SCENE.withLight(LIGHT.withIntensity(3 * LIGHT.intensity())))).isTrue();
    }

    @Test
    void otherEdit_dropsThem() {
        keepsFilmsOf(SCENE);
        Light brighter = LIGHT.withIntensity(1.01 * LIGHT.intensity());
        assertThat(keepsFilmsOf(SCENE.withLight(brighter))).isTrue();
        assertThat(keepsFilmsOf(SCENE.withLight(brighter.withPosition(LIGHT.position().plus(new Vec3(0.1, 0, 0)))))).isFalse();
    }

    @Test
    void withoutMemory_noneIsKept() {
        keepsFilmsOf(SCENE);
        renderer.setOptions(renderer.options().withMemory(renderer.cache().bytes()));
        assertThat(keepsFilmsOf(SCENE.withLight(LIGHT.withIntensity(1.01 * LIGHT.intensity())))).isFalse();
    }

    @Test
    void editOfWeight_countsTheBytesOfItsFilms() {
        keepsFilmsOf(SCENE);
        keepsFilmsOf(SCENE.withLight(LIGHT.withIntensity(1.01 * LIGHT.intensity())));
        UpdateResult edit = renderer.render(SCENE.withLight(LIGHT.withIntensity(1.02 * LIGHT.intensity())), Progress.NONE);
        long written = 12L * SCENE.picture().width() * SCENE.picture().height();
        // Colors are written, and at least the light's film is read where it is not black.
        assertThat(edit.rowsComposed()).isZero();
        assertThat(edit.bytesMoved()).isGreaterThan(written * 5 / 4);
    }

    /** While one weight changes, the films beside it are read as sums. Others in between must not use them. */
    @Test
    void fadersOfManyLights_equalFullTrace() {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < 13; i++) {
            lights.add(LIGHT.withName("light " + i).withPosition(LIGHT.position().plus(new Vec3(0.1 * i, 0, 0.05 * i)))
                    .withColor(new Rgb(1, 0.1 * (i % 7), 0.3)).withIntensity(0.1 + 0.03 * i));
        }
        Scene scene = SCENE.withLights(lights)
                .withPicture(SCENE.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 3)));
        renderer.render(scene, Progress.NONE);
        int[] faded = {4, 4, 4, 12, 12, 0, 4, 0, 0};
        for (int edit = 0; edit < faded.length; edit++) {
            Light light = scene.lights().get(faded[edit]);
            Rgb color = light.color();
            scene = scene.withLight(edit % 3 == 2 ? light.withColor(new Rgb(0.99 * color.r(), color.g(), color.b()))
                    : light.withIntensity(1.01 * light.intensity()));
            renderer.render(scene, Progress.NONE);
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(scene).trace())).as("edit %d", edit).isTrue();
        }
    }
}

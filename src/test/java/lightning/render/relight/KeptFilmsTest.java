package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.relight.tile.RenderOptions;
import lightning.sample.StudioScene;
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
}

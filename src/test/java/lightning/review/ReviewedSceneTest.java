package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.sample.JenScenes;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import org.junit.jupiter.api.Test;

class ReviewedSceneTest {
    private static final Scene DARK = JenScenes.of("light environment point { intensity 3 }\nlight key point { }");

    private static Scene reviewed(Scene scene, boolean isEnvironment, double stops, boolean solo) {
        return reviewed(scene, isEnvironment ? Contribution.ENVIRONMENT : new SceneElement.OfLight("environment"), true, stops, solo);
    }

    private static Scene reviewed(Scene scene, Contribution light, boolean areTogether, double stops, boolean solo) {
        var change = new Review.LightChange(light, areTogether, Optional.of(stops), List.of(1.0, 1.0, 1.0), 3,
                List.of(1.0, 1.0, 1.0), false, solo);
        return ReviewedScene.of(scene, new Review("a", "", 0, List.of(change), List.of(), List.of())).scene();
    }

    private static Scene withoutLamp(Scene scene) {
        return scene.withLights(List.of(scene.light("key").orElseThrow()));
    }

    @Test
    void lightNamedEnvironment_takesTheChangeOfItsFader() {
        Scene changed = reviewed(JenScenes.withSky(DARK), false, 1, false);
        assertThat(changed.light("environment").orElseThrow().intensity()).isEqualTo(6);
        assertThat(changed.world()).isEqualTo(JenScenes.withSky(DARK).world());
    }

    @Test
    void environmentOfAPage_isNeverALight() {
        Scene changed = reviewed(JenScenes.withSky(DARK), true, 1, false);
        assertThat(changed.light("environment").orElseThrow().intensity()).isEqualTo(3);
        assertThat(changed.world().own().intensity()).isEqualTo(2);
    }

    /** Files of earlier versions have the name alone. */
    @Test
    void nameWithoutSuchALight_isTheEnvironment() {
        assertThat(reviewed(withoutLamp(JenScenes.withSky(DARK)), false, 1, false).world().own().intensity()).isEqualTo(2);
    }

    /** Pages of earlier versions have one fader for all environments. */
    @Test
    void faderOfAnEarlierPage_changesAllEnvironments() {
        Scene sky = JenScenes.withSky(DARK);
        Scene changed = reviewed(sky.withWorld(sky.world().withNamed(List.of(JenScenes.dome("a", 2)))), true, 1, false);
        assertThat(changed.world().own().intensity()).isEqualTo(2);
        assertThat(changed.world().dome("a").orElseThrow().intensity()).isEqualTo(4);
    }

    @Test
    void faderOfADome_changesItAlone() {
        Scene sky = JenScenes.withSky(DARK);
        Scene both = sky.withWorld(sky.world().withNamed(List.of(JenScenes.dome("a", 2), JenScenes.dome("b", 1))));
        Scene changed = reviewed(both, new SceneElement.OfDome("a"), false, 1, true);
        assertThat(changed.world())
                .isEqualTo(both.world().withNamed(List.of(JenScenes.dome("a", 4).withSolo(true), JenScenes.dome("b", 1))));
    }

    @Test
    void soloOfDomes_darkensTheLights() {
        Scene scene = withoutLamp(DARK.withWorld(DARK.world().withNamed(List.of(JenScenes.dome("a", 2), JenScenes.dome("b", 1)))));
        Scene changed = reviewed(scene, true, 0, true);
        assertThat(changed.isActive(changed.light("key").orElseThrow())).isFalse();
        assertThat(changed.rig().isEnvironmentActive(0)).isTrue();
        assertThat(changed.rig().isEnvironmentActive(1)).isTrue();
    }

    @Test
    void soloOfAnEnvironmentAndADome_darkensNeither() {
        World world = JenScenes.withSky(DARK).world().withNamed(List.of(JenScenes.dome("a", 2)));
        Scene changed = reviewed(withoutLamp(DARK.withWorld(world)), true, 0, true);
        assertThat(changed.isActive(changed.light("key").orElseThrow())).isFalse();
        assertThat(changed.rig().isEnvironmentActive(0)).isTrue();
        assertThat(changed.rig().isEnvironmentActive(1)).isTrue();
    }
}

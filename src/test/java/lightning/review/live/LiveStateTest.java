package lightning.review.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.review.live.LiveState.LightValue;
import lightning.sample.JenScenes;
import lightning.scene.Dome;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class LiveStateTest {
    private static final Scene DARK = JenScenes.of("light key point { }");
    private static final Scene DOMES = DARK.withWorld(DARK.world().withNamed(List.of(JenScenes.dome("a", 2), JenScenes.dome("b", 0.5))));

    private static Scene apply(Scene scene, LightValue value) {
        return new LiveState(List.of(value), List.of(), Optional.empty()).applyTo(scene);
    }

    private static LightValue environment(Scene scene) {
        return LiveState.of(scene).lights().getLast();
    }

    private static LightValue value(String name, double intensity, boolean mute, boolean solo) {
        return new LightValue(name, intensity, Rgb.WHITE, mute, solo);
    }

    @Test
    void physicalSky_hasAValue() {
        Scene sky = JenScenes.of("world { sky yes  intensity 0.5 }\nlight key point { }");
        assertThat(environment(sky)).isEqualTo(value("environment", 0.5, false, false));
        assertThat(apply(sky, value("environment", 0.25, false, false)).world().own().intensity()).isEqualTo(0.25);
    }

    @Test
    void muteOfADome_comesBack() {
        Scene muted = apply(DOMES, value("b", 0.5, true, false));
        assertThat(muted.world().named()).extracting(Dome::on).containsExactly(true, false);
        assertThat(environment(muted).mute()).isTrue();
        assertThat(apply(muted, value("b", 0.5, false, false))).isEqualTo(DOMES);
    }

    @Test
    void muteOfTheEnvironment_comesBack() {
        Scene sky = JenScenes.withSky(DARK);
        Scene dark = apply(sky, value("environment", 1, true, false));
        assertThat(dark.world().own().intensity()).isZero();
        assertThat(apply(dark, value("environment", 1, false, false))).isEqualTo(sky);
    }

    @Test
    void soloOfADome_comesBack() {
        Scene solo = apply(DOMES, value("a", 2, false, true));
        assertThat(solo.isActive(solo.light("key").orElseThrow())).isFalse();
        assertThat(solo.rig().isEnvironmentActive(1)).isFalse();
        assertThat(apply(solo, value("a", 2, false, false))).isEqualTo(DOMES);
    }

    @Test
    void lightNamedEnvironment_isNotTheSky() {
        Scene scene = JenScenes.withSky(JenScenes.of("light environment point { intensity 3 }"));
        assertThat(LiveState.of(scene).lights()).extracting(LightValue::name).containsExactly("environment", "environment 2");
        Scene changed = apply(scene, value("environment 2", 2, false, false));
        assertThat(changed.world().own().intensity()).isEqualTo(2);
        assertThat(changed.lights()).isEqualTo(scene.lights());
    }

    @Test
    void environments_haveTheirOwnValues() {
        Scene both = JenScenes.withSky(DARK).withWorld(JenScenes.withSky(DARK).world().withNamed(DOMES.world().named()));
        assertThat(LiveState.of(both).lights()).extracting(LightValue::name).containsExactly("key", "environment", "a", "b");
        Scene changed = apply(both, value("a", 4, false, true));
        assertThat(changed.world().own().intensity()).isEqualTo(1);
        assertThat(changed.world().named()).extracting(Dome::intensity).containsExactly(4.0, 0.5);
        assertThat(changed.world().named()).extracting(Dome::solo).containsExactly(true, false);
    }
}

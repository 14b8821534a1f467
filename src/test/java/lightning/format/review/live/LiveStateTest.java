package lightning.format.review.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.review.live.LiveState.LightValue;
import lightning.sample.JenScenes;
import lightning.scene.Dome;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class LiveStateTest {
    private static final Scene DARK = JenScenes.of("light key point { }");
    private static final Scene DOMES = DARK.withWorld(DARK.world().withDomes(List.of(JenScenes.dome("a", 2), JenScenes.dome("b", 0.5))));

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
    void domes_haveAValue() {
        assertThat(environment(DOMES)).isEqualTo(value("environment", 2, false, false));
    }

    @Test
    void physicalSky_hasAValue() {
        Scene sky = JenScenes.of("world { sky yes  intensity 0.5 }\nlight key point { }");
        assertThat(environment(sky)).isEqualTo(value("environment", 0.5, false, false));
        assertThat(apply(sky, value("environment", 0.25, false, false)).world().intensity()).isEqualTo(0.25);
    }

    @Test
    void domes_followTheirFaderTogether() {
        Scene changed = apply(DOMES, value("environment", 1, false, false));
        assertThat(changed.world().domes()).extracting(Dome::intensity).containsExactly(1.0, 0.25);
    }

    @Test
    void muteOfDomes_comesBack() {
        Scene muted = apply(DOMES, value("environment", 2, true, false));
        assertThat(muted.rig().isEnvironmentActive()).isFalse();
        assertThat(environment(muted).mute()).isTrue();
        assertThat(apply(muted, value("environment", 2, false, false))).isEqualTo(DOMES);
    }

    @Test
    void faderOfAnEnvironmentAndADome_comesBackFromZero() {
        Scene both = JenScenes.withSky(DARK).withWorld(JenScenes.withSky(DARK).world().withDomes(DOMES.world().domes()));
        Scene dark = apply(both, value("environment", 0, false, false));
        assertThat(dark.world().hasEnvironmentLight()).isFalse();
        assertThat(apply(dark, value("environment", 1, false, false))).isEqualTo(both);
    }

    @Test
    void soloOfDomes_comesBack() {
        Scene solo = apply(DOMES, value("environment", 2, false, true));
        assertThat(solo.isActive(solo.light("key").orElseThrow())).isFalse();
        assertThat(apply(solo, value("environment", 2, false, false))).isEqualTo(DOMES);
    }

    @Test
    void lightNamedEnvironment_isNotTheSky() {
        Scene scene = JenScenes.withSky(JenScenes.of("light environment point { intensity 3 }"));
        assertThat(LiveState.of(scene).lights()).extracting(LightValue::name).containsExactly("environment", "environment 2");
        Scene changed = apply(scene, value("environment 2", 2, false, false));
        assertThat(changed.world().intensity()).isEqualTo(2);
        assertThat(changed.lights()).isEqualTo(scene.lights());
    }
}

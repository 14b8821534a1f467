package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class MixerChannelTest {
    private static final MixerChannel ENVIRONMENT = MixerChannel.ENVIRONMENT;

    private static Scene scene(double intensity, double gain) {
        float[] rgb = new float[8 * 4 * 3];
        Arrays.fill(rgb, 0.5f);
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb))))
                .withOwn(own -> own.withIntensity(intensity).withGain(gain));
        return NewScene.create(PictureArea.DEFAULT).scene().withLights(List.of(Light.of("key", LightType.POINT))).withWorld(world);
    }

    @Test
    void mutedEnvironment_keepsItsImage() {
        Scene muted = ENVIRONMENT.with(scene(2, 1), v -> v.withOn(false));
        assertThat(muted.world().own().intensity()).isEqualTo(2);
        assertThat(muted.world().own().lightIntensity()).isZero();
        assertThat(ENVIRONMENT.values(muted).on()).isFalse();
        assertThat(ENVIRONMENT.isShining(muted)).isFalse();
        assertThat(ENVIRONMENT.with(muted, v -> v.withOn(true)).world()).isEqualTo(scene(2, 1).world());
    }

    /** Files of earlier versions muted the environment with its intensity. */
    @Test
    void environmentOfIntensityZero_comesOn() {
        assertThat(ENVIRONMENT.values(scene(0, 0.5)).on()).isFalse();
        assertThat(ENVIRONMENT.with(scene(0, 0.5), v -> v.withOn(true)).world()).isEqualTo(scene(1, 0.5).world());
        assertThat(ENVIRONMENT.with(scene(0, 0), v -> v.withOn(true)).world()).isEqualTo(scene(1, 1).world());
    }

    @Test
    void environmentThatIsAlreadyOn_keepsItsGain() {
        Scene lit = scene(2, 0.5);
        assertThat(ENVIRONMENT.with(lit, v -> v.withOn(true))).isSameAs(lit);
    }

    @Test
    void intensityOfADarkEnvironment_leavesItsGain() {
        assertThat(ENVIRONMENT.with(scene(0, 0.5), v -> v.withIntensity(3)).world()).isEqualTo(scene(3, 0.5).world());
    }

    /** As in the light list. */
    @Test
    void shownColorOfALight_hasTheHueOfItsTemperature() {
        Light candle = LightAttribute.TEMPERATURE.with(Light.of("candle", LightType.POINT), 1900.0);
        Rgb shown = MixerChannel.ofLight("candle").shownColor(scene(1, 1).withLights(List.of(candle))).orElseThrow();
        assertThat(shown.r()).isEqualTo(1);
        assertThat(shown.b()).isLessThan(0.1);
        assertThat(ENVIRONMENT.shownColor(scene(1, 1))).isEmpty();
    }

    /** A light may have the name of the environment. */
    @Test
    void titles_areDistinct() {
        Scene lit = scene(1, 1);
        Scene scene = lit.withLights(List.of(lit.lights().getFirst().withName("environment")));
        assertThat(MixerChannel.channelsOf(scene)).extracting(channel -> channel.title(scene)).containsExactly("environment",
                "environment 2");
    }

    @Test
    void dome_isFadedMutedAndSoloed() {
        Scene own = scene(1, 1);
        Dome dome = Dome.of("studio").withImage(own.world().own().image());
        Scene scene = own.withWorld(own.world().withNamed(List.of(dome)));
        MixerChannel channel = new MixerChannel.OfContribution(new SceneElement.OfDome("studio"));
        assertThat(MixerChannel.channelsOf(scene)).endsWith(ENVIRONMENT, channel);
        assertThat(channel.with(scene, v -> v.withIntensity(3)).world().named()).containsExactly(dome.withIntensity(3));
        Scene muted = channel.with(scene, v -> v.withOn(false));
        assertThat(muted.world().named()).containsExactly(dome.withOn(false));
        assertThat(channel.isShining(muted)).isFalse();
        assertThat(ENVIRONMENT.isShining(muted)).isTrue();
        Scene solo = channel.with(scene, v -> v.withSolo(true));
        assertThat(channel.isShining(solo)).isTrue();
        assertThat(ENVIRONMENT.isShining(solo)).isFalse();
        assertThat(channel.isIn(own)).isFalse();
    }
}

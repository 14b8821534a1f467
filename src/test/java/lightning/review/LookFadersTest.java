package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.ViewTransform;
import lightning.sample.JenScenes;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

class LookFadersTest {
    private final Scene scene = PageFixture.scene();
    private final Light sun = scene.light("sun").orElseThrow();

    private JsonNode light(Scene look, String name) {
        for (JsonNode light : LookFaders.of(scene, look).orElseThrow().get("lights")) {
            if (light.get("name").asString().equals(name)) {
                return light;
            }
        }
        throw new AssertionError(name);
    }

    @Test
    void intensity_isInStops() {
        JsonNode light = light(scene.withLight(sun.withIntensity(sun.intensity() / 4)), "sun");
        assertThat(light.get("stops").asDouble()).isCloseTo(-2, within(1e-12));
        assertThat(light.get("tint").get(1).asDouble()).isCloseTo(1, within(1e-12));
    }

    @Test
    void exposureAndTemperature_areInTheFader() {
        Light changed = sun.withEmission(sun.emission().withExposure(1.5));
        assertThat(light(scene.withLight(changed), "sun").get("stops").asDouble()).isCloseTo(1.5, within(1e-12));
        Light warm = sun.withEmission(sun.emission().withTemperature(3000));
        JsonNode tint = light(scene.withLight(warm), "sun").get("tint");
        assertThat(tint.get(2).asDouble()).isLessThan(tint.get(0).asDouble());
    }

    @Test
    void darkLight_isOff() {
        assertThat(light(scene.withLight(sun.withIntensity(0)), "sun").get("stops").asDouble()).isEqualTo(LookFaders.OFF);
        assertThat(light(scene.withLight(sun.withOn(false)), "sun").get("mute").asBoolean()).isTrue();
        List<Light> others = scene.lights().stream().filter(light -> !light.name().equals("sun")).toList();
        assertThat(light(scene.withLights(others), "sun").get("mute").asBoolean()).isTrue();
    }

    @Test
    void solo_mutesTheOthers() {
        Scene look = scene.withLight(sun.withSolo(true));
        assertThat(light(look, "sun").get("mute").asBoolean()).isFalse();
        assertThat(light(look, "key").get("mute").asBoolean()).isTrue();
    }

    @Test
    void whatFadersCannotShow_hasNone() {
        assertThat(LookFaders.of(scene, scene.withLight(sun.withDirection(new Vec3(1, -1, 0))))).isEmpty();
        assertThat(LookFaders.of(scene, scene.withWorld(scene.world().withAmbience(0.25)))).isEmpty();
        assertThat(LookFaders.of(scene, scene.withWorld(scene.world().withBackground(Rgb.WHITE)))).isEmpty();
        assertThat(LookFaders.of(scene, scene.withLight(sun.withIntensity(sun.intensity() / 1000)))).isEmpty();
        assertThat(LookFaders.of(scene.withLight(sun.withOn(false)), scene)).isEmpty();
        assertThat(LookFaders.of(scene.withLight(sun.withIntensity(0)), scene)).isEmpty();
        assertThat(LookFaders.of(scene.withLight(sun.withColor(new Rgb(1, 0, 0))), scene)).isEmpty();
    }

    @Test
    void newLight_needsAPicture() {
        Scene more = scene.withRig(scene.rig().withLights(java.util.stream.Stream.concat(scene.lights().stream(),
                java.util.stream.Stream.of(sun.withName("moon"))).toList()));
        assertThat(LookFaders.of(scene, more)).isEmpty();
        assertThat(LookFaders.of(scene, scene)).isPresent();
    }

    @Test
    void environments_haveTheirOwnFaders() {
        Scene page = JenScenes.withSky(JenScenes.of("light environment point { }"));
        page = page.withWorld(page.world().withNamed(List.of(JenScenes.dome("studio", 2))));
        assertThat(ReviewContent.of("a", ReviewPicture.of(page), ViewTransform.DEFAULT).lightNames())
                .containsExactly("environment", "environment 2", "studio");
        Scene look = page.withWorld(page.world().withNamed(List.of(JenScenes.dome("studio", 1))));
        JsonNode lights = LookFaders.of(page, look).orElseThrow().get("lights");
        assertThat(lights.values()).extracting(light -> light.get("stops").asDouble()).containsExactly(0.0, 0.0, -1.0);
    }

    @Test
    void environmentThatASoloMutes_needsAPicture() {
        Scene page = JenScenes.withSky(JenScenes.of("light key point { }"));
        page = page.withWorld(page.world().withNamed(List.of(JenScenes.dome("studio", 2))));
        assertThat(LookFaders.of(page, page.withWorld(page.world().withOwn(own -> own.withSolo(true))))).isEmpty();
    }
}

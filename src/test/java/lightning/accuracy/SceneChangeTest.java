package lightning.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.math.Rgb;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class SceneChangeTest {
    private final Scene bird = SceneFiles.read("bird");
    private final Light sun = bird.light("sun").orElseThrow();

    private String to(Scene after) {
        return SceneChange.text(bird, after);
    }

    @Test
    void attributes_areNamedAsInTheFile() {
        assertThat(to(bird.withLight(sun.withColor(new Rgb(1, 0, 0)).withIntensity(1 / 3.0).withOn(false))))
                .isEqualTo("sun.color = 1 0 0, sun.intensity = 0.3333, sun.on = no");
        assertThat(to(bird.withLight(sun.withType(LightType.SPOT).withAngle(12)))).isEqualTo("sun.type = spot, sun.angle = 12");
        assertThat(to(bird.withWorld(bird.world().withAmbience(0.1)))).isEqualTo("world.ambience = 0.1");
        assertThat(to(bird.withPicture(bird.picture().withDepth(9)))).isEqualTo("picture.depth = 9");
        assertThat(to(bird)).isEmpty();
    }

    @Test
    void materials_areNamedAsInTheFile() {
        Material textured = bird.materials().stream().filter(m -> m.texture().isPresent()).findFirst().orElseThrow();
        assertThat(to(bird.withMaterial(textured.withReflective(Rgb.grey(0.25)).withTexture(Optional.empty()))))
                .isEqualTo(textured.name() + ".reflective = 0.25 0.25 0.25, " + textured.name() + ".texture = none");
    }

    @Test
    void lights_comeGoAndAreRenamed() {
        List<Light> more = new ArrayList<>(bird.lights());
        more.add(Light.of("fill", LightType.POINT));
        assertThat(to(bird.withLights(more))).isEqualTo("fill is added, point");
        assertThat(to(bird.withLights(bird.lights().stream().filter(l -> l != sun).toList()))).isEqualTo("sun is deleted");
        assertThat(to(bird.withLights(bird.lights().stream().map(l -> l == sun ? l.withName("moon") : l).toList())))
                .isEqualTo("sun is named moon");
    }
}

package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class PropertyChangesTest {
    private static final Path FOLDER = Path.of("scenes");

    private final Scene scene = StudioScene.withFourLights(30, 24);
    private final Light key = scene.light(StudioScene.KEY).orElseThrow();

    @Test
    void values_areSaidInWords() {
        Scene after = scene.withLight(key.withIntensity(3).withColor(new Rgb(1, 0.5, 0.25)).withPosition(new Vec3(1, 2, 3)))
                .withWorld(scene.world().withAmbience(0.5));
        assertThat(PropertyChanges.between(scene, after, FOLDER).orElseThrow()).containsExactlyInAnyOrder("key.color=1 0.5 0.25",
                "key.intensity=3", "key.at=1 2 3", "world.ambience=0.5");
    }

    @Test
    void nameThatIsNoWord_isQuoted() {
        Light named = key.withName("key light");
        Scene before = StudioScene.of(LightType.SPOT).withLights(List.of(named));
        assertThat(PropertyChanges.between(before, before.withLight(named.withIntensity(3)), FOLDER).orElseThrow())
                .containsExactly("\"key light\".intensity=3");
    }

    @Test
    void addedLight_cannotBeSaid() {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(key.withName("new"));
        assertThat(PropertyChanges.between(scene, scene.withLights(lights), FOLDER)).isEmpty();
    }

    @Test
    void laterEdit_replacesOneOfTheSameProperty() {
        assertThat(PropertyChanges.joined(List.of("key.intensity=1", "key.at=0 0 0"), List.of("key.intensity=2")))
                .containsExactly("key.at=0 0 0", "key.intensity=2");
    }
}

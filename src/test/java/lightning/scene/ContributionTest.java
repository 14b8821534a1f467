package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.sample.JenScenes;
import org.junit.jupiter.api.Test;

class ContributionTest {
    private static final Contribution LAMP = new Contribution.OfLight("environment");

    @Test
    void environment_hasItsOwnName() {
        Scene scene = JenScenes.withSky(JenScenes.of("light key point { }"));
        assertThat(Contribution.ENVIRONMENT.name(scene)).isEqualTo("environment");
        assertThat(Contribution.named(scene, "environment")).contains(Contribution.ENVIRONMENT);
    }

    @Test
    void lightNamedEnvironment_keepsItsName() {
        Scene scene = JenScenes.withSky(JenScenes.of("light environment point { }\nlight \"environment 2\" point { }"));
        assertThat(LAMP.name(scene)).isEqualTo("environment");
        assertThat(Contribution.ENVIRONMENT.name(scene)).isEqualTo("environment 3");
        assertThat(Contribution.named(scene, "environment")).contains(LAMP);
        assertThat(Contribution.named(scene, "environment 3")).contains(Contribution.ENVIRONMENT);
    }

    @Test
    void sceneWithoutEnvironment_hasNoneOfThatName() {
        assertThat(Contribution.named(JenScenes.of("light key point { }"), "environment")).isEmpty();
    }

    @Test
    void shining_endsWithTheEnvironment() {
        Scene scene = JenScenes.withSky(JenScenes.of("light environment point { }\nlight off point { on no }"));
        assertThat(Contribution.shining(scene)).isEqualTo(List.of(LAMP, Contribution.ENVIRONMENT));
    }
}

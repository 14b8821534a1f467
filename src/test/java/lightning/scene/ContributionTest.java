package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import lightning.sample.JenScenes;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

class ContributionTest {
    private static final Contribution LAMP = new SceneElement.OfLight("environment");

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
    void environments_areOneContributionEach() {
        Scene scene = twoEnvironments("light key point { }");
        List<Contribution> all = List.of(new SceneElement.OfLight("key"), Contribution.ENVIRONMENT, new SceneElement.OfDome("studio"),
                new Contribution.OfAmbience(), new Contribution.OfRest());
        assertThat(Contribution.all(scene)).isEqualTo(all);
        assertThat(Contribution.shining(scene)).isEqualTo(all.subList(0, 3));
        assertThat(all).extracting(part -> part.environmentIndex(scene)).containsExactly(-1, 0, 1, -1, -1);
        Scene solo = new SceneElement.OfDome("studio").with(scene, v -> v.withSolo(true));
        assertThat(Contribution.shining(solo)).isEqualTo(all.subList(2, 3));
        Scene noImage = scene.withWorld(scene.world().withNamed(List.of(Dome.of("studio"))));
        assertThat(Contribution.sources(noImage)).isEqualTo(all.subList(0, 2));
        assertThat(all.get(2).isShining(noImage)).isFalse();
    }

    @Test
    void names_areUniqueAndFound() {
        Scene scene = twoEnvironments("light ambience point { }\nbank environment { }\nlight \"rest 2\" point { }\nlight rest point { }");
        List<Contribution> all = Contribution.all(scene);
        assertThat(all).extracting(part -> part.name(scene)).containsExactly("ambience", "rest 2", "rest", "environment 2", "studio",
                "ambience 2", "rest 3");
        assertThat(all).extracting(part -> Contribution.named(scene, part.name(scene)).orElseThrow()).isEqualTo(all);
    }

    @Test
    void effectiveLights_belongToTheirContributions() {
        Scene scene = twoEnvironments("light key point { }");
        List<Light> lights = scene.rig().effectiveLights();
        List<Integer> indices = new ArrayList<>();
        for (Contribution part : Contribution.all(scene)) {
            for (int i : part.effectiveLights(scene)) {
                indices.add(i);
                assertThat(lights.get(i).name()).matches(part.name(scene) + "( \\d+)?");
            }
        }
        assertThat(indices).isEqualTo(IntStream.range(0, lights.size()).boxed().toList());
    }

    @Test
    void ambience_isAContribution() {
        Scene scene = JenScenes.of("world { ambience 0.5 }");
        Contribution ambience = new Contribution.OfAmbience();
        assertThat(ambience.values(scene).intensity()).isEqualTo(0.5);
        assertThat(ambience.with(scene, v -> v.withIntensity(2)).world().ambience()).isEqualTo(2);
        Scene dark = ambience.with(scene, v -> v.withOn(false));
        assertThat(dark.world().ambience()).isZero();
        assertThat(ambience.isShining(dark)).isFalse();
    }

    private static Scene twoEnvironments(String lights) {
        Scene scene = JenScenes.withSky(JenScenes.of(lights));
        return scene.withWorld(scene.world().withNamed(List.of(JenScenes.dome("studio", 2))));
    }

    @Test
    void shining_endsWithTheEnvironment() {
        Scene scene = JenScenes.withSky(JenScenes.of("light environment point { }\nlight off point { on no }"));
        assertThat(Contribution.shining(scene)).isEqualTo(List.of(LAMP, Contribution.ENVIRONMENT));
    }
}

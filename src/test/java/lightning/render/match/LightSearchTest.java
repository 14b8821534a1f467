package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CancellationException;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

@Slow
class LightSearchTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final String KEY = StudioScene.KEY;

    /** The key is up to a quarter of its distance away, all lights have other intensities. */
    @Property(tries = 10)
    void movedLight_comesBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = lights(random, StudioScene.withFourLights(96, 72));
        Light key = scene.light(KEY).orElseThrow();
        Vec3 from = key.position().plus(inBall(random).times(key.position().length() / 4));
        MatchResult result = match(scene.withLight(key.withPosition(from)), scene, MatchChange.POSITIONS, KEY);
        Vec3 found = matched(scene, result).light(KEY).orElseThrow().position();
        assertThat(found.minus(key.position()).length()).as("%s from %s is at %s", key.position(), from, found)
                .isLessThan(0.01 * key.position().length());
    }

    @Property(tries = 10)
    void turnedSpot_comesBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = lights(random, StudioScene.withFourLights(96, 72));
        Light key = scene.light(KEY).orElseThrow();
        Vec3 turned = key.direction().plus(inBall(random).times(0.2 * key.direction().length()));
        MatchResult result = match(scene.withLight(key.withDirection(turned)), scene, MatchChange.DIRECTIONS, KEY);
        Vec3 found = matched(scene, result).light(KEY).orElseThrow().direction().normalized();
        assertThat(found.dot(key.direction().normalized())).isGreaterThan(Math.cos(Math.toRadians(1)));
    }

    @Property(tries = 5)
    void otherCone_comesBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = lights(random, StudioScene.withFourLights(96, 72));
        Light key = scene.light(KEY).orElseThrow();
        MatchResult result = match(scene.withLight(key.withAngle(13 + 17 * random.nextDouble())), scene, MatchChange.CONES, KEY);
        assertThat(matched(scene, result).light(KEY).orElseThrow().angle()).isCloseTo(key.angle(), within(0.5));
    }

    @Property(tries = 5)
    void otherTemperature_comesBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene start = lights(random, StudioScene.withFourLights(64, 48));
        Scene reference = start;
        for (Light light : start.lights()) {
            double kelvin = 1e6 / (100 + 300 * random.nextDouble());
            reference = reference.withLight(light.withEmission(light.emission().withTemperature(kelvin)));
        }
        MatchResult result = LightSearchTest.match(start, reference, MatchChange.TEMPERATURES, Optional.empty(), Progress.NONE);
        for (Light light : reference.lights()) {
            double mired = 1e6 / light.emission().temperature();
            assertThat(1e6 / matched(start, result).light(light.name()).orElseThrow().emission().temperature()).isCloseTo(mired,
                    within(2.0));
        }
    }

    @Property(tries = 5)
    void turnedEnvironment_comesBack(@ForAll long seed) {
        Scene scene = outdoors();
        double rotation = 360 * new Random(seed).nextDouble() - 180;
        Scene reference = scene.withWorld(scene.world().withOwn(own -> own.withRotation(DomeRotation.of(rotation, 0, 0)).withIntensity(2)));
        MatchResult result = match(scene, reference, MatchChange.ROTATION, Optional.empty(), Progress.NONE);
        double difference = matched(scene, result).world().own().rotation().rotation() - rotation;
        assertThat(Math.IEEEremainder(difference, 360)).isCloseTo(0, within(2.0));
    }

    @Test
    void lightAtItsPlace_stays() {
        Scene scene = StudioScene.withFourLights(64, 48);
        MatchResult result = match(scene, scene, MatchChange.POSITIONS, KEY);
        assertThat(matched(scene, result).light(KEY).orElseThrow().position().minus(scene.light(KEY).orElseThrow().position()).length())
                .isLessThan(1e-4);
    }

    @Test
    void canceledSearch_ends() {
        Scene scene = StudioScene.withFourLights(64, 48);
        Light key = scene.light(KEY).orElseThrow();
        Progress canceled = new Progress() {
            private boolean isSearching;

            @Override
            public void report(int done, int total) {
                isSearching |= total > scene.lights().size();
            }

            @Override
            public boolean isCanceled() {
                return isSearching;
            }
        };
        assertThatThrownBy(() -> match(scene.withLight(key.withPosition(new Vec3(1, 4, 2))), scene, MatchChange.POSITIONS,
                Optional.of(Set.of(new SceneElement.OfLight(KEY))), canceled)).isInstanceOf(CancellationException.class);
    }

    /** Returns the studio below a sky that is bright and red on one side. */
    private static Scene outdoors() {
        Scene scene = StudioScene.withFourLights(64, 48);
        float[] rgb = new float[3 * 32 * 16];
        for (int i = 0; i < rgb.length; i++) {
            double angle = 2 * Math.PI * (i / 3 % 32) / 32;
            rgb[i] = (float) (0.1 + (i % 3 == 0 ? 2 : 1) * Math.pow(Math.max(0, Math.cos(angle)), 4));
        }
        return scene.withWorld(scene.world().withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(32, 16, rgb)))));
    }

    private static Scene matched(Scene scene, MatchResult result) {
        return MatchedScene.of(scene, result);
    }

    /** Returns a scene whose lights have random intensities and colors. */
    private static Scene lights(Random random, Scene scene) {
        Scene changed = scene;
        for (Light light : scene.lights()) {
            changed = changed.withLight(light.withIntensity(light.intensity() * (0.5 + random.nextDouble()))
                    .withColor(new Rgb(0.5 + random.nextDouble() / 2, 0.5 + random.nextDouble() / 2, 0.5 + random.nextDouble() / 2)));
        }
        return changed;
    }

    private static Vec3 inBall(Random random) {
        Vec3 v = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return v.times(Math.cbrt(random.nextDouble()) / v.length());
    }

    private static MatchResult match(Scene start, Scene reference, MatchChange change, String light) {
        return match(start, reference, change, Optional.of(Set.of(new SceneElement.OfLight(light))), Progress.NONE);
    }

    private static MatchResult match(Scene start, Scene reference, MatchChange change, Optional<Set<Contribution>> lights,
            Progress progress) {
        MatchSettings settings =
                new MatchSettings(lights, Set.of(change), MatchSettings.Reference.FIXED, MatchSettings.Reference.FIXED, 0);
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(reference, Progress.NONE);
            Film film = renderer.film();
            renderer.render(start, Progress.NONE);
            return LightMatch.of(renderer.cache(), OPTIONS, ReferenceImage.of(film), settings, progress);
        }
    }
}

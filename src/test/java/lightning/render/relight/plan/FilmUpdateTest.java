package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Fog;
import lightning.scene.value.ShapeGains;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which films an edit changes, and whether it changes their weights and those of edge detection. */
class FilmUpdateTest {
    /** Four lights, and an environment with a bright part. */
    private static final Scene SCENE = withEnvironment(StudioScene.withFourLights(8, 6));
    private static final FilmParts PARTS = FilmParts.of(SCENE);
    private static final int FILL = 1;

    private static Scene withEnvironment(Scene scene) {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 0.5f);
        Arrays.fill(rgb, 30, 33, 100);
        return scene.withWorld(scene.world().withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb)))));
    }

    private static FilmUpdate update(Scene before, Scene target) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            UpdatePlan plan = renderer.plan(target).update();
            assertThat(plan).isInstanceOf(UpdatePlan.Relight.class);
            return FilmUpdate.between(FilmParts.of(before), FilmParts.of(target), ((UpdatePlan.Relight) plan).top());
        }
    }

    private static Scene withFill(UnaryOperator<Light> edit) {
        return SCENE.withLight(edit.apply(SCENE.lights().get(FILL)));
    }

    private static Scene withWorld(UnaryOperator<World> edit) {
        return SCENE.withWorld(edit.apply(SCENE.world()));
    }

    private static int film(FilmPart.Kind kind) {
        return IntStream.range(0, PARTS.count()).filter(film -> PARTS.get(film).kind() == kind).findFirst().orElseThrow();
    }

    private static BitSet films(int... films) {
        return IntStream.of(films).collect(BitSet::new, BitSet::set, BitSet::or);
    }

    /** Asserts that no film changes and each keeps its number, but the sum has other weights. */
    private static void assertReweights(FilmUpdate update, boolean changesEdges) {
        assertThat(update.isSame()).isTrue();
        assertThat(update.changed()).isEqualTo(films());
        assertThat(update.reweights()).isTrue();
        assertThat(update.changesEdges()).as("edges").isEqualTo(changesEdges);
    }

    /** Asserts that some films change, that each keeps its number, and that no weight changes. */
    private static void assertChanges(FilmUpdate update, int... films) {
        assertThat(update.changed()).isEqualTo(films(films));
        assertThat(update.origin()).isEqualTo(IntStream.range(0, PARTS.count()).toArray());
        assertThat(update.reweights()).isFalse();
        assertThat(update.changesEdges()).isFalse();
    }

    /** Edges are detected with weights rounded to powers of two: 1.2 is rounded to 1, and 2 stays. */
    @ParameterizedTest
    @CsvSource({"1.2, false", "0.75, false", "2, true", "0.5, true", "0, true"})
    void intensity_changesEdgesOnlyAtAnotherPowerOfTwo(double intensity, boolean changesEdges) {
        Scene one = withFill(light -> light.withIntensity(1).withColor(Rgb.WHITE));
        assertReweights(update(one, withFill(light -> light.withIntensity(intensity).withColor(Rgb.WHITE))), changesEdges);
    }

    /** One channel is enough. */
    @ParameterizedTest
    @CsvSource({"0.9, false", "0.2, true"})
    void color_changesEdgesOnlyAtAnotherPowerOfTwo(double blue, boolean changesEdges) {
        Scene white = withFill(light -> light.withIntensity(1).withColor(Rgb.WHITE));
        assertReweights(update(white, withFill(light -> light.withIntensity(1).withColor(new Rgb(1, 1, blue)))), changesEdges);
    }

    @Test
    void lightSwitchedOffAndOn_reweights() {
        Scene off = withFill(light -> light.withOn(false));
        assertReweights(update(SCENE, off), true);
        assertReweights(update(off, SCENE), true);
        assertReweights(update(SCENE, withFill(light -> light.withSolo(true))), true);
    }

    @Test
    void movedLight_changesNoOtherFilm() {
        FilmUpdate update = update(SCENE, withFill(light -> light.withPosition(new Vec3(3, 3, 3))));
        // Its own film changes with its rows.
        assertChanges(update);
        assertThat(update.isSame()).isTrue();
    }

    @Test
    void addedLight_hasNoOrigin() {
        List<Light> more = new ArrayList<>(SCENE.lights());
        more.addFirst(StudioScene.key(LightType.SPOT).withName("new"));
        FilmUpdate update = update(SCENE, SCENE.withLights(more));
        assertThat(update.origin()).isEqualTo(IntStream.range(-1, PARTS.count()).toArray());
        assertThat(update.changed()).isEqualTo(films(0));
        assertThat(update.reweights()).isTrue();
        assertThat(update.changesEdges()).isTrue();
        assertThat(update.isSame()).isFalse();
    }

    @Test
    void deletedLight_shiftsTheOthers() {
        List<Light> fewer = new ArrayList<>(SCENE.lights());
        fewer.remove(FILL);
        FilmUpdate update = update(SCENE, SCENE.withLights(fewer));
        assertThat(update.origin()).isEqualTo(IntStream.range(0, PARTS.count()).filter(film -> film != FILL).toArray());
        assertThat(update.changed()).isEqualTo(films());
        assertThat(update.reweights()).isTrue();
        assertThat(update.changesEdges()).isTrue();
        assertThat(update.isSame()).isFalse();
    }

    /** The last film is missing, so that all others keep their numbers. */
    @Test
    void deletedLastLight_reweights() {
        Scene bare = StudioScene.withFourLights(8, 6);
        FilmUpdate update = update(bare, bare.withLights(bare.lights().subList(0, 3)));
        assertThat(update.origin()).isEqualTo(new int[] {0, 1, 2, 4, 5});
        assertThat(update.reweights()).isTrue();
        assertThat(update.changesEdges()).isTrue();
    }

    @Test
    void reorderedLights_keepTheirFilms() {
        FilmUpdate update = update(SCENE, SCENE.withLights(SCENE.lights().reversed()));
        int[] origin = IntStream.range(0, PARTS.count()).map(film -> film < 4 ? 3 - film : film).toArray();
        assertThat(update.origin()).isEqualTo(origin);
        assertThat(update.changed()).isEqualTo(films());
        assertThat(update.reweights()).isTrue();
        assertThat(update.changesEdges()).isTrue();
        assertThat(update.isSame()).isFalse();
    }

    @Test
    void gains_changeOnlyTheFilmOfTheirLight() {
        for (Influence gained : List.of(Influence.DEFAULT.withGains(ShapeGains.of("ball", 0.4)),
                Influence.DEFAULT.withDiffuse(0.5), Influence.DEFAULT.withSpecular(2), Influence.DEFAULT.withFog(0.5))) {
            Scene with = withFill(light -> light.withInfluence(gained));
            assertChanges(update(SCENE, with), FILL);
            assertChanges(update(with, SCENE), FILL);
        }
    }

    /** Ambience starts at 1, and the environment at its default of 1. */
    @ParameterizedTest
    @CsvSource({"1.2, false", "2, true"})
    void ambienceAndEnvironmentIntensity_reweight(double v, boolean changesEdges) {
        assertReweights(update(SCENE, withWorld(world -> world.withAmbience(v))), changesEdges);
        assertReweights(update(SCENE, withWorld(world -> world.withOwn(own -> own.withIntensity(v)))), changesEdges);
    }

    @Test
    void rotatedEnvironment_changesItsTwoFilms() {
        assertChanges(update(SCENE, withWorld(world -> world.withOwn(own -> own.withRotation(DomeRotation.of(90, 0, 0))))),
                film(FilmPart.Kind.ENVIRONMENT_LIGHT),
                film(FilmPart.Kind.ENVIRONMENT_IMAGE));
    }

    @Test
    void backgroundColor_changesOnlyTheRest() {
        assertChanges(update(SCENE, withWorld(world -> world.withBackground(Rgb.gray(0.5)))), film(FilmPart.Kind.REST));
    }

    @Test
    void fogAndUnitOfLength_changeAllFilms() {
        int[] all = IntStream.range(0, PARTS.count()).toArray();
        assertChanges(update(SCENE, withWorld(world -> world.withFog(Fog.NONE.withDensity(0.1)))), all);
        assertChanges(update(SCENE, withWorld(world -> world.withMeters(0.5))), all);
    }

    @Test
    void firstPicture_changesAllFilms() {
        FilmUpdate update = FilmUpdate.first(PARTS);
        assertThat(update.origin()).hasSize(PARTS.count()).containsOnly(-1);
        assertThat(update.changed().cardinality()).isEqualTo(PARTS.count());
        assertThat(update.reweights() && update.changesEdges()).isTrue();
    }

    @Test
    void sameScene_changesNothing() {
        assertThat(FilmUpdate.none(PARTS).isSame()).isTrue();
        assertChanges(FilmUpdate.none(PARTS));
    }
}

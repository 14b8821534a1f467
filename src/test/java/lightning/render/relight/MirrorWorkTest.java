package lightning.render.relight;

import static lightning.render.relight.Studio.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.SeenRows;
import lightning.sample.StudioScene;
import lightning.scene.Antialias;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The least work where mirrors are: deeper and shallower recursion, stale and current reflections, several tiles. */
class MirrorWorkTest {
    private static final Vec3 ELSEWHERE = new Vec3(-1, 5, 3);

    private static Studio current(MirrorStorage storage) {
        return new Studio(Reflections.CURRENT, storage, StudioScene.of(LightType.SPOT));
    }

    /** Rows of a level and all below that a light reaches. */
    private static long reachedFrom(int level, Studio studio) {
        SeenRows seen = studio.seen();
        long count = 0;
        for (int k = level; k <= studio.scene().picture().depth(); k++) {
            count += seen.count(k, seen.reached(studio.key()));
        }
        return count;
    }

    private static long mirroredFrom(int level, Studio studio) {
        SeenRows seen = studio.seen();
        long count = 0;
        for (int k = level; k < studio.scene().picture().depth(); k++) {
            count += seen.count(k, seen::mirrors);
        }
        return count;
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void deeperRecursion_tracesOnlyTheNewLevel(LightType type) {
        try (Studio studio = Studio.of(type)) {
            Update update = studio.depth(3);
            SeenRows seen = studio.seen();
            assertThat(seen.level(3)).isNotEmpty();
            assertWork(update, seen.level(3).size(), seen.rowsFrom(0), seen.count(2, seen::mirrors),
                    seen.count(3, seen.reached(studio.key())));
        }
    }

    @Test
    void shallowerRecursion_castsNoRay() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            Update update = studio.depth(1);
            assertWork(update, 0, studio.seen().rowsFrom(0), 0, 0);
        }
    }

    @Test
    void recursionWithoutMirrorLevels_composesTheFirstLevelOnly() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            Update update = studio.depth(0);
            assertWork(update, 0, studio.seen().level(0).size(), 0, 0);
        }
    }

    @Test
    void recursionBeyondTheLastMirror_doesNothing() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene oneMirror = new Scene(scene.picture().withDepth(1), scene.camera(), scene.world(), scene.materials(),
                scene.nodes().subList(0, 2), scene.lights());
        try (Studio studio = new Studio(Reflections.STALE, MirrorStorage.FULL_ROWS, oneMirror)) {
            assertThat(studio.seen().level(1)).isNotEmpty();
            assertWork(studio.depth(10), 0, 0, 0, 0);
        }
    }

    @Test
    void staleReflections_areNotTouchedUntilTheyAreUpdated() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            SeenRows seen = studio.seen();
            assertWork(studio.edit(l -> l.withPosition(ELSEWHERE)), seen.level(0).size(), seen.level(0).size(), 0,
                    seen.count(0, studio.seen().reached(studio.key())));
            assertThat(studio.renderer().reflectionsAreCurrent()).isFalse();
            assertWork(studio.renderer().updateReflections(Progress.NONE), seen.rowsFrom(1), seen.rowsFrom(0), 0,
                    reachedFrom(1, studio));
            assertThat(studio.renderer().reflectionsAreCurrent()).isTrue();
        }
    }

    @Test
    void currentReflections_moveTheLightOnAllLevels() {
        try (Studio studio = current(MirrorStorage.FULL_ROWS)) {
            Update update = studio.edit(l -> l.withPosition(ELSEWHERE));
            long rows = studio.seen().rowsFrom(0);
            assertWork(update, rows, rows, 0, reachedFrom(0, studio));
        }
    }

    @Test
    void currentReflections_recolorWithoutARay() {
        try (Studio studio = current(MirrorStorage.FULL_ROWS)) {
            Update update = studio.edit(l -> l.withColor(new Rgb(1, 0.5, 0)));
            assertWork(update, 0, studio.seen().rowsFrom(0), 0, 0);
        }
    }

    @Test
    void currentReflectionsAsHitShapes_areLitAnewAtTheShapesThatAreKnown() {
        try (Studio studio = current(MirrorStorage.HIT_SHAPES)) {
            Update update = studio.edit(l -> l.withColor(new Rgb(1, 0.5, 0)));
            assertWork(update, studio.seen().rowsFrom(1), studio.seen().rowsFrom(0), mirroredFrom(0, studio),
                    reachedFrom(1, studio));
        }
    }

    /** Its layer is missing on that level alone. */
    @Test
    void lightThatWasOffWhenALevelWasAdded_isCastThereOnceItIsOn() {
        try (Studio studio = current(MirrorStorage.FULL_ROWS)) {
            studio.edit(l -> l.withOn(false));
            assertThat(studio.depth(3).rays().shadow()).isZero();
            Update update = studio.edit(l -> l.withOn(true));
            SeenRows seen = studio.seen();
            assertWork(update, seen.level(3).size(), seen.rowsFrom(0), 0, seen.count(3, seen.reached(studio.key())));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "light-on-a-new-level");
        }
    }

    /** The same where only the falloff of the layer would have been written. */
    @Test
    void lightThatWasOffWhenALevelWasAdded_mayBeEditedInBetween() {
        try (Studio studio = current(MirrorStorage.FULL_ROWS)) {
            studio.edit(l -> l.withOn(false));
            studio.depth(3);
            studio.edit(l -> l.withOn(true).withDropoff(5).withAngle(25));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "light-on-a-new-level");
        }
    }

    @Test
    void recoloring_composesOnlyTilesThatTheLightLights() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light left = StudioScene.key(LightType.SPOT).withPosition(new Vec3(-3.4, 0, 0)).withDirection(new Vec3(0, -1, 0));
        Scene wide = scene.withPicture(new Picture(64, 24, 0)).withLights(List.of(left));
        try (Studio studio = new Studio(Reflections.STALE, MirrorStorage.FULL_ROWS, wide)) {
            SeenRows seen = studio.seen();
            // Rows left of the camera's axis are those of the left tile: the axis passes between the tiles.
            assertThat(seen.count(0, seen.lit(left))).isPositive();
            assertThat(seen.count(0, seen.lit(left).and(p -> p.vx() > 0))).isZero();
            Update update = studio.edit(l -> l.withIntensity(3));
            assertWork(update, 0, seen.count(0, p -> p.vx() < 0), 0, 0);
        }
    }

    static Stream<Arguments> picturesThatRefresh() {
        Picture edges = StudioScene.of(LightType.POINT).picture().withSampling(new Sampling(Antialias.EDGES, 2));
        return Stream.of(Arguments.of("depth", edges, edges.withDepth(1)), Arguments.of("size", edges, edges.withSize(20, 16)),
                Arguments.of("antialias", edges, edges.withSampling(new Sampling(Antialias.OFF, 2))),
                Arguments.of("samples", edges, edges.withSampling(new Sampling(Antialias.EDGES, 3))));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("picturesThatRefresh")
    void anotherPicture_bringsTheEditToTheMirrors(String what, Picture before, Picture after) {
        Scene scene = StudioScene.of(LightType.POINT).withPicture(before);
        Scene edited = scene.withLight(scene.lights().getFirst().withIntensity(0.3));
        try (Renderer renderer = new Renderer(Options.DEFAULT.withReflections(Reflections.STALE).withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            assertThat(renderer.reflectionsAreCurrent()).isFalse();
            renderer.render(edited.withPicture(after), Progress.NONE);
            assertThat(renderer.reflectionsAreCurrent()).isTrue();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edited.withPicture(after)).trace(), "refreshed-" + what);
        }
    }
}

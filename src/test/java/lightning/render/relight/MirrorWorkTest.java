package lightning.render.relight;

import static lightning.render.relight.StudioRenderer.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.ReferenceRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the least work with mirrors: larger and smaller depth, stale and current reflections, several tiles. */
class MirrorWorkTest {
    private static final Vec3 ELSEWHERE = new Vec3(-1, 5, 3);

    private static StudioRenderer current(MirrorStorage storage) {
        return new StudioRenderer(ReflectionMode.CURRENT, storage, StudioScene.of(LightType.SPOT));
    }

    /** Returns the number of rows of a level and all deeper ones that a light reaches. */
    private static long reachedFrom(int level, StudioRenderer studio) {
        ReferenceRows reference = studio.referenceRows();
        long count = 0;
        for (int k = level; k <= studio.scene().picture().depth(); k++) {
            count += reference.count(k, reference.isReached(studio.key()));
        }
        return count;
    }

    private static long mirroredFrom(int level, StudioRenderer studio) {
        ReferenceRows reference = studio.referenceRows();
        long count = 0;
        for (int k = level; k < studio.scene().picture().depth(); k++) {
            count += reference.count(k, reference::isMirror);
        }
        return count;
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void deeperRecursion_tracesOnlyNewLevel(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            UpdateResult update = studio.depth(3);
            ReferenceRows reference = studio.referenceRows();
            assertThat(reference.rowsOfLevel(3)).isNotEmpty();
            assertWork(update, reference.rowsOfLevel(3).size(), reference.rowsFrom(0), reference.count(2, reference::isMirror),
                    reference.count(3, reference.isReached(studio.key())));
        }
    }

    @Test
    void shallowerRecursion_castsNoRay() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            UpdateResult update = studio.depth(1);
            assertWork(update, 0, studio.referenceRows().rowsFrom(0), 0, 0);
        }
    }

    @Test
    void recursionWithoutMirrors_composesFirstLevel() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            UpdateResult update = studio.depth(0);
            assertWork(update, 0, studio.referenceRows().rowsOfLevel(0).size(), 0, 0);
        }
    }

    @Test
    void recursionBeyondLastMirror_doesNothing() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene oneMirror = new Scene(scene.picture().withDepth(1), scene.camera(), scene.world(), scene.materials(),
                scene.nodes().subList(0, 2), scene.lights());
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS, oneMirror)) {
            assertThat(studio.referenceRows().rowsOfLevel(1)).isNotEmpty();
            assertWork(studio.depth(10), 0, 0, 0, 0);
        }
    }

    @Test
    void staleReflections_areUntouchedUntilUpdated() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            ReferenceRows reference = studio.referenceRows();
            assertWork(studio.edit(l -> l.withPosition(ELSEWHERE)), reference.rowsOfLevel(0).size(), reference.rowsOfLevel(0).size(), 0,
                    reference.count(0, studio.referenceRows().isReached(studio.key())));
            assertThat(studio.renderer().cache().hasCurrentReflections()).isFalse();
            assertWork(studio.renderer().updateReflections(Progress.NONE), reference.rowsFrom(1), reference.rowsFrom(0), 0,
                    reachedFrom(1, studio));
            assertThat(studio.renderer().cache().hasCurrentReflections()).isTrue();
        }
    }

    @Test
    void currentReflections_moveLightOnAllLevels() {
        try (StudioRenderer studio = current(MirrorStorage.FULL_ROWS)) {
            UpdateResult update = studio.edit(l -> l.withPosition(ELSEWHERE));
            long rows = studio.referenceRows().rowsFrom(0);
            assertWork(update, rows, rows, 0, reachedFrom(0, studio));
        }
    }

    @Test
    void currentReflections_recolorWithoutRays() {
        try (StudioRenderer studio = current(MirrorStorage.FULL_ROWS)) {
            UpdateResult update = studio.edit(l -> l.withColor(new Rgb(1, 0.5, 0)));
            assertWork(update, 0, studio.referenceRows().rowsFrom(0), 0, 0);
        }
    }

    @Test
    void currentReflectionsAsHitShapes_reuseStoredShapes() {
        try (StudioRenderer studio = current(MirrorStorage.HIT_SHAPES)) {
            UpdateResult update = studio.edit(l -> l.withColor(new Rgb(1, 0.5, 0)));
            assertWork(update, studio.referenceRows().rowsFrom(1), studio.referenceRows().rowsFrom(0), mirroredFrom(0, studio),
                    reachedFrom(1, studio));
        }
    }

    /** The light's layer is missing only on that level. */
    @Test
    void lightOffWhenLevelAdded_isCastWhenSwitchedOn() {
        try (StudioRenderer studio = current(MirrorStorage.FULL_ROWS)) {
            studio.edit(l -> l.withOn(false));
            assertThat(studio.depth(3).rays().shadow()).isZero();
            UpdateResult update = studio.edit(l -> l.withOn(true));
            ReferenceRows reference = studio.referenceRows();
            assertWork(update, reference.rowsOfLevel(3).size(), reference.rowsFrom(0), 0,
                    reference.count(3, reference.isReached(studio.key())));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "light-on-a-new-level");
        }
    }

    /** Here only the falloff of the layer would have been written. */
    @Test
    void lightOffWhenLevelAdded_canBeEditedMeanwhile() {
        try (StudioRenderer studio = current(MirrorStorage.FULL_ROWS)) {
            studio.edit(l -> l.withOn(false));
            studio.depth(3);
            studio.edit(l -> l.withOn(true).withDropoff(5).withAngle(25));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "light-on-a-new-level");
        }
    }

    /** Films are not kept here, and the rows of a tile are composed together. */
    @Test
    void recoloring_composesOnlyLitTiles() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light left = StudioScene.key(LightType.SPOT).withPosition(new Vec3(-3.4, 0, 0)).withDirection(new Vec3(0, -1, 0));
        Scene wide = scene.withPicture(new PictureSettings(64, 24, 0)).withLights(List.of(left));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS, wide)) {
            ReferenceRows reference = studio.referenceRows();
            // Rows left of the camera's axis are in the left tile: the axis passes between the tiles.
            assertThat(reference.count(0, reference.isLit(left))).isPositive();
            assertThat(reference.count(0, reference.isLit(left).and(p -> p.vx() > 0))).isZero();
            UpdateResult update = studio.edit(l -> l.withIntensity(3));
            assertWork(update, 0, reference.count(0, p -> p.vx() < 0), 0, 0);
        }
    }

    static Stream<Arguments> refreshingImages() {
        PictureSettings edges = StudioScene.of(LightType.POINT).picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 2));
        return Stream.of(Arguments.of("depth", edges, edges.withDepth(1)), Arguments.of("size", edges, edges.withSize(20, 16)),
                Arguments.of("antialias", edges, edges.withSampling(new SamplingSettings(AntialiasMode.OFF, 2))),
                Arguments.of("samples", edges, edges.withSampling(new SamplingSettings(AntialiasMode.EDGES, 3))));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("refreshingImages")
    void changedImageSettings_refreshMirrors(String description, PictureSettings before, PictureSettings after) {
        Scene scene = StudioScene.of(LightType.POINT).withPicture(before);
        Scene edited = scene.withLight(scene.lights().getFirst().withIntensity(0.3));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            assertThat(renderer.cache().hasCurrentReflections()).isFalse();
            renderer.render(edited.withPicture(after), Progress.NONE);
            assertThat(renderer.cache().hasCurrentReflections()).isTrue();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edited.withPicture(after)).trace(), "refreshed-" + description);
        }
    }
}

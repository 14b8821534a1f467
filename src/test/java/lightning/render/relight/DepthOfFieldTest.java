package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.SceneEffects;
import lightning.scene.light.LightType;
import lightning.scene.value.Lens;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests pictures through an open lens: by the optics of a thin lens, and that edits keep and relight the samples. */
class DepthOfFieldTest {
    private static final Lens LENS = new Lens(0.3, 5, 6, 15);

    private static Scene studio(AntialiasMode antialias) {
        Scene scene = StudioScene.of(LightType.POINT);
        return scene.withPicture(scene.picture().withSize(70, 50).withSampling(new SamplingSettings(antialias, 4)))
                .withCamera(scene.camera().withLens(LENS));
    }

    private static Scene read(String text) throws Exception {
        return JenReader.read("jen 1\n" + text, "test", Path.of("")).scene();
    }

    private static Film trace(Scene scene) {
        try (WorkerPool workers = new WorkerPool(2)) {
            return new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
        }
    }

    private static Scene withLens(Scene scene, Lens lens) {
        return scene.withCamera(scene.camera().withLens(lens));
    }

    /**
     * A small square that glows, seen from the front out of focus, is a disc of the radius of the circle of confusion, aperture · |1/f − 1/d|
     * at distance 1, and has the light that it has in focus.
     */
    @ParameterizedTest
    @CsvSource({"0.2, 4", "0.2, 20", "0.1, 3", "0.3, 1000"})
    void point_spreadsToTheCircleOfConfusion(double aperture, double focus) throws Exception {
        double distance = 8;
        Scene scene = read("""
                picture { size 81 81  antialias every  samples 8 }
                camera { from 0 0 8  to 0 0 0  fov 20 }
                world { ambience 0  background 0 0 0 }
                material glowing { glow 1 1 1  diffuse 0 0 0 }
                plane dot { material glowing  rotate 90 0 0  scale 0.1 1 0.1 }
                """);
        Film film = trace(withLens(scene, new Lens(aperture, focus, 0, 0)));
        double pixel = 2 * Math.tan(Math.toRadians(10)) / 81;
        double radius = aperture * Math.abs(1 / focus - 1 / distance) / pixel;
        double side = 0.1 / distance / pixel;
        double sum = 0;
        double moment = 0;
        for (int y = 0; y < 81; y++) {
            for (int x = 0; x < 81; x++) {
                double light = film.red(x, y);
                double away = Math.hypot(x - 40, y - 40);
                sum += light;
                moment += light * away * away;
                assertThat(light).as(x + " " + y).satisfies(v -> assertThat(away < radius + side + 1 || v == 0).isTrue());
            }
        }
        assertThat(sum).isCloseTo(side * side, within(0.1 * side * side));
        // The mean square distance from the center is r² / 2 for a disc and s² / 6 for a square.
        assertThat(Math.sqrt(2 * (moment / sum - side * side / 6))).isCloseTo(radius, within(0.05 * radius + 0.1));
    }

    /** All samples of a pixel see the same point of the plane of focus, so the picture differs at most by rounding. */
    @ParameterizedTest
    @EnumSource(names = {"EDGES", "EVERY"})
    void planeInFocus_isAsSharpAsThroughAPinhole(AntialiasMode antialias) throws Exception {
        Scene pinhole = read("""
                picture { size 40 40  antialias every  samples 4 }
                camera { from 0.1 0.2 6  to 0.1 0.2 0  fov 30 }
                world { ambience 0  background 0.2 0.3 0.4 }
                material glowing { glow 1 0.5 0.2  diffuse 0 0 0 }
                plane card { material glowing  rotate 90 0 20  scale 0.8 1 0.5 }
                """);
        Film sharp = trace(pinhole);
        Scene scene = withLens(pinhole, new Lens(0.5, 6, 0, 0));
        Film film = trace(scene.withPicture(scene.picture().withSampling(new SamplingSettings(antialias, 4))));
        int different = 0;
        for (int i = 0; i < 1600; i++) {
            different += Math.abs(film.red(i % 40, i / 40) - sharp.red(i % 40, i / 40)) > 1e-6 ? 1 : 0;
        }
        assertThat(different).isLessThanOrEqualTo(4);
    }

    /** A near object is blurred over the sharp one behind it: the lens sees past its edge. */
    @Test
    void blurInFront_spreadsOverWhatIsInFocus() throws Exception {
        Scene pinhole = read("""
                picture { size 60 20  antialias every  samples 8 }
                camera { from 0 0 6  to 0 0 0  fov 20 }
                world { ambience 0  background 0 0 0 }
                material red { glow 1 0 0  diffuse 0 0 0 }
                material green { glow 0 1 0  diffuse 0 0 0 }
                plane far { material green  rotate 90 0 0  scale 9 1 9 }
                plane near { material red  at -1.5 0 3  rotate 90 0 0  scale 3 1 3 }
                """);
        Film film = trace(withLens(pinhole, new Lens(0.5, 6, 0, 0)));
        int mixed = 0;
        for (int x = 0; x < 60; x++) {
            assertThat(film.red(x, 10) + film.green(x, 10)).isCloseTo(1, within(1e-5f));
            mixed += film.red(x, 10) > 0.02 && film.green(x, 10) > 0.02 ? 1 : 0;
        }
        double pixel = 2 * Math.tan(Math.toRadians(10)) / 20;
        assertThat(mixed).isCloseTo((int) (2 * 0.5 * (1 / 3.0 - 1 / 6.0) / pixel), within(2));
        assertThat(film.red(29, 10) + film.red(30, 10)).isCloseTo(1, within(0.1f));
    }

    @ParameterizedTest
    @EnumSource(names = {"EDGES", "EVERY"})
    void everyRenderer_equalsTheReference(AntialiasMode antialias) {
        Scene scene = studio(antialias);
        Film reference = new ReferenceTracer(scene).trace();
        FilmAssert.assertSameBits(trace(scene), reference, "lens-full");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), reference, "lens-relight");
            Scene dimmed = scene.withLight(scene.lights().getFirst().withPosition(new Vec3(1, 4, 2)).withColor(new Rgb(0.2, 1, 0.3)));
            assertThat(renderer.render(dimmed, Progress.NONE).rays().eye()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(dimmed).trace(), "lens-light");
        }
    }

    /** Pixel centers, and the paths of gathered light that start at them, stay. */
    @Test
    void lensEdit_retracesOnlySamples() {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene lit = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.INITIAL)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(lit, Progress.NONE);
            for (Lens lens : new Lens[] {LENS.withFocus(7), LENS.withAperture(0.1), LENS.withBlades(0)}) {
                Scene edited = withLens(lit, lens);
                RayCounts rays = renderer.render(edited, Progress.NONE).rays();
                assertThat(rays.eye()).isEqualTo(70L * 50 * 16);
                assertThat(rays.gather()).isZero();
                FilmAssert.assertSameBits(renderer.film(), trace(edited), "lens-edit");
            }
            Scene closed = withLens(lit, Lens.PINHOLE);
            assertThat(renderer.render(closed, Progress.NONE).rays().gather()).isZero();
            FilmAssert.assertSameBits(renderer.film(), trace(closed), "lens-closed");
            renderer.render(lit, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), trace(lit), "lens-opened");
        }
    }

    /** Focus and blades of a pinhole, and any lens without finer samples, change no bit and cost nothing. */
    @Test
    void pinhole_costsNothing() {
        Scene pinhole = withLens(studio(AntialiasMode.EDGES), Lens.PINHOLE);
        Scene off = pinhole.withPicture(pinhole.picture().withSampling(new SamplingSettings(AntialiasMode.OFF, 4)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(pinhole, Progress.NONE);
            long bytes = renderer.cache().bytes();
            UpdateResult update = renderer.render(withLens(pinhole, LENS.withAperture(0)), Progress.NONE);
            assertThat(update.plan()).isEqualTo(new UpdatePlan.Nothing());
            assertThat(renderer.cache().bytes()).isEqualTo(bytes);
            renderer.render(off, Progress.NONE);
            assertThat(renderer.render(withLens(off, LENS), Progress.NONE).plan()).isEqualTo(new UpdatePlan.Nothing());
        }
    }

    /** Mirrors that show the present lights show the present scene, whatever a lens is like that blurs nothing. */
    @Test
    void turnedBladesOfAPinhole_leaveReflectionsCurrent() {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene pinhole = withLens(scene, Lens.PINHOLE);
        Scene dim = withLens(scene, LENS.withAperture(0)).withLight(scene.lights().getFirst().withIntensity(0.3));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE))) {
            renderer.render(pinhole, Progress.NONE);
            renderer.render(dim, Progress.NONE);
            assertThat(renderer.cache().hasCurrentReflections()).isFalse();
            renderer.render(dim.withLight(scene.lights().getFirst()), Progress.NONE);
            assertThat(renderer.cache().hasCurrentReflections()).isTrue();
        }
    }

    /** A lens much larger than the scene needs larger boxes, which an edit must not keep small. */
    @Test
    void lensLargerThanTheScene_equalsTheReference() {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene huge = withLens(scene, new Lens(1e6, 6.5, 0, 0));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(huge, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(huge).trace(), "lens-huge");
        }
    }

    @Test
    void effect_isUsedOnlyWithSamplesAndRemovable() {
        Scene scene = studio(AntialiasMode.EDGES);
        assertThat(SceneEffects.of(scene).has(RenderEffect.DEPTH_OF_FIELD)).isTrue();
        assertThat(SceneEffects.of(studio(AntialiasMode.OFF)).has(RenderEffect.DEPTH_OF_FIELD)).isFalse();
    }
}

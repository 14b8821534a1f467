package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests lights at special cases of the equation and at numeric limits; each edit is made and undone. */
class ExtremeLightTest {
    private static final Scene STUDIO = StudioScene.of(LightType.SPOT);

    /** Returns the stored point of the row at the center of the picture, on the sphere. */
    private static SurfacePoint row() {
        Geometry geometry = Geometry.of(STUDIO);
        Ray ray = new PixelRays(STUDIO).ray(15, 10);
        return geometry.surface(BruteForce.nearest(geometry, ray), ray);
    }

    private static Vec3 rowPoint() {
        return Geometry.of(STUDIO).toScene(new Vec3(row().px(), row().py(), row().pz()));
    }

    /** Returns a position at the row's exact height, so that its cosine from a downward axis is 0. */
    private static Vec3 nextToRow() {
        SurfacePoint row = row();
        return rowPoint().plus(new Vec3(row.nx(), 0, row.nz()).normalized().times(2));
    }

    static Stream<Arguments> edits() {
        List<Arguments> edits = new ArrayList<>();
        for (int k : new int[] {0, 3, 6, 9, 12}) {
            edit(edits, "grazing the floor from 1e-" + k + " above", l -> l.withPosition(new Vec3(0, -1 + Math.pow(10, -k), 3)));
            edit(edits, "grazing the floor from 1e-" + k + " below", l -> l.withPosition(new Vec3(0, -1 - Math.pow(10, -k), 3)));
            edit(edits, "directional, 1e-" + k + " above the floor",
                    l -> l.withType(LightType.DIRECTIONAL).withDirection(new Vec3(1, -Math.pow(10, -k), 0)));
        }
        edit(edits, "in a row", l -> l.withPosition(rowPoint()));
        edit(edits, "in a row, not fading from 1/0", l -> l.withPosition(rowPoint()).withAttenuation(new Attenuation(0, 1, 1)));
        edit(edits, "in the floor", l -> l.withPosition(new Vec3(0, -1, 2)));
        edit(edits, "on the ball", l -> l.withPosition(new Vec3(0, 1, 0)));
        edit(edits, "inside the ball", l -> l.withPosition(new Vec3(0.1, 0.2, 0.3)).withType(LightType.POINT));
        edit(edits, "at the eye", l -> l.withPosition(new Vec3(0, 2, 7)));
        edit(edits, "1e10 away",
                l -> l.withPosition(new Vec3(3e9, 8e9, 5e9)).withDirection(new Vec3(-3, -8, -5)).withAttenuation(Attenuation.NONE));
        edit(edits, "1e10 away, fading", l -> l.withPosition(new Vec3(3e9, 8e9, 5e9)).withDirection(new Vec3(-3, -8, -5)));
        for (double a : new double[] {0, 1e-30, 1e30}) {
            edit(edits, "constant " + a, l -> l.withAttenuation(new Attenuation(a, 0, 0)));
            edit(edits, "linear " + a, l -> l.withAttenuation(new Attenuation(0, a, 0)));
            edit(edits, "quadratic " + a, l -> l.withAttenuation(new Attenuation(0, 0, a)));
            edit(edits, "all " + a, l -> l.withAttenuation(new Attenuation(a, a, a)));
        }
        for (double angle : new double[] {0, 1e-7, 1e-3, 90, 180}) {
            edit(edits, "angle " + angle, l -> l.withAngle(angle));
            edit(edits, "angle " + angle + ", a row in its plane",
                    l -> l.withPosition(nextToRow()).withDirection(new Vec3(0, -1, 0)).withAngle(angle));
        }
        for (double dropoff : new double[] {0, 0.1, 128, 10_000, 1e6}) {
            edit(edits, "dropoff " + dropoff, l -> l.withDropoff(dropoff));
            edit(edits, "dropoff " + dropoff + ", rows on its far side", l -> l.withDropoff(dropoff).withAngle(180));
        }
        for (double intensity : new double[] {0, 1e-300, 1e-45, 1e-38, 1e22, 1e30}) {
            edit(edits, "intensity " + intensity, l -> l.withIntensity(intensity));
        }
        for (Rgb color : new Rgb[] {new Rgb(0, 1, 1), new Rgb(1, 0, 1e-38), Rgb.BLACK, new Rgb(1000, 1e-40, 0)}) {
            edit(edits, "color " + color, l -> l.withColor(color));
        }
        edit(edits, "nothing left", l -> l.withIntensity(1e-25).withDropoff(400));
        return edits.stream();
    }

    private static void edit(List<Arguments> edits, String name, UnaryOperator<Light> edit) {
        edits.add(Arguments.of(name, edit));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("edits")
    void editAndUndo_keepGuarantees(String name, UnaryOperator<Light> edit) {
        Light key = STUDIO.lights().getFirst();
        Light edited = edit.apply(key);
        // Undoes one attribute at a time: ratios are then multiplied one after the other.
        Light half = edited.withIntensity(key.intensity()).withColor(key.color());
        keepGuarantees(name, List.of(STUDIO, STUDIO.withLight(edited), STUDIO, STUDIO.withLight(edited), STUDIO.withLight(half), STUDIO));
    }

    private static void keepGuarantees(String name, List<Scene> scenes) {
        try (Renderer exact = renderer(Accuracy.EXACT); Renderer ratio = renderer(Accuracy.RATIO)) {
            for (Scene scene : scenes) {
                var reference = new ReferenceTracer(scene).trace();
                exact.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(exact.film(), reference, name);
                UpdateResult update = ratio.render(scene, Progress.NONE);
                assertThat(FilmError.largestError(ratio.film(), reference)).as(name).isLessThanOrEqualTo(update.errorBound());
            }
        }
    }

    private static Renderer renderer(Accuracy accuracy) {
        return new Renderer(new RenderOptions(accuracy, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1));
    }

    /** "Subtract the old, add the new" would fail: 1e16 + 1 − 1e16 is 0. */
    @Test
    void deletedBrightestLight_leavesNoError() {
        List<Light> lights = new ArrayList<>();
        for (int l = 0; l < 30; l++) {
            lights.add(StudioScene.key(LightType.POINT).withName("l" + l).withPosition(new Vec3(l % 6 - 2.5, 3 + l % 3, l / 6 - 1))
                    .withIntensity(l == 13 ? 1e16 : 1 + l));
        }
        Scene bright = STUDIO.withLights(lights);
        Scene reduced = STUDIO.withLights(lights.stream().filter(l -> l.intensity() < 1e16).toList());
        keepGuarantees("thirty lights", List.of(bright, reduced, bright, reduced.withLight(lights.getFirst().withIntensity(2)), reduced));
        assertThat(FilmError.largestError(new ReferenceTracer(reduced).trace(), new ReferenceTracer(bright).trace())).isGreaterThan(1e13);
    }

    /** Weight and falloff are well within float range, their product far below 1: the loss must be reported. */
    @Test
    void underflowedProduct_isRecomputedInTime() {
        Light key = STUDIO.lights().getFirst();
        Scene dim = STUDIO.withLight(key.withIntensity(1e-25));
        Scene narrow = STUDIO.withLight(key.withIntensity(1e-25).withDropoff(1500));
        keepGuarantees("underflow", List.of(STUDIO, dim, narrow, dim, STUDIO, dim, narrow, dim, STUDIO));
    }
}

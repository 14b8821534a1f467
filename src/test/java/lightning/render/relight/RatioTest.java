package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.DisplayCurve;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.SceneCoverage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that at accuracy ratio no value differs from the reference trace by more than the reported bound. */
class RatioTest {

    /** Most edits discard scaled contributions, so half of the sessions contain only edits that scale. */
    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.oneOf(EditSession.sessions(), EditSession.scaleSessions());
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    @Slow
    void everyValue_isWithinReportedBound(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll MirrorStorage storage, @ForAll @IntRange(min = 1, max = 3) int threads) {
        RenderOptions options = new RenderOptions(Accuracy.RATIO, reflections, storage, threads);
        try (Renderer renderer = new Renderer(options)) {
            boolean differs = false;
            for (int step : session.steps()) {
                UpdateResult update = renderer.render(session.scenes().get(step), Progress.NONE);
                differs |= !ReferenceCheck.assertGuarantee(renderer, update, "after edit " + step).isNone();
            }
            SceneCoverage.collect("differs from the exact picture", differs, 3);
        }
    }

    @Provide
    Arbitrary<EditSession> extremes() {
        return EditSession.extremeSessions();
    }

    /** Includes exposures at which an error is refreshed early, late or never. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void extremes_areWithinReportedBound(@ForAll("extremes") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll @From("exposures") double exposure) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.RATIO, reflections, MirrorStorage.FULL_ROWS, 1))) {
            renderer.setView(exposure, DisplayCurve.SRGB);
            boolean differs = false;
            for (int step : session.steps()) {
                UpdateResult update = renderer.render(session.scenes().get(step), Progress.NONE);
                differs |= !ReferenceCheck.assertGuarantee(renderer, update, "after edit " + step).isNone();
            }
            SceneCoverage.collect("differs from the exact picture", differs, 3);
        }
    }

    @Provide
    Arbitrary<Double> exposures() {
        return Arbitraries.of(-1000.0, -60.0, -20.0, 0.0, 40.0);
    }

    /** The first contributions have lost digits before any scaling. */
    @ParameterizedTest
    @CsvSource({"1e-34, 1e10", "1e-20, 1e20", "1e-25, 1e15", "1e-30, 1e10"})
    void underflowedContributions_areReportedWhenScaledUp(double intensity, double constant) {
        Light dim = Light.of("l", LightType.POINT).withPosition(new Vec3(3, 4, 5)).withIntensity(intensity)
                .withAttenuation(new Attenuation(constant, 0, 0));
        Scene scene = new Scene(new PictureSettings(16, 16, 0), Camera.DEFAULT, World.DEFAULT, List.of(),
                List.of(new Shape(Solid.SPHERE, "s", "default", Placement.IDENTITY)), List.of(dim));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withAccuracy(Accuracy.RATIO))) {
            renderer.render(scene, Progress.NONE);
            for (double bright : new double[] {1e4, 1e10}) {
                Scene edited = scene.withLight(dim.withIntensity(bright));
                UpdateResult update = renderer.render(edited, Progress.NONE);
                assertThat(renderer.scene()).isEqualTo(edited);
                ReferenceCheck.assertGuarantee(renderer, update, "at " + bright);
            }
        }
    }

    @Test
    void rowsEnteringConeOfMatteTile_areDiffuseOnly() {
        Light spot = StudioScene.key(LightType.SPOT);
        Scene scene = new Scene(new PictureSettings(16, 16, 0), Camera.DEFAULT, World.DEFAULT, List.of(),
                List.of(new Shape(Solid.SPHERE, "ball", "default", Placement.IDENTITY)), List.of(spot));
        Scene wider = scene.withLight(spot.withAngle(25));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withAccuracy(Accuracy.RATIO))) {
            renderer.render(scene, Progress.NONE);
            UpdateResult update = renderer.render(wider, Progress.NONE);
            assertThat(FilmError.largestError(renderer.film(), new ReferenceTracer(wider).trace()))
                    .isLessThanOrEqualTo(update.errorBound());
        }
    }
}

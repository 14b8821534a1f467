package lightning.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.sample.Session;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.World;
import lightning.shading.Progress;
import lightning.shading.ReferenceTracer;
import lightning.shading.SceneCoverage;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.api.Test;

/** At level ratio no value is further from the reference trace than the update says. */
class RatioTest {

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void everyValueIsWithinTheReportedBound(@ForAll("sessions") Session session, @ForAll Reflections reflections,
            @ForAll MirrorStorage storage, @ForAll @IntRange(min = 1, max = 3) int threads) {
        Options options = new Options(Accuracy.RATIO, reflections, storage, threads);
        try (Renderer renderer = new Renderer(options)) {
            boolean differs = false;
            for (int step = 0; step < session.scenes().size(); step++) {
                Update update = renderer.render(session.scenes().get(step), Progress.NONE);
                double error = FilmErrors.largestError(renderer.film(), Oracle.of(renderer.cache()));
                assertThat(error).as("after edit " + step + ": " + update.plan().text())
                        .isLessThanOrEqualTo(update.errorBound());
                differs |= error > 0;
            }
            SceneCoverage.collect("differs from the exact picture", differs, 5);
        }
    }

    @Test
    void rowsThatEnterTheConeOfAMattTile_haveDiffuseContributionsOnly() {
        Light spot = StudioScene.key(LightType.SPOT);
        Scene scene = new Scene(new Picture(16, 16, 0), Camera.DEFAULT, World.DEFAULT, List.of(),
                List.of(new Shape.Sphere("ball", "default", Placement.IDENTITY)), List.of(spot));
        Scene wider = scene.withLight(spot.withAngle(25));
        try (Renderer renderer = new Renderer(Options.DEFAULT.withAccuracy(Accuracy.RATIO))) {
            renderer.render(scene, Progress.NONE);
            Update update = renderer.render(wider, Progress.NONE);
            assertThat(FilmErrors.largestError(renderer.film(), new ReferenceTracer(wider).trace())).isLessThanOrEqualTo(update.errorBound());
        }
    }
}

package lightning.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.Set;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.sample.SceneArbitraries;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.World;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.api.Test;

class PixelExplainerTest {
    @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void color_isTheReferencesInEveryBit(@ForAll("scenes") Scene scene) {
        SceneCoverage.collect(scene);
        var reference = new ReferenceTracer(scene);
        var explainer = new PixelExplainer(scene);
        Set<LightReport.State> seen = EnumSet.noneOf(LightReport.State.class);
        boolean mirrored = false;
        for (int y = 0; y < scene.picture().height(); y += 3) {
            for (int x = 0; x < scene.picture().width(); x += 3) {
                PointReport report = explainer.pixel(x, y);
                assertThat(report.color()).as("pixel %d,%d", x, y).containsExactly(reference.pixel(x, y));
                report.lights().forEach(light -> seen.add(light.state()));
                mirrored |= report.reflected() != null;
            }
        }
        for (LightReport.State state : LightReport.State.values()) {
            SceneCoverage.collect(state.toString(), seen.contains(state), 10);
        }
        SceneCoverage.collect("reported mirrored", mirrored, 20);
    }

    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    /** A ball over a floor, a light above it: the floor below is in the ball's shadow. */
    @Test
    void shadow_namesTheNearestShapeInBetween() {
        Scene scene = new Scene(new Picture(1, 1, 0), new Camera(new Vec3(0, 1, 9), Vec3.ZERO, Vec3.Y, 20),
                new World(0, Rgb.BLACK), java.util.List.of(), java.util.List.of(
                        new Shape.Plane("floor", "default", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))),
                        new Shape.Sphere("high", "default", new Placement(new Vec3(0, 8, 0), Vec3.ZERO, Vec3.ONE)),
                        new Shape.Sphere("low", "default", new Placement(new Vec3(0, 5, 0), Vec3.ZERO, Vec3.ONE))),
                java.util.List.of(Light.of("top", LightType.POINT).withPosition(new Vec3(0, 20, 0)),
                        Light.of("between", LightType.POINT).withPosition(new Vec3(0, 3, 0))));
        var explainer = new PixelExplainer(scene);
        PointReport report = explainer.pixel(0, 0);
        assertThat(explainer.geometry().shape(report.at().shape()).shape().name()).isEqualTo("floor");
        LightReport top = report.lights().getFirst();
        assertThat(top.state()).isEqualTo(LightReport.State.SHADOWED);
        assertThat(explainer.geometry().shape(top.blocker()).shape().name()).isEqualTo("low");
        assertThat(report.lights().getLast().state()).isEqualTo(LightReport.State.LIT);
    }
}

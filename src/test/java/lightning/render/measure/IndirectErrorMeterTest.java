package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.sample.IndirectScenes;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class IndirectErrorMeterTest {
    private static final double EPSILON = 1e-5;
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(2);

    private static final Ray DOWN = new Ray(new Vec3(0, 0, 0), new Vec3(0, -1, 0));

    private static Scene scene(String text) throws Exception {
        return JenReader.read("jen 1\npicture { size 24 16  depth 0 }\n" + text, "scene.jen", Path.of("")).scene();
    }

    /** In a closed glowing sphere, light of n bounces is the geometric series glow · (1 + ρ + … + ρⁿ⁻¹) everywhere. */
    @Test
    void glowingSphere_givesTheGeometricSeries() throws Exception {
        Scene scene = scene("camera { from 0 0 0  to 0 0 -1 }\nmaterial shell { diffuse 0.5 0.5 0.5  glow 0.2 0.2 0.2 }\n"
                + "sphere around { material shell }\n");
        BruteForceGather gather = new BruteForceGather(scene, Geometry.of(scene));
        double[] light = gather.luminances(DOWN, 7);
        double expected = 0;
        for (int bounce = 0; bounce < light.length; bounce++) {
            expected += 0.2 * Math.pow(0.5, bounce);
            assertThat(light[bounce]).isEqualTo(expected, within(EPSILON));
        }
    }

    @Test
    void openScene_collectsBackgroundOnlyIfItCounts() throws Exception {
        Scene scene = scene("camera { from 0 0 0  to 0 -1 -1 }\nworld { background 0.3 0.3 0.3 }\nmaterial white { diffuse 0.8 0.8 0.8 }\n"
                + "plane floor { material white  at 0 -1 0 }\n");
        Geometry geometry = Geometry.of(scene);
        assertThat(new BruteForceGather(scene, geometry).luminances(DOWN, 7)).containsOnly(0);
        Scene lit = scene.withPicture(
                scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withBackground(true))));
        for (double light : new BruteForceGather(lit, geometry).luminances(DOWN, 7)) {
            assertThat(light).isEqualTo(0.3, within(EPSILON));
        }
    }

    /** Rays below a black floor would collect nothing. */
    @Test
    void bumpedFloor_collectsLightFromAboveOnly() throws Exception {
        Scene scene = IndirectScenes.withBumps(scene("camera { from 0 0 0  to 0 -1 -1 }\nworld { background 0.3 0.3 0.3 }\n"
                + "material black { diffuse 0 0 0 }\nplane floor { material black  at 0 -1 0 }\n"));
        Scene lit = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withBackground(true))));
        BruteForceGather gather = new BruteForceGather(lit, Geometry.of(lit));
        int tilted = 0;
        for (int i = 0; i < 20; i++) {
            Ray ray = new Ray(new Vec3(0, 0, 0), new Vec3(0.02 * i, -1, -0.015 * i).normalized());
            tilted += Geometry.of(lit).normalSteps(0, ray) == null ? 0 : 1;
            assertThat(gather.luminances(ray, i)[0]).isEqualTo(0.3, within(EPSILON));
        }
        assertThat(tilted).isPositive();
    }

    @Test
    void room_hasSmallErrorAndLessWithMoreRays() {
        try (IndirectErrorMeter meter = new IndirectErrorMeter(IndirectScenes.all().get("room"), OPTIONS)) {
            assertThat(meter.traceReference(40, Double.POSITIVE_INFINITY, Progress.NONE)).isBetween(1, 40);
            IndirectErrorMeter.Measured few = meter.measure(new IndirectSettings(2, 16, 8, false), 1, Progress.NONE);
            IndirectErrorMeter.Measured many = meter.measure(new IndirectSettings(2, 256, 2, false), 1, Progress.NONE);
            assertThat(many.error().mean()).isLessThan(few.error().mean()).isBetween(0.0, 0.1);
            assertThat(Math.abs(many.error().bias())).isLessThan(0.05);
            assertThat(many.error().missing()).isBetween(0.02, 0.5);
            assertThat(many.points()).isGreaterThan(few.points());
            assertThat(many.time().milliseconds()).hasSize(1);
        }
    }

    /** An environment lights the surfaces that the last rays hit only through the rays of another round. */
    @Test
    void roomBelowEnvironment_hasNoBiasForAnyNumberOfBounces() {
        Scene room = IndirectScenes.all().get("environment with a sun").withLights(List.of());
        try (IndirectErrorMeter meter = new IndirectErrorMeter(room, OPTIONS)) {
            meter.traceReference(60, Double.POSITIVE_INFINITY, Progress.NONE);
            for (int bounces : new int[] {1, 2, 3}) {
                IndirectErrorMeter.Measured many = meter.measure(new IndirectSettings(bounces, 256, 2, false), 1, Progress.NONE);
                assertThat(Math.abs(many.error().bias())).as("%d bounces", bounces).isLessThan(0.03);
            }
        }
    }

    @Test
    void sceneWithoutSurface_isRejected() {
        try (IndirectErrorMeter meter = new IndirectErrorMeter(IndirectScenes.all().get("empty"), OPTIONS)) {
            assertThat(meter.traceReference(8, Double.POSITIVE_INFINITY, Progress.NONE)).isZero();
            assertThatThrownBy(() -> meter.measure(IndirectSettings.DEFAULT, 1, Progress.NONE))
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }
}

package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.sample.IndirectScenes;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class ReflectionErrorMeterTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(2);

    private static Scene scene(String text) throws Exception {
        return JenReader.read("""
                jen 1
                picture { size 160 120 }
                camera { from 0 1 3  to 0 0 0 }
                world { ambience 0  background 0.2 0.2 0.2 }
                material metal { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.4 }
                plane floor { material metal  scale 8 1 8 }
                """ + text, "test", java.nio.file.Path.of("")).scene();
    }

    @Test
    void uniformSurroundings_areSeenWhole() throws Exception {
        Scene furnace = scene("material walls { diffuse 0 0 0  glow 0.25 0.5 1 }\nsphere sky { material walls  scale 50 50 50 }\n");
        double[] means = new BruteForceReflection(furnace, Geometry.of(furnace)).means(new Ray(new Vec3(0, 1, 3), new Vec3(0, -0.4, -1)
                .normalized()), 1);
        assertThat(means).containsExactly(new double[] {0.25, 0.5, 1, 0.25, 0.5, 1}, within(1e-9));
    }

    @Test
    void moreRays_haveSmallerErrorWithoutBias() throws Exception {
        Scene room = scene("""
                material red { diffuse 0.8 0.1 0.1 }
                sphere ball { material red  at 0.5 0.5 -0.5  scale 0.5 0.5 0.5 }
                cylinder box { material red  at -1 0.5 0  scale 0.3 0.5 0.3 }
                light key directional { direction 1 -2 -1 }
                """);
        try (var meter = new ReflectionErrorMeter(room, OPTIONS)) {
            assertThat(meter.traceReference(60, Double.POSITIVE_INFINITY, Progress.NONE)).isBetween(10, 60);
            ReflectionErrorMeter.Measured few = meter.measure(4, 1, Progress.NONE);
            ReflectionErrorMeter.Measured many = meter.measure(256, 1, Progress.NONE);
            assertThat(many.mean()).isLessThan(few.mean()).isBetween(0.0, 0.1);
            // Colors also contain highlights.
            assertThat(many.shown()).isBetween(0.0, many.mean() + 0.01);
            assertThat(Math.abs(many.bias())).isLessThan(0.05);
            assertThat(many.points()).isPositive();
        }
    }

    @Test
    void sceneWithoutBlurredReflections_isRejected() {
        try (var meter = new ReflectionErrorMeter(IndirectScenes.all().get("room"), OPTIONS)) {
            assertThat(meter.traceReference(8, Double.POSITIVE_INFINITY, Progress.NONE)).isZero();
            assertThatThrownBy(() -> meter.measure(16, 1, Progress.NONE)).isInstanceOf(IllegalArgumentException.class);
        }
    }
}

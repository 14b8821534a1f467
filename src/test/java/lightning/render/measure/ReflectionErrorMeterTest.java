package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.sample.IndirectScenes;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import org.junit.jupiter.api.Test;

class ReflectionErrorMeterTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(2);

    private static final String FLOOR = "plane floor { material metal  scale 8 1 8 }\n";

    private static Scene scene(String text) throws Exception {
        return JenReader.read("""
                jen 1
                picture { size 160 120 }
                camera { from 0 1 3  to 0 0 0 }
                world { ambience 0  background 0.2 0.2 0.2 }
                material metal { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.4 }
                """ + text, "test", java.nio.file.Path.of("")).scene();
    }

    @Test
    void uniformSurroundings_areSeenWhole() throws Exception {
        Scene furnace = scene(FLOOR + "material walls { diffuse 0 0 0  glow 0.25 0.5 1 }\nsphere sky { material walls  scale 50 50 50 }\n");
        double[] means = new BruteForceReflection(furnace, Geometry.of(furnace)).means(new Ray(new Vec3(0, 1, 3), new Vec3(0, -0.4, -1)
                .normalized()), 1);
        assertThat(means).containsExactly(new double[] {0.25, 0.5, 1, 0.25, 0.5, 1}, within(1e-9));
    }

    @Test
    void moreRays_haveSmallerErrorWithoutBias() throws Exception {
        Scene room = scene(FLOOR + """
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

    /** Sixteen rays of a lobe hardly ever meet the lamp, which is in a thousandth of the sky. */
    @Test
    void smallLampOfAnEnvironment_isSeenByFewRaysAsByMany() throws Exception {
        float[] image = new float[3 * 64 * 32];
        Arrays.fill(image, 0.2f);
        for (int pixel : new int[] {12 * 64 + 20, 12 * 64 + 21, 13 * 64 + 20, 13 * 64 + 21}) {
            Arrays.fill(image, 3 * pixel, 3 * pixel + 3, 40);
        }
        var lamp = new Environment("lamp.hdr", new EnvironmentMap(64, 32, image));
        Scene lit = scene("sphere ball { material metal  at 0 0 0  scale 0.9 0.9 0.9 }\n");
        Scene room = lit.withWorld(lit.world().withEnvironment(Optional.of(lamp)));
        try (var meter = new ReflectionErrorMeter(room, OPTIONS)) {
            meter.traceReference(200, Double.POSITIVE_INFINITY, Progress.NONE);
            ReflectionErrorMeter.Measured few = meter.measure(16, 1, Progress.NONE);
            ReflectionErrorMeter.Measured many = meter.measure(256, 1, Progress.NONE);
            assertThat(few.mean()).isLessThan(1.1 * many.mean());
            assertThat(many.mean()).isLessThan(0.03);
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

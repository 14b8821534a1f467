package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that a pixel of several samples is their mean. */
class SampleMeanTest {

    /** White disc, an emissive sphere seen from far away, on black: the sum of all pixels is its area. */
    private static Scene disc(AntialiasMode antialias, int grid) {
        Material glow = Material.of("glow").withAmbient(Rgb.WHITE).withDiffuse(Rgb.BLACK).withShininess(1);
        return new Scene(new PictureSettings(40, 40, 0, new SamplingSettings(antialias, grid)),
                new Camera(new Vec3(0, 0, 1000), Vec3.ZERO, Vec3.Y, 0.2), new World(1, Rgb.BLACK), List.of(glow),
                List.of(new Shape(Solid.SPHERE, "ball", "glow", Placement.IDENTITY)), List.of());
    }

    private static double area(Film film) {
        double sum = 0;
        for (int i = 0; i < 1600; i++) {
            sum += film.green(i % 40, i / 40);
        }
        return sum;
    }

    @Test
    void sumOverDisc_isItsArea() {
        double radius = 20 / (1000 * Math.tan(Math.toRadians(0.1)));
        double target = Math.PI * radius * radius;
        // Each pixel that the circle crosses, about 8 radii of them, is off by at most 1/grid, equally often in both directions.
        assertThat(area(new ReferenceTracer(disc(AntialiasMode.EVERY, 8)).trace())).isCloseTo(target, within(target * 0.002));
    }

    @Test
    void edgeDetection_findsEntireDiscBorder() {
        Film every = new ReferenceTracer(disc(AntialiasMode.EVERY, 4)).trace();
        Film edges = new ReferenceTracer(disc(AntialiasMode.EDGES, 4)).trace();
        assertThat(area(edges)).isCloseTo(area(every), within(area(every) * 0.002));
        assertThat(edges.green(20, 20)).isEqualTo(1);
        assertThat(edges.green(0, 0)).isEqualTo(0);
    }

    @Property
    void equalSamples_haveMeanOfSameValue(@ForAll @FloatRange(min = 0, max = 1e30f) float value,
            @ForAll @IntRange(min = 2, max = 8) int grid) {
        float[] samples = new float[grid * grid];
        java.util.Arrays.fill(samples, value);
        assertThat(SampleMean.mean(samples, 0, samples.length)).isCloseTo(value, within(value * 14 * 0x1p-24f));
    }

    @Property
    void mean_usesSummationTreeOfEquation(@ForAll @IntRange(min = 1, max = 64) int count, @ForAll @IntRange(max = 3) int from,
            @ForAll long seed) {
        Random random = new Random(seed);
        float[] samples = new float[from + count];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = random.nextFloat();
        }
        assertThat(SampleMean.mean(samples, from, count)).isEqualTo(LightingEquation.sum(samples, from, from + count) / count);
    }
}

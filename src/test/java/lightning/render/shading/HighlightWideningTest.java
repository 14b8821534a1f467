package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

/** Tests highlights of area lights on metallic materials, which are widened by the light of a sample. */
class HighlightWideningTest {
    private static final Vec3 VIEW = new Vec3(0, 0, -1);
    private static final double SIZE = 1.6;
    private static final double DISTANCE = 4.5;

    private static LightSource source(Light light) {
        Camera atOrigin = new Camera(Vec3.ZERO, VIEW, Vec3.Y, 40);
        return LightSource.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }

    private static Light sun(double spread, int samples) {
        return Light.of("l", LightType.DIRECTIONAL).withDirection(new Vec3(0, 0, -1))
                .withArea(new AreaShape(0, spread, 1, 1, Vec3.Y, samples));
    }

    /** Returns a square light of 16 samples that shines along −z onto a ball of radius 1 around the origin. */
    private static LightSource softbox() {
        return source(Light.of("l", LightType.RECT).withPosition(new Vec3(0, 0, DISTANCE)).withDirection(new Vec3(0, 0, -1))
                .withArea(new AreaShape(0, 0, SIZE, SIZE, Vec3.Y, 16)));
    }

    private static double alpha(double roughness) {
        return Material.of("m").withModel(ShadingModel.METALLIC).withRoughness(roughness).alpha();
    }

    /** Returns N·L·D·V at a point of the ball, seen along −z. */
    private static double term(LightSource source, Vec3 n, double alpha) {
        var equation = new LightingEquation(source);
        float nx = (float) n.x();
        float ny = (float) n.y();
        float nz = (float) n.z();
        equation.moveTo(nx, ny, nz, nx, ny, nz);
        return (double) equation.metallicSpecular(nx, ny, nz, 0, 0, -1, alpha) + equation.metallicGrazing(nx, ny, nz, 0, 0, -1, alpha);
    }

    @Example
    void lightWithoutSize_widensNothing() {
        assertThat(source(Light.of("l", LightType.POINT)).highlightWidening()).isZero();
        assertThat(source(Light.of("l", LightType.DIRECTIONAL)).highlightWidening()).isZero();
        assertThat(source(Light.of("l", LightType.RECT).withArea(AreaShape.DEFAULT.withHardShadows(true))).highlightWidening()).isZero();
    }

    /** Looks from the light, so that H = L = −V and N·L·D·V = c·D/(c + √(a + (1 − a)·c²))² for a surface tilted by c. */
    @Property
    void widenedLobe_isNormalized(@ForAll @DoubleRange(min = 0, max = 1) double roughness,
            @ForAll @DoubleRange(min = 0.1, max = 90) double spread) {
        LightSource source = source(sun(spread, 16));
        double alpha = alpha(roughness);
        double a = Math.min(1, alpha * alpha + 2 * Math.PI * (1 - Math.cos(Math.toRadians(spread))) / 16 / 8);
        double integral = 0;
        int steps = 2000;
        for (int i = 0; i < steps; i++) {
            // Tilts at which a lobe of this width has equal parts of its integral.
            double u = (i + 0.5) / steps;
            double c = Math.sqrt((1 - u) / (1 + (a - 1) * u));
            var equation = new LightingEquation(source);
            float nx = (float) Math.sqrt(1 - c * c);
            float nz = (float) c;
            equation.moveTo(0, 0, 0, nx, 0, nz);
            double gl = c + Math.sqrt(a + (1 - a) * c * c);
            double d = equation.metallicSpecular(nx, 0, nz, 0, 0, -1, alpha) * gl * gl / c;
            double equalParts = a / Math.pow(c * c * (a - 1) + 1, 2);
            integral += d / equalParts / steps;
        }
        assertThat(integral).isCloseTo(1, within(1e-3));
    }

    /** A sky of uniform light: the mean of f·cos over its hemisphere, times 2π; the terms contain π. */
    @Property(tries = 30)
    void whiteMetalUnderUniformSky_reflectsNoMoreThanItReceives(@ForAll @DoubleRange(min = 0, max = 1) double roughness,
            @ForAll @DoubleRange(min = 0, max = 80) double angle) {
        LightSource source = source(sun(90, 64));
        AreaSamples samples = source.centerSamples();
        float vx = (float) Math.sin(Math.toRadians(angle));
        float vz = (float) -Math.cos(Math.toRadians(angle));
        double sum = 0;
        for (int rotation = 0; rotation < AreaSamples.ROTATIONS; rotation++) {
            for (int s = 0; s < samples.samples(); s++) {
                var equation = new LightingEquation(source.at(samples, rotation, s));
                equation.moveTo(0, 0, 0, 0, 0, 1);
                double alpha = alpha(roughness);
                sum += equation.cosine(0, 0, 1) <= 0 ? 0
                        : (double) equation.metallicSpecular(0, 0, 1, vx, 0, vz, alpha)
                                + equation.metallicGrazing(0, 0, 1, vx, 0, vz, alpha);
            }
        }
        assertThat(2 * sum / AreaSamples.ROTATIONS / samples.samples()).isPositive().isLessThan(1.01);
    }

    /** Means over the samples in all rotations, which neighboring pixels use: their mean and their standard deviation. */
    private record Pixels(double mean, double deviation) {
        static Pixels at(Vec3 n, LightSource source, boolean widened, double alpha) {
            AreaSamples samples = source.centerSamples();
            double[] pixel = new double[AreaSamples.ROTATIONS];
            Vec3 down = new Vec3(0, 0, -1);
            for (int rotation = 0; rotation < pixel.length; rotation++) {
                for (int s = 0; s < samples.samples(); s++) {
                    LightSource sample = source.at(samples, rotation, s);
                    LightSource used = widened ? sample : source(Light.of("p", LightType.POINT).withPosition(sample.position()));
                    Vec3 away = n.minus(sample.position());
                    double squared = away.dot(away);
                    double falloff = away.dot(down) / Math.sqrt(squared) / squared;
                    pixel[rotation] += away.dot(n) < 0 ? term(used, n, alpha) * falloff / samples.samples() : 0;
                }
            }
            double mean = Arrays.stream(pixel).average().orElseThrow();
            return new Pixels(mean, Math.sqrt(Arrays.stream(pixel).map(v -> (v - mean) * (v - mean)).average().orElseThrow()));
        }
    }

    private static Vec3 onBall(double x, double y) {
        return new Vec3(x, y, Math.sqrt(1 - x * x - y * y));
    }

    /** Sums over a grid of pixels of the ball: the means, and the root of the sum of variances. */
    private static double[] ball(double roughness, boolean widened) {
        LightSource source = softbox();
        double sum = 0;
        double variance = 0;
        int grid = 40;
        for (int i = 0; i < grid * grid; i++) {
            double x = (i % grid + 0.5) / grid - 0.5;
            double y = (i / grid + 0.5) / grid - 0.5;
            Pixels pixels = Pixels.at(onBall(x, y), source, widened, alpha(roughness));
            sum += pixels.mean / (grid * grid);
            variance += pixels.deviation * pixels.deviation / (grid * grid);
        }
        return new double[] {sum, Math.sqrt(variance)};
    }

    @Example
    void smoothBall_hasNoFireflies() {
        double[] narrow = ball(0, false);
        double[] widened = ball(0, true);
        assertThat(widened[1]).isLessThan(narrow[1] / 10);
    }

    /**
     * The ball mirrors the square with its radiance. The reflection covers the pixels whose reflected ray hits the square; the terms of the light
     * have a factor π/A.
     */
    @Example
    void smoothBall_mirrorsAllOfTheLight() {
        int grid = 400;
        double covered = 0;
        for (int i = 0; i < grid * grid; i++) {
            Vec3 n = onBall((i % grid + 0.5) / grid - 0.5, (i / grid + 0.5) / grid - 0.5);
            Vec3 r = n.times(2 * n.z()).minus(new Vec3(0, 0, 1));
            Vec3 hit = n.plus(r.times((DISTANCE - n.z()) / r.z()));
            covered += r.z() > 0 && Math.abs(hit.x()) < SIZE / 2 && Math.abs(hit.y()) < SIZE / 2 ? 1.0 / (grid * grid) : 0;
        }
        assertThat(ball(0, true)[0] * SIZE * SIZE / Math.PI).isCloseTo(covered, within(0.08 * covered));
    }

    @Example
    void roughBall_changesByLessThanOnePercent() {
        for (double roughness : new double[] {0.7, 0.85, 1}) {
            double before = ball(roughness, false)[0];
            assertThat(ball(roughness, true)[0]).isCloseTo(before, within(0.01 * before));
        }
    }

    @Example
    void narrowStrip_isWidenedByTheSpacingAlongItsLength() {
        Light strip = Light.of("l", LightType.RECT).withArea(new AreaShape(0, 0, 0, 2, Vec3.Y, 16));
        assertThat(source(strip).highlightWidening()).isEqualTo(2.0 * 2 / (16 * 16) / 8);
    }
}

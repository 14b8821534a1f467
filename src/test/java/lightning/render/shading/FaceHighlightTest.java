package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;

/** Tests highlights of area lights with the shape of their faces, against integrals over the lobe. The surface is at the origin, its normal is z. */
class FaceHighlightTest {
    private static final int SAMPLES = 16;
    /** Facets along each side of the grid of an integral. */
    private static final int FACETS = 200;

    private static LightSource source(Light light) {
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return LightSource.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }

    private static Light light(LightType type, Vec3 at, Vec3 direction, double size) {
        return Light.of("l", type).withPosition(at).withDirection(direction)
                .withArea(new AreaShape(size / 2, Math.toDegrees(Math.atan(size / 2)), size, 0.7 * size, Vec3.Y, SAMPLES));
    }

    private static Vec3 view(double degrees) {
        return new Vec3(Math.sin(Math.toRadians(degrees)), 0, -Math.cos(Math.toRadians(degrees)));
    }

    private static float factor(LightSource source, int pattern, Vec3 view, double alpha) {
        FaceHighlight face = new FaceHighlight();
        face.aim(source);
        return face.factor(source.centerSamples(), pattern, 0, 0, 0, 0, 0, 0, 1, (float) view.x(), (float) view.y(), (float) view.z(),
                alpha);
    }

    /** Returns the highlight of one pixel: the mean over the samples, scaled. */
    private static double highlight(LightSource source, int pattern, Vec3 view, double alpha) {
        float factor = factor(source, pattern, view, alpha);
        float vx = (float) view.x();
        float vy = (float) view.y();
        float vz = (float) view.z();
        double sum = 0;
        for (int s = 0; s < SAMPLES; s++) {
            var equation = new LightingEquation(source.at(source.centerSamples(), pattern, s));
            equation.moveTo(0, 0, 0, 0, 0, 1);
            if (equation.cosine(0, 0, 1) > 0 && equation.insideCone()) {
                float falloff = equation.falloff();
                sum += falloff * FaceHighlight.scaled(equation.metallicSpecular(0, 0, 1, vx, vy, vz, alpha), factor, alpha);
                sum += falloff * FaceHighlight.scaled(equation.metallicGrazing(0, 0, 1, vx, vy, vz, alpha), factor, alpha);
            }
        }
        return sum / SAMPLES;
    }

    /** Density of the points of a face as they are seen in a direction, per steradian, times the falloff there; 0 beside the face. */
    private interface Face {
        double at(Vec3 toward);
    }

    private static Face face(LightSource source) {
        AreaShape shape = source.light().area();
        return switch (source.type()) {
            case RECT, DISC -> toward -> {
                double along = toward.dot(source.axis());
                double distance = source.position().dot(source.axis()) / along;
                Vec3 from = toward.times(distance).minus(source.position());
                Vec3 right = shape.right(source.axis());
                double x = from.dot(right);
                double y = from.dot(right.cross(source.axis()));
                boolean isOn = source.type() == LightType.RECT
                        ? Math.abs(x) <= shape.width() / 2 && Math.abs(y) <= shape.height() / 2
                        : x * x + y * y <= shape.radius() * shape.radius();
                double area = source.type() == LightType.RECT ? shape.width() * shape.height() : Math.PI * shape.radius() * shape.radius();
                if (along >= 0 || distance <= 0 || !isOn) {
                    return 0;
                }
                var equation = new LightingEquation(new LightSource(source.light(), source.origin(), source.position().plus(from),
                        source.axis(), source.cosAngle(), source.dropoff(), source.fog(), null, null, source.highlightWidening(), null));
                equation.moveTo(0, 0, 0, 0, 0, 1);
                return distance * distance / (area * -along) * equation.falloff();
            };
            case DIRECTIONAL -> cap(source.position(), Math.cos(Math.toRadians(shape.spread())));
            case TUBE, OBJECT -> throw new AssertionError("has no known face");
            case POINT, SPOT -> {
                double sin = shape.radius() / source.position().length();
                yield cap(source.position().normalized(), Math.sqrt(1 - sin * sin));
            }
        };
    }

    private static Face cap(Vec3 center, double cos) {
        return toward -> toward.dot(center) < cos ? 0 : 1 / (2 * Math.PI * (1 - cos));
    }

    /** Integrates N·L·D·V over a face, by facets that are distributed as D·N·H. */
    private static double integral(LightSource source, Vec3 view, double alpha) {
        Face face = face(source);
        double a = alpha * alpha;
        double sum = 0;
        for (int i = 0; i < FACETS * FACETS; i++) {
            double u = (i % FACETS + 0.5) / FACETS;
            double turn = 2 * Math.PI * (i / FACETS + 0.5) / FACETS;
            double cos = Math.sqrt((1 - u) / (1 + (a - 1) * u));
            double sin = Math.sqrt(1 - cos * cos);
            var h = new Vec3(sin * Math.cos(turn), sin * Math.sin(turn), cos);
            double vh = -view.dot(h);
            Vec3 toward = h.times(2 * vh).plus(view);
            if (vh > 0 && toward.z() > 0) {
                double nl = toward.z();
                double nv = -view.z();
                double smith = (nl + Math.sqrt(a + (1 - a) * nl * nl)) * (nv + Math.sqrt(a + (1 - a) * nv * nv));
                sum += Math.PI * nl / smith * 4 * vh / cos * face.at(toward);
            }
        }
        return sum / (FACETS * FACETS);
    }

    private static Light mirrored(LightType type, double degrees, double size) {
        Vec3 toward = view(180 - degrees);
        return light(type, toward.times(2), toward.negated(), size);
    }

    /** Returns the types whose faces are known. */
    @Provide
    Arbitrary<LightType> withFaces() {
        return Arbitraries.of(LightType.DIRECTIONAL, LightType.POINT, LightType.SPOT, LightType.RECT, LightType.DISC);
    }

    /**
     * In the middle of the reflection of a light much wider than the lobe, the mean over the patterns of neighboring pixels is what the lobe sees of it,
     * with little grain.
     */
    @Property(tries = 100)
    void lightWiderThanLobe_isSeenAsInMirror(@ForAll("withFaces") LightType type, @ForAll @DoubleRange(min = 0, max = 45) double degrees,
            @ForAll @DoubleRange(min = 0.0021, max = 0.02) @Scale(4) double alpha) {
        LightSource source = source(mirrored(type, degrees, 1));
        double expected = integral(source, view(degrees), alpha);
        double[] pixels = IntStream.range(0, AreaSamples.ROTATIONS)
                .mapToDouble(pattern -> highlight(source, pattern, view(degrees), alpha) / expected).toArray();
        double mean = Arrays.stream(pixels).average().orElseThrow();
        double deviation = Math.sqrt(Arrays.stream(pixels).map(v -> (v - mean) * (v - mean)).average().orElseThrow());
        assertThat(mean).isCloseTo(1, within(0.02));
        assertThat(deviation).isLessThan(0.02);
    }

    /** Beside the reflection, narrow lobes see nothing of it, although widened lobes of samples do. */
    @Property(tries = 30)
    void besideFace_narrowLobeIsDark(@ForAll @DoubleRange(min = 0.0021, max = 0.005) @Scale(4) double alpha) {
        Vec3 beside = view(180 - 30 - 1.3 * Math.toDegrees(Math.atan(0.25)));
        LightSource source = source(light(LightType.RECT, beside.times(2), beside.negated(), 1));
        double inside = integral(source(mirrored(LightType.RECT, 30, 1)), view(30), alpha);
        for (int pattern = 0; pattern < AreaSamples.ROTATIONS; pattern++) {
            assertThat(highlight(source, pattern, view(30), alpha)).isLessThan(0.01 * inside);
        }
    }

    /** Means over random lights of one width of lobe; single pixels of wide lobes have the noise of their samples. */
    @Example
    void randomLights_meanDifferenceFromIntegralIsSmall() {
        Random random = new Random(7);
        for (LightType type : List.of(LightType.RECT, LightType.DISC, LightType.POINT)) {
            for (double alpha : new double[] {0.005, 0.02, 0.1, 0.2}) {
                double difference = 0;
                double sum = 0;
                for (int k = 0; k < 60; k++) {
                    double size = Math.exp(random.nextDouble(Math.log(0.1), Math.log(3)));
                    Vec3 view = view(random.nextDouble(70));
                    double spread = 0.3 * Math.max(alpha, size / 2);
                    Vec3 toward =
                            new Vec3(view.x() + random.nextGaussian() * spread, random.nextGaussian() * spread, -view.z()).normalized();
                    Vec3 tilt = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(0.3);
                    LightSource source = source(light(type, toward.times(2), toward.negated().plus(tilt).normalized(), size));
                    double expected = integral(source, view, alpha);
                    difference += Math.abs(highlight(source, random.nextInt(AreaSamples.ROTATIONS), view, alpha) - expected);
                    sum += expected;
                }
                assertThat(difference / sum).as("%s, α = %s", type, alpha).isLessThan(0.025);
            }
        }
    }

    @Property(tries = 50)
    void wideLobe_isLeftAsItIs(@ForAll("withFaces") LightType type, @ForAll @DoubleRange(min = 0.4, max = 1) double alpha) {
        assertThat(factor(source(mirrored(type, 30, 1)), 0, view(30), alpha)).isEqualTo(1);
    }

    @Example
    void pointInsideBall_isLeftAsItIs() {
        assertThat(factor(source(light(LightType.POINT, new Vec3(0, 0, 0.4), new Vec3(0, 0, -1), 1)), 0, view(30), 0.01)).isEqualTo(1);
    }

    @Example
    void lineOfLight_hasNoFace() {
        Light line = Light.of("l", LightType.RECT).withArea(AreaShape.DEFAULT.withWidth(0));
        assertThat(FaceHighlight.hasFace(source(line))).isFalse();
        assertThat(FaceHighlight.hasFace(source(line.withArea(line.area().withWidth(1))))).isTrue();
        assertThat(FaceHighlight.hasFace(source(Light.of("l", LightType.POINT)))).isFalse();
    }

    /** Faces that the horizon cuts, seen at grazing angles, included. */
    @Property(tries = 2000)
    void factor_isFiniteAndNotNegative(@ForAll("withFaces") LightType type, @ForAll @DoubleRange(min = 0, max = 90) double degrees,
            @ForAll @DoubleRange(min = -1, max = 1) double x, @ForAll @DoubleRange(min = -0.3, max = 1) double z,
            @ForAll @DoubleRange(min = -3, max = 3) double logSize, @ForAll @DoubleRange(min = 0.0021, max = 1) @Scale(4) double alpha) {
        Vec3 at = new Vec3(x, 0.1, z);
        assertThat(factor(source(light(type, at, at.negated(), Math.pow(10, logSize))), 3, view(degrees), alpha)).isFinite()
                .isNotNegative();
    }

    @Property
    void scaledTerm_isAtMostLargestTerm(@ForAll @DoubleRange(min = 0, max = 1e38) double factor,
            @ForAll @DoubleRange(min = 0.0021, max = 1) @Scale(4) double alpha) {
        assertThat((double) FaceHighlight.scaled(1e3f, (float) factor, alpha))
                .isLessThanOrEqualTo(1 / (2 * alpha * alpha * alpha) * (1 + 1e-6));
    }
}

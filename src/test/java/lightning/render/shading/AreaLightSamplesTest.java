package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests area lights against formulas, and their samples against many more samples. */
class AreaLightSamplesTest {
    private static final Shape FLOOR = new Shape(Solid.PLANE, "floor", "white", placement(Vec3.ZERO, new Vec3(50, 1, 50)));

    private static Placement placement(Vec3 at, Vec3 scale) {
        return new Placement(at, Vec3.ZERO, scale);
    }

    /** White floor seen from straight above, by a camera under the light. */
    private static Scene floor(int size, List<SceneNode> nodes, Light light) {
        Material white = Material.of("white").withAmbient(Rgb.BLACK).withDiffuse(Rgb.WHITE);
        return new Scene(new PictureSettings(size, size, 0), new Camera(new Vec3(0, 0.5, 0), Vec3.ZERO, new Vec3(0, 0, 1), 90),
                new World(0, Rgb.BLACK), List.of(white), nodes, List.of(light));
    }

    private static Light lightAbove(LightType type, UnaryOperator<AreaShape> area) {
        return Light.of("l", type).withPosition(new Vec3(0, 2, 0)).withDirection(new Vec3(0, -1, 0))
                .withAttenuation(new Attenuation(0, 0, 1)).withArea(area.apply(AreaShape.DEFAULT.withSamples(64)));
    }

    /**
     * The form factor of a rectangle centered above a point is four times that of a rectangle above a corner (Howell, B-3); divided
     * by the area, times π.
     */
    @Test
    void rectLight_litFloorMatchesFormFactor() {
        double x = 0.75;
        double y = 0.5;
        double corner = (x / Math.hypot(1, x) * Math.atan(y / Math.hypot(1, x)) + y / Math.hypot(1, y) * Math.atan(x / Math.hypot(1, y)))
                / (2 * Math.PI);
        double expected = 4 * corner * Math.PI / (4 * 4 * x * y);
        Scene scene = floor(9, List.of(FLOOR), lightAbove(LightType.RECT, a -> a.withWidth(4 * x).withHeight(4 * y)));
        assertThat(new ReferenceTracer(scene).pixel(4, 4)[0]).isCloseTo((float) expected, within(0.005f * (float) expected));
    }

    /** A disc of radius r at height h lights the point under its center by π·r²/(r² + h²) over its area (Howell, B-12). */
    @Test
    void discLight_litFloorMatchesFormFactor() {
        float expected = 1f / (1 + 4);
        Scene scene = floor(9, List.of(FLOOR), lightAbove(LightType.DISC, a -> a.withRadius(1)));
        assertThat(new ReferenceTracer(scene).pixel(4, 4)[0]).isCloseTo(expected, within(0.005f * expected));
    }

    @Test
    void rectLightOnCeiling_isNotShadowedByCeiling() {
        Shape ceiling = new Shape(Solid.PLANE, "ceiling", "white", placement(new Vec3(0, 2, 0), new Vec3(9, 1, 9)));
        Light light = lightAbove(LightType.RECT, a -> a.withWidth(1.7).withHeight(0.9));
        float free = new ReferenceTracer(floor(9, List.of(FLOOR), light)).pixel(2, 3)[0];
        assertThat(new ReferenceTracer(floor(9, List.of(FLOOR, ceiling), light)).pixel(2, 3)[0]).isEqualTo(free).isPositive();
    }

    /** If a floor cuts a light in two, the upper half lights it. */
    @Test
    void sphereLightCutByFloor_lightsWithUpperHalf() {
        Light whole = lightAbove(LightType.POINT, a -> a.withRadius(0.4)).withPosition(new Vec3(0.3, 0.4, 0));
        Light half = whole.withPosition(new Vec3(0.3, 0, 0));
        double above = new ReferenceTracer(floor(9, List.of(FLOOR), whole)).pixel(1, 4)[0];
        double cut = new ReferenceTracer(floor(9, List.of(FLOOR), half)).pixel(1, 4)[0];
        assertThat(cut).isPositive().isLessThan(above);
        int facing = 0;
        LightSource source = LightSource.of(half, floor(9, List.of(FLOOR), half));
        for (int s = 0; s < source.centerSamples().samples(); s++) {
            facing += source.centerSamples().position(3, s).y() > -0.5 ? 1 : 0;
        }
        assertThat(facing).isBetween(30, 34);
    }

    /** A point above the edge of a wide blocker sees half of the unblocked light. */
    @ParameterizedTest
    @EnumSource(value = LightType.class, names = {"SPOT", "OBJECT"}, mode = EnumSource.Mode.EXCLUDE)
    void halfOccludedLight_isHalfAsBright(LightType type) {
        Shape shade = new Shape(Solid.PLANE, "shade", "white", placement(new Vec3(5, 1, 0), new Vec3(10, 1, 10)));
        Light light = lightAbove(type, a -> a.withRadius(0.5).withSpread(10));
        double free = new ReferenceTracer(floor(9, List.of(FLOOR), light)).pixel(4, 4)[0];
        double half = new ReferenceTracer(floor(9, List.of(FLOOR, shade), light)).pixel(4, 4)[0];
        assertThat(half / free).isCloseTo(0.5, within(1.0 / 16));
    }

    /** All rotations of 64 samples give 1024 positions. The error of n of them decreases faster than 1/√n, that of n random samples. */
    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void fewSamples_approximateThousandSamples(LightType type) {
        double four = error(type, 4);
        double sixteen = error(type, 16);
        double all = error(type, 64);
        assertThat(sixteen).isLessThan(four / 2);
        assertThat(all).isLessThan(sixteen / 2);
    }

    /** Rows in a penumbra use more samples, so that neighbors with other rotations do not look different. */
    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void penumbraAtDefault_isWithinTwoPercentOfFullLight(LightType type) {
        assertThat(error(type, AreaShape.DEFAULT.samples(), true)).isLessThan(0.02).isLessThan(error(type, 16) / 2);
    }

    /**
     * A wide blocker halfway to a rectangle of width 1 hides a share of it from the floor that falls linearly along x. The mean over points that
     * see more than half of the light must not be brighter than that, and the others not darker: few samples may be off, but to both sides.
     */
    @ParameterizedTest
    @EnumSource(names = {"OFF", "EVERY"})
    void penumbra_hasTheMeanOfItsFormula(AntialiasMode antialias) {
        Shape shade = new Shape(Solid.PLANE, "shade", "white", placement(new Vec3(5, 5, 0), new Vec3(10, 1, 10)));
        Light light = lightAbove(LightType.RECT, a -> a.withWidth(1).withHeight(1).withSamples(16)).withPosition(new Vec3(0, 10, 0));
        float[] freeColors = colors(floor(40, List.of(FLOOR), light), antialias);
        float[] halfColors = colors(floor(40, List.of(FLOOR, shade), light), antialias);
        double[] difference = new double[2];
        int[] pixels = new int[2];
        for (int i = 0; i < 40 * 40; i++) {
            // The picture shows the floor from −0.5 to 0.5; its right side is at −x.
            double x = 0.5 - (i % 40 + 0.5) / 40;
            double visible = 0.5 - x;
            int side = visible > 0.5 ? 1 : 0;
            difference[side] += halfColors[3 * i] / freeColors[3 * i] - visible;
            pixels[side]++;
        }
        assertThat(difference[0] / pixels[0]).isCloseTo(0, within(0.01));
        assertThat(difference[1] / pixels[1]).isCloseTo(0, within(0.01));
    }

    private static float[] colors(Scene scene, AntialiasMode antialias) {
        return new ReferenceTracer(scene.withPicture(scene.picture().withSampling(new SamplingSettings(antialias, 4)))).trace()
                .toScanlines();
    }

    static double error(LightType type, int samples) {
        return error(type, samples, false);
    }

    /**
     * Returns the root mean square error of visibility against 1024 samples, over points in a sphere's penumbra, relative to full
     * light.
     *
     * @param refines whether points that see some samples use more of them
     */
    private static double error(LightType type, int samples, boolean refines) {
        Light light = lightAbove(type, a -> a.withRadius(0.6).withSpread(12)).withAngle(80);
        Scene scene = floor(9, List.of(FLOOR), light);
        AreaSamples few = LightSource.of(light.withArea(light.area().withSamples(samples)), scene).centerSamples();
        AreaSamples many = LightSource.of(light, scene).centerSamples();
        double squares = 0;
        int points = 0;
        for (int i = 0; i < 400; i++) {
            double x = i % 20 * 0.06 - 0.6;
            double z = i / 20 * 0.06 - 0.6;
            Vec3 point = new Vec3(x, -0.5, z);
            double truth = 0;
            for (int t = 0; t < AreaSamples.ROTATIONS; t++) {
                truth += visible(many, t, point, type, many.samples()) / AreaSamples.ROTATIONS;
            }
            if (truth > 0 && truth < 1) {
                double seen = visible(few, i % AreaSamples.ROTATIONS, point, type, few.samples());
                double off = (refines && seen > 0 && seen < 1
                        ? visible(few, i % AreaSamples.ROTATIONS, point, type, few.refinedSamples()) : seen) - truth;
                squares += off * off;
                points++;
            }
        }
        return Math.sqrt(squares / points);
    }

    /** Returns the share of the first samples visible from a point past a sphere of radius 0.4 between it and the light. */
    private static double visible(AreaSamples area, int rotation, Vec3 point, LightType type, int samples) {
        int visibleCount = 0;
        for (int s = 0; s < samples; s++) {
            Vec3 to = area.position(rotation, s);
            Vec3 toTarget = (type.hasPosition() ? to.minus(point) : to).normalized();
            Vec3 center = new Vec3(0.1, 0.3, 0.05).minus(point);
            double along = center.dot(toTarget);
            visibleCount += along > 0 && center.minus(toTarget.times(along)).length() < 0.4 ? 0 : 1;
        }
        return (double) visibleCount / samples;
    }

    /** A screen at z = −3 that shines along z. A viewer in front of it sees the image upright, its left at −x. */
    @ParameterizedTest
    @EnumSource(names = {"RECT", "DISC"})
    void texture_isUprightForViewerOfTheFace(LightType type) {
        Texture corners = new Texture(2, 2, new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
        Light screen = lightAbove(type, a -> a.withWidth(2).withHeight(2).withRadius(1)).withPosition(new Vec3(0, 0, -3))
                .withDirection(new Vec3(0, 0, 1)).withTexture(Optional.of(new LightTexture("corners.png", corners)));
        AreaSamples samples = LightSource.of(screen, floor(9, List.of(FLOOR), screen)).centerSamples();
        Vec3 center = screen.position().minus(floor(9, List.of(FLOOR), screen).camera().origin());
        double[] sum = new double[3];
        for (int i = 0; i < samples.x.length; i++) {
            double x = samples.x[i] - center.x();
            double y = samples.y[i] - center.y();
            if (Math.abs(x) > 0.25 && Math.abs(y) > 0.25) {
                assertThat(samples.color[0][i]).isEqualTo(x < 0 && y > 0 ? 1 : 0, within(1e-5f));
                assertThat(samples.color[1][i]).isEqualTo(x > 0 && y > 0 ? 1 : 0, within(1e-5f));
                assertThat(samples.color[2][i]).isEqualTo(x < 0 && y < 0 ? 1 : 0, within(1e-5f));
            }
            for (int c = 0; c < 3; c++) {
                sum[c] += samples.color[c][i];
            }
        }
        for (int c = 0; c < 3; c++) {
            assertThat(sum[c] / samples.x.length).as("mirrored patches keep the mean").isCloseTo(0.25, within(0.005));
        }
    }

    /** A floor below the middle of a light with one red half gets half of the light. */
    @Test
    void halfRedTexture_givesHalfOfTheRed() {
        UnaryOperator<AreaShape> area = a -> a.withWidth(1).withHeight(1);
        Light plain = lightAbove(LightType.RECT, area);
        Light halves = plain.withTexture(Optional.of(new LightTexture("halves.png", new Texture(2, 1, new float[] {1, 0, 0, 0, 0, 0}))));
        float[] full = new ReferenceTracer(floor(9, List.of(FLOOR), plain)).pixel(4, 4);
        float[] half = new ReferenceTracer(floor(9, List.of(FLOOR), halves)).pixel(4, 4);
        assertThat(half[0]).isCloseTo(full[0] / 2, within(0.02f * full[0]));
        assertThat(half[1]).isZero();
    }
}

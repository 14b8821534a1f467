package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests lookups in an environment map, and its median cut into lights. */
class EnvironmentMapTest {
    private static EnvironmentMap sky(int width, int height, long seed) {
        var random = new Random(seed);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextInt(4) == 0 ? 0 : (float) Math.exp(random.nextGaussian() * 3);
        }
        return new EnvironmentMap(width, height, rgb);
    }

    private static double[] radiance(EnvironmentMap sky, double x, double y, double z, double turn) {
        double[] to = new double[3];
        sky.radiance(x, y, z, DomeRotation.of(turn, 0, 0), to);
        return to;
    }

    /** Four adjacent pixels: +z to −x, −x to −z, −z to x, x to +z. */
    private static final EnvironmentMap FOUR = new EnvironmentMap(4, 1, new float[] {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});

    @Test
    void center_isMinusZ_rightHalfIsX() {
        assertThat(radiance(FOUR, 0, 0, -1, 0)[0]).isEqualTo(2.5, within(1e-12));
        assertThat(radiance(FOUR, 1, 0, 0, 0)[0]).isEqualTo(3.5, within(1e-12));
        assertThat(radiance(FOUR, 0, 0, 1, 0)[0]).as("around the sides").isEqualTo(2.5, within(1e-12));
        assertThat(radiance(FOUR, -1, 0, 0, 0)[0]).isEqualTo(1.5, within(1e-12));
    }

    @Test
    void top_isUp() {
        EnvironmentMap two = new EnvironmentMap(1, 2, new float[] {5, 0, 0, 1, 0, 0});
        assertThat(radiance(two, 0, 1, 0, 0)[0]).isEqualTo(5);
        assertThat(radiance(two, 0, -1, 0, 0)[0]).isEqualTo(1);
        assertThat(radiance(two, 0.6, 0, -0.8, 0)[0]).isEqualTo(3, within(1e-12));
    }

    /** A shape at −z rotated by 90 degrees about y is at −x. */
    @Test
    void rotation_matchesShapeRotation() {
        assertThat(radiance(FOUR, -1, 0, 0, 90)[0]).isEqualTo(2.5, within(1e-12));
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("x.hdr", FOUR))).withOwn(own -> own.withLightCount(4));
        List<Light> lights = world.environments().getFirst().approximateLights(4, _ -> false);
        List<Light> turned = world.withOwn(own -> own.withRotation(DomeRotation.of(90, 0, 0))).environments().getFirst()
                .approximateLights(4, _ -> false);
        for (int i = 0; i < 4; i++) {
            Vec3 d = lights.get(i).direction();
            assertThat(turned.get(i).direction().minus(new Vec3(d.z(), d.y(), -d.x())).length()).isLessThan(1e-12);
        }
    }

    @Property
    void tiltedMap_hasTheRadianceOfItsOwnDirection(@ForAll @DoubleRange(min = -180, max = 180) double rotation,
            @ForAll @DoubleRange(min = -180, max = 180) double tilt, @ForAll @DoubleRange(min = -180, max = 180) double roll,
            @ForAll @DoubleRange(min = 0.1, max = 3) double polar, @ForAll @DoubleRange(min = -3, max = 3) double azimuth) {
        EnvironmentMap sky = sky(8, 4, 1);
        Vec3 own = new Vec3(Math.sin(polar) * Math.cos(azimuth), Math.cos(polar), Math.sin(polar) * Math.sin(azimuth));
        DomeRotation dome = DomeRotation.of(rotation, tilt, roll);
        Vec3 inScene = dome.toWorld().transformVector(own);
        double[] expected = new double[3];
        sky.radiance(own.x(), own.y(), own.z(), DomeRotation.NONE, expected);
        double[] found = new double[3];
        sky.radiance(inScene.x(), inScene.y(), inScene.z(), dome, found);
        assertThat(found).containsExactly(expected, within(1e-9));
    }

    @Property
    void lightsOfTiltedMap_areRotated(@ForAll @DoubleRange(min = -180, max = 180) double tilt,
            @ForAll @DoubleRange(min = -180, max = 180) double roll) {
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("x.hdr", FOUR))).withOwn(own -> own.withLightCount(4));
        DomeRotation dome = DomeRotation.of(20, tilt, roll);
        List<Light> lights = world.environments().getFirst().approximateLights(4, _ -> false);
        List<Light> turned = world.withOwn(own -> own.withRotation(dome)).environments().getFirst().approximateLights(4, _ -> false);
        for (int i = 0; i < 4; i++) {
            Vec3 expected = dome.toWorld().transformVector(lights.get(i).direction());
            assertThat(turned.get(i).direction().minus(expected).length()).isLessThan(1e-12);
        }
    }

    /** The lights have the total energy of the map, its integral over π, for any number of lights. */
    @Property
    void lights_preserveTotalEnergy(@ForAll @IntRange(min = 1, max = 600) int width, @ForAll @IntRange(min = 1, max = 40) int height,
            @ForAll @IntRange(min = 4, max = 64) int maxLights, @ForAll long seed) {
        EnvironmentMap sky = sky(width, height, seed);
        double[] lights = new double[3];
        double sphere = 0;
        for (int y = 0; y < height; y++) {
            sphere += width * sky.solidAngle(y);
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    lights[c] += sky.channel(x, y, c) * sky.solidAngle(y) / Math.PI;
                }
            }
        }
        assertThat(sphere).isEqualTo(4 * Math.PI, within(1e-12 * 4 * Math.PI));
        List<EnvironmentLight> environmentLights = sky.lights(maxLights);
        assertThat(environmentLights).hasSizeBetween(1, maxLights);
        // Sums of at most 600 · 80 nonnegative terms, each with one rounding: an error of 48,000 · 2⁻⁵³ of the sum, on both sides. The
        // angles of the parts of a pixel add up to its own with as many roundings.
        double bound = 4 * 48_010 * 0x1p-53;
        assertThat(environmentLights.stream().mapToDouble(EnvironmentLight::red).sum()).isEqualTo(lights[0], within(bound * lights[0]));
        assertThat(environmentLights.stream().mapToDouble(EnvironmentLight::green).sum()).isEqualTo(lights[1], within(bound * lights[1]));
        assertThat(environmentLights.stream().mapToDouble(EnvironmentLight::blue).sum()).isEqualTo(lights[2], within(bound * lights[2]));
        environmentLights.forEach(light -> assertThat(light.direction().length()).isEqualTo(1, within(1e-12)));
    }

    @Test
    void smallSun_getsOneLight() {
        float[] rgb = new float[3 * 64 * 32];
        java.util.Arrays.fill(rgb, 0.01f);
        rgb[3 * (8 * 64 + 40)] = 1e5f;
        List<EnvironmentLight> environmentLights = new EnvironmentMap(64, 32, rgb).lights(16);
        EnvironmentLight sun = environmentLights.stream().max(java.util.Comparator.comparingDouble(EnvironmentLight::red)).orElseThrow();
        double polar = Math.PI * 8.5 / 32;
        double around = 2 * Math.PI * (40.5 / 64 - 0.5);
        Vec3 sunLights = new Vec3(Math.sin(polar) * Math.sin(around), Math.cos(polar), -Math.sin(polar) * Math.cos(around));
        assertThat(sun.direction().minus(sunLights).length()).isLessThan(0.01);
    }

    /** Of all regions of a solid angle, a cap has the longest mean direction, so other regions get a larger spread. */
    @Property
    void uniformSky_lightsCoverTheirRegions(@ForAll @IntRange(min = 32, max = 256) int width,
            @ForAll @IntRange(min = 4, max = 64) int maxLights) {
        float[] rgb = new float[3 * width * (width / 2)];
        java.util.Arrays.fill(rgb, 1);
        for (EnvironmentLight light : new EnvironmentMap(width, width / 2, rgb).lights(maxLights)) {
            double cap = Math.toDegrees(Math.acos(1 - light.red() * Math.PI / (2 * Math.PI)));
            // The caps that replace cells shorten a direction by less than the cells do.
            assertThat(light.spread()).isBetween(0.99 * cap, Math.min(90, 2 * cap));
        }
    }

    @Test
    void singlePixelLight_coversThePixel() {
        float[] rgb = new float[3 * 64 * 32];
        rgb[3 * (8 * 64 + 40)] = 5;
        EnvironmentMap sky = new EnvironmentMap(64, 32, rgb);
        List<EnvironmentLight> lit = sky.lights(16).stream().filter(light -> light.red() > 0).toList();
        assertThat(lit).hasSize(1);
        assertThat(lit.getFirst().spread()).isEqualTo(Math.toDegrees(Math.acos(1 - sky.solidAngle(8) / (2 * Math.PI))), within(1e-6));
    }

    @Test
    void softness_scalesSpread() {
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("x.hdr", FOUR))).withOwn(own -> own.withLightCount(4));
        assertThat(world.withOwn(own -> own.withSoftness(0)).environments().getFirst().approximateLights(4, _ -> false))
                .noneMatch(Light::isArea);
        List<EnvironmentLight> environmentLights = FOUR.lights(4);
        List<Light> half = world.withOwn(own -> own.withSoftness(0.5)).environments().getFirst().approximateLights(4, _ -> false);
        for (int i = 0; i < 4; i++) {
            assertThat(half.get(i).area().spread()).isEqualTo(environmentLights.get(i).spread() / 2).isPositive();
        }
    }

    @Test
    void blackSky_givesBlackLight() {
        assertThat(new EnvironmentMap(3, 2, new float[18]).lights(16)).hasSize(1).allSatisfy(light -> assertThat(light.red()).isZero());
    }

    @Test
    void smoothSky_hasNoBrightParts() {
        float[] rgb = new float[3 * 64 * 32];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = 1 + (i / 3 / 64) / 32f;
        }
        assertThat(new EnvironmentMap(64, 32, rgb).brightLights(16)).hasSize(1).allMatch(light -> light.red() == 0);
    }

    /** A sun of 10 times the light of the whole sky, in one pixel of 2048. */
    @Test
    void sun_isABrightPart_andTheSkyIsNot() {
        float[] rgb = new float[3 * 64 * 32];
        java.util.Arrays.fill(rgb, 1);
        EnvironmentMap dull = new EnvironmentMap(64, 32, rgb.clone());
        float sun = (float) (10 * 4 * Math.PI / dull.solidAngle(8));
        java.util.Arrays.fill(rgb, 3 * (8 * 64 + 40), 3 * (8 * 64 + 40) + 3, sun);
        EnvironmentMap sky = new EnvironmentMap(64, 32, rgb);
        List<EnvironmentLight> lights = sky.brightLights(16);
        assertThat(lights).hasSize(1);
        assertThat(sky.limit()).isGreaterThanOrEqualTo(1);
        assertThat(lights.getFirst().red()).isEqualTo((sun - sky.limit()) * sky.solidAngle(8) / Math.PI, within(1e-9 * sun));
        double[] smooth = new double[3];
        sky.smoothRadiance(0, 1, 0, DomeRotation.NONE, smooth);
        assertThat(smooth[1]).isEqualTo(1, within(1e-6));
    }

    /** Bright parts and smooth light together are the whole map, for any pixels. */
    @Property(tries = 200)
    void brightPartsAndSmoothLight_areTheWholeMap(@ForAll @IntRange(min = 1, max = 300) int width,
            @ForAll @IntRange(min = 1, max = 60) int height, @ForAll @IntRange(min = 4, max = 64) int maxLights, @ForAll long seed) {
        EnvironmentMap sky = sky(width, height, seed);
        double total = 0;
        double smooth = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                total += sky.luminance(x, y) * sky.solidAngle(y);
                smooth += Math.min(sky.luminance(x, y), sky.limit()) * sky.solidAngle(y);
            }
        }
        double bright = sky.brightLights(maxLights).stream()
                .mapToDouble(light -> new Rgb(light.red(), light.green(), light.blue()).luminance() * Math.PI).sum();
        assertThat(smooth + bright).isEqualTo(total, within(1e-9 * total + 1e-300));
    }

    /** The file's sun may have a name that the environment lights would get. */
    @Test
    void environmentLights_haveUniqueNames() {
        World world = World.DEFAULT.withEnvironment(Optional.of(new Environment("x.hdr", FOUR)));
        for (String taken : List.of("environment 1", "environment 4")) {
            assertThat(world.environments().getFirst().approximateLights(4, taken::equals)).hasSize(4).extracting(Light::name)
                    .containsExactly("environment' 1", "environment' 2", "environment' 3", "environment' 4");
        }
    }

    /**
     * The lights have the cosines of their regions, for a floor exactly: all regions are on one side of the horizon. A row of cells between
     * the angles θ ± δ/2 counts with its middle, which is 1/cos(δ/2) too much, and less its own spread, at most sin(δ/2)/columns.
     */
    @Property
    void floorUnderUniformSky_isAsBrightAsTheSky(@ForAll @IntRange(min = 1, max = 128) int height,
            @ForAll @IntRange(min = 4, max = 64) int maxLights, @ForAll @DoubleRange(min = 0, max = 1) double softness) {
        int width = 2 * height;
        float[] rgb = new float[3 * width * height];
        java.util.Arrays.fill(rgb, 1);
        Environment sky = new Environment("x.hdr", new EnvironmentMap(width, height, rgb));
        World world = World.DEFAULT.withEnvironment(Optional.of(sky)).withOwn(own -> own.withSoftness(softness));
        // There are at least 16 rows and 32 columns of cells.
        double half = Math.PI / Math.max(16, height) / 2;
        assertThat(floorRadiance(world.environments().getFirst().approximateLights(maxLights, _ -> false))).isCloseTo(1,
                within(1 / Math.cos(half) - 1 + Math.sin(half) / 32 + 1e-9));
    }

    /** Returns the radiance of a white floor: the mean of the cosines of a cap above the horizon is that of its center times its length. */
    private static double floorRadiance(List<Light> lights) {
        double sum = 0;
        for (Light light : lights) {
            double height = -light.direction().normalized().y();
            double spread = Math.toRadians(light.area().spread());
            assertThat(Math.abs(Math.asin(height))).isGreaterThanOrEqualTo(spread - 1e-9);
            sum += light.diffuseWeight().r() * (1 + Math.cos(spread)) / 2 * Math.max(height, 0);
        }
        return sum;
    }

    @Test
    void regionWithoutLight_getsNoLight() {
        float[] rgb = new float[3 * 8 * 4];
        java.util.Arrays.fill(rgb, 0, 3 * 8 * 2, 1);
        assertThat(new EnvironmentMap(8, 4, rgb).lights(4)).hasSize(4).allMatch(light -> light.direction().y() > 0);
    }
}

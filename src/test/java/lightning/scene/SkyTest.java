package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** What is seen of a sky, and the lamps that it is cut into. */
class SkyTest {
    private static Sky sky(int width, int height, long seed) {
        var random = new Random(seed);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextInt(4) == 0 ? 0 : (float) Math.exp(random.nextGaussian() * 3);
        }
        return new Sky(width, height, rgb);
    }

    private static double[] seen(Sky sky, double x, double y, double z, double turn) {
        double[] to = new double[3];
        sky.radiance(x, y, z, turn, to);
        return to;
    }

    /** Four pixels side by side: +z to −x, −x to −z, −z to x, x to +z. */
    private static final Sky FOUR = new Sky(4, 1, new float[] {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});

    @Test
    void middle_isAtMinusZAndTheRightHalfAtX() {
        assertThat(seen(FOUR, 0, 0, -1, 0)[0]).isEqualTo(2.5, within(1e-12));
        assertThat(seen(FOUR, 1, 0, 0, 0)[0]).isEqualTo(3.5, within(1e-12));
        assertThat(seen(FOUR, 0, 0, 1, 0)[0]).as("around the sides").isEqualTo(2.5, within(1e-12));
        assertThat(seen(FOUR, -1, 0, 0, 0)[0]).isEqualTo(1.5, within(1e-12));
    }

    @Test
    void top_isUp() {
        Sky two = new Sky(1, 2, new float[] {5, 0, 0, 1, 0, 0});
        assertThat(seen(two, 0, 1, 0, 0)[0]).isEqualTo(5);
        assertThat(seen(two, 0, -1, 0, 0)[0]).isEqualTo(1);
        assertThat(seen(two, 0.6, 0, -0.8, 0)[0]).isEqualTo(3, within(1e-12));
    }

    /** A shape at −z that is turned by 90 degrees about y is at −x. */
    @Test
    void rotation_turnsAsAShapeTurns() {
        assertThat(seen(FOUR, -1, 0, 0, 90)[0]).isEqualTo(2.5, within(1e-12));
        World world = World.DEFAULT.withEnvironment(Optional.of(new Panorama("x.hdr", FOUR))).withLamps(4);
        List<Light> lights = world.lights(_ -> false);
        List<Light> turned = world.withRotation(90).lights(_ -> false);
        for (int i = 0; i < 4; i++) {
            Vec3 d = lights.get(i).direction();
            assertThat(turned.get(i).direction().minus(new Vec3(d.z(), d.y(), -d.x())).length()).isLessThan(1e-12);
        }
    }

    /** All light of the picture is in the lamps: its integral over π, whatever the number of lamps. */
    @Property
    void lamps_haveTheLightOfThePicture(@ForAll @IntRange(min = 1, max = 600) int width, @ForAll @IntRange(min = 1, max = 40) int height,
            @ForAll @IntRange(min = 4, max = 64) int most, @ForAll long seed) {
        Sky sky = sky(width, height, seed);
        double[] all = new double[3];
        double sphere = 0;
        for (int y = 0; y < height; y++) {
            sphere += width * sky.solidAngle(y);
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    all[c] += sky.channel(x, y, c) * sky.solidAngle(y) / Math.PI;
                }
            }
        }
        assertThat(sphere).isEqualTo(4 * Math.PI, within(1e-12 * 4 * Math.PI));
        List<SkyLamp> lamps = sky.lamps(most);
        assertThat(lamps).hasSizeBetween(1, most);
        // Sums of at most 24,000 terms that are not negative, each of them off by a rounding at most: 24,000 · 2⁻⁵³ of the sum, on both sides.
        double bound = 2 * 24_010 * 0x1p-53;
        assertThat(lamps.stream().mapToDouble(SkyLamp::red).sum()).isEqualTo(all[0], within(bound * all[0]));
        assertThat(lamps.stream().mapToDouble(SkyLamp::green).sum()).isEqualTo(all[1], within(bound * all[1]));
        assertThat(lamps.stream().mapToDouble(SkyLamp::blue).sum()).isEqualTo(all[2], within(bound * all[2]));
        lamps.forEach(lamp -> assertThat(lamp.towards().length()).isEqualTo(1, within(1e-12)));
    }

    @Test
    void smallSun_isALampOfItsOwn() {
        float[] rgb = new float[3 * 64 * 32];
        java.util.Arrays.fill(rgb, 0.01f);
        rgb[3 * (8 * 64 + 40)] = 1e5f;
        List<SkyLamp> lamps = new Sky(64, 32, rgb).lamps(16);
        SkyLamp sun = lamps.stream().max(java.util.Comparator.comparingDouble(SkyLamp::red)).orElseThrow();
        double polar = Math.PI * 8.5 / 32;
        double around = 2 * Math.PI * (40.5 / 64 - 0.5);
        Vec3 there = new Vec3(Math.sin(polar) * Math.sin(around), Math.cos(polar), -Math.sin(polar) * Math.cos(around));
        assertThat(sun.towards().minus(there).length()).isLessThan(0.01);
    }

    /** Of all parts of one solid angle a cap has the longest mean direction, so that what is no cap is spread farther. */
    @Property
    void lampsOfAnEvenSky_areSpreadAtLeastOverTheirPart(@ForAll @IntRange(min = 32, max = 256) int width,
            @ForAll @IntRange(min = 4, max = 64) int most) {
        float[] rgb = new float[3 * width * (width / 2)];
        java.util.Arrays.fill(rgb, 1);
        for (SkyLamp lamp : new Sky(width, width / 2, rgb).lamps(most)) {
            double cap = Math.toDegrees(Math.acos(1 - lamp.red() * Math.PI / (2 * Math.PI)));
            // The caps that cells are taken for shorten a direction by less than the cells do.
            assertThat(lamp.spread()).isBetween(0.99 * cap, Math.min(90, 2 * cap));
        }
    }

    @Test
    void lampOfOnePixel_isSpreadOverIt() {
        float[] rgb = new float[3 * 64 * 32];
        rgb[3 * (8 * 64 + 40)] = 5;
        Sky sky = new Sky(64, 32, rgb);
        List<SkyLamp> lit = sky.lamps(16).stream().filter(lamp -> lamp.red() > 0).toList();
        assertThat(lit).hasSize(1);
        assertThat(lit.getFirst().spread()).isEqualTo(Math.toDegrees(Math.acos(1 - sky.solidAngle(8) / (2 * Math.PI))), within(1e-6));
        assertThat(new Sky(1, 1, new float[] {1, 1, 1}).lamps(4).getFirst().spread()).isEqualTo(90);
    }

    @Test
    void softness_spreadsLampsByAShare() {
        World world = World.DEFAULT.withEnvironment(Optional.of(new Panorama("x.hdr", FOUR))).withLamps(4);
        assertThat(world.lights(_ -> false)).noneMatch(Light::isArea);
        List<SkyLamp> lamps = FOUR.lamps(4);
        List<Light> half = world.withSoftness(0.5).lights(_ -> false);
        for (int i = 0; i < 4; i++) {
            assertThat(half.get(i).area().spread()).isEqualTo(lamps.get(i).spread() / 2).isPositive();
        }
    }

    @Test
    void darkSky_isALampThatIsBlack() {
        assertThat(new Sky(3, 2, new float[18]).lamps(16)).hasSize(1).allSatisfy(lamp -> assertThat(lamp.red()).isZero());
    }

    /** The sun of a file may have a name that the lamps would have. */
    @Test
    void lamps_takeNoLightsName() {
        World world = World.DEFAULT.withEnvironment(Optional.of(new Panorama("x.hdr", FOUR)));
        assertThat(world.lights("environment 1"::equals).getFirst().name()).isEqualTo("environment' 1");
    }

    @Test
    void paperUnderAnEvenSky_isAsBrightAsTheSky() {
        float[] rgb = new float[3 * 64 * 32];
        java.util.Arrays.fill(rgb, 1);
        double sum = 0;
        for (SkyLamp lamp : new Sky(64, 32, rgb).lamps(64)) {
            sum += lamp.red() * Math.max(lamp.towards().y(), 0);
        }
        // 64 lamps of some 0.2 sr each stand for what they are in the middle of: their cosines' mean is off by less than their width, 0.25.
        assertThat(sum).isEqualTo(1, within(0.25));
        assertThat(Rgb.WHITE.r()).isEqualTo(1);
    }
}

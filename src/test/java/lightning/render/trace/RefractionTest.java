package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests refraction at a surface and through a glass ball against textbook optics. */
class RefractionTest {
    private static final Transmission GLASS = Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5);
    /** Error of a stored direction or normal. */
    private static final double FLOAT = 0x1p-22;

    private static float reflectance(Transmission clarity, boolean inside, double angle) {
        return Refraction.fresnelReflectance(clarity, inside, 0, 1, 0, (float) Math.sin(angle), (float) -Math.cos(angle), 0);
    }

    private static double[] direction(double eta, double angle) {
        double[] to = new double[3];
        return Refraction.writeDirection(0, 1, 0, (float) Math.sin(angle), (float) -Math.cos(angle), 0, eta, to) ? to : null;
    }

    /** Returns an angle from 0 to 90 degrees, uniform, or close to either end by a power of ten. */
    private static double angle(Random random) {
        double small = Math.pow(10, -12 * random.nextDouble());
        return switch (random.nextInt(3)) {
            case 0 -> Math.PI / 2 * random.nextDouble();
            case 1 -> small;
            default -> Math.PI / 2 - small;
        };
    }

    /** Returns an index of refraction from 1 to 4, or close to 1. */
    private static double ior(Random random) {
        return 1 + 3 * (random.nextBoolean() ? random.nextDouble() : Math.pow(10, -16 * random.nextDouble()));
    }

    @Property(tries = 200)
    void refractedAngles_followSnellsLaw(@ForAll long seed) {
        Random random = new Random(seed);
        double angle = angle(random);
        double ior = ior(random);
        double[] d = direction(1 / ior, angle);
        assertThat(d[0]).isCloseTo(Math.sin(angle) / ior, within(FLOAT));
        assertThat(d[1]).isNegative();
        assertThat(Math.hypot(d[0], d[1])).isCloseTo(1, within(1e-15));
        assertThat(d[2]).isZero();
    }

    /** Inside glass, reflection is total from the angle whose sine is 1/ior. */
    @ParameterizedTest
    @ValueSource(doubles = {1.33, 1.5, 2.42, 4})
    void criticalAngle_separatesRefractionFromTotalReflection(double ior) {
        double critical = Math.asin(1 / ior);
        assertThat(direction(ior, critical + 1e-5)).isNull();
        assertThat(reflectance(GLASS.withIor(ior), true, critical + 1e-5)).isEqualTo(1);
        assertThat(direction(ior, critical - 1e-5)[0]).isCloseTo(1, within(1e-3));
        assertThat(reflectance(GLASS.withIor(ior), true, critical - 1e-5)).isBetween(0.9f, 0.9999f);
    }

    /** Checks ((n − 1)/(n + 1))²: 4 % for glass, 17 % for diamond; the same from inside. */
    @ParameterizedTest
    @CsvSource({"1.33, 0.020059", "1.5, 0.04", "2.42, 0.172395", "1, 0"})
    void normalIncidence_reflectsByIndexOfRefraction(double ior, double expected) {
        assertThat((double) reflectance(GLASS.withIor(ior), false, 0)).isCloseTo(expected, within(1e-6));
        assertThat((double) reflectance(GLASS.withIor(ior), true, 0)).isCloseTo(expected, within(1e-6));
    }

    /** At the angle whose tangent is n one polarization is not reflected at all: half of sin²(θ − θ') remains. */
    @Test
    void brewstersAngle_reflectsOnePolarization() {
        double angle = Math.atan(1.5);
        double s = Math.sin(angle - Math.asin(Math.sin(angle) / 1.5));
        assertThat((double) reflectance(GLASS, false, angle)).isCloseTo(s * s / 2, within(1e-6));
    }

    @Property(tries = 200)
    void reflectance_isSameInReverseDirection(@ForAll long seed) {
        Random random = new Random(seed);
        double angle = angle(random);
        double ior = ior(random);
        Transmission clarity = GLASS.withIor(ior);
        assertThat(reflectance(clarity, false, angle)).isBetween(0f, 1f);
        assertThat(reflectance(clarity, true, angle)).isBetween(0f, 1f);
        // Closer to the critical angle inside, the rounding of a direction to float decides the reflectance.
        angle = Math.min(angle, 1.5);
        assertThat((double) reflectance(clarity, false, angle)).isCloseTo(reflectance(clarity, true, Math.asin(Math.sin(angle) / ior)),
                within(1e-3));
        assertThat(reflectance(clarity, false, angle)).isBetween(0f, 1f);
    }

    /** Sums the inter-reflections between two faces: F + (1 − F)²·F·(1 + F² + …). */
    @Test
    void thinPane_reflectsOnBothFaces() {
        double f = 0.04;
        double sum = f;
        for (int k = 0; k < 10; k++) {
            sum += (1 - f) * (1 - f) * Math.pow(f, 2 * k + 1);
        }
        assertThat((double) reflectance(GLASS.withThin(true), false, 0)).isCloseTo(sum, within(1e-7));
        assertThat(direction(Refraction.eta(GLASS.withThin(true), false), 1.2)[0]).isCloseTo(Math.sin(1.2), within(1e-7));
    }

    /** Uses rays along the surface, where every value is 0 or 1, and extreme numbers. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1 + 0x1p-52, 1.5, 4})
    void grazingRays_haveFiniteReflectance(double ior) {
        Transmission clarity = GLASS.withIor(ior);
        for (float c : new float[] {0, Float.MIN_VALUE, 1e-20f, 1, 1 + 0x1p-22f}) {
            for (boolean inside : new boolean[] {false, true}) {
                assertThat(Refraction.fresnelReflectance(clarity, inside, 0, 1, 0, (float) Math.sqrt(Math.max(0, 1 - c * c)), -c, 0))
                        .isBetween(0f,
                                1f);
                double[] to = new double[3];
                if (Refraction.writeDirection(0, 1, 0, (float) Math.sqrt(Math.max(0, 1 - c * c)), -c, 0, Refraction.eta(clarity, inside),
                        to)) {
                    assertThat(Math.hypot(to[0], to[1])).isCloseTo(1, within(1e-12));
                }
            }
        }
    }

    /**
     * A ray that passes a ball's center by b radii is deflected by 2·(asin b − asin(b/n)) in total, wherever the ball is. It
     * enters, leaves, and hits nothing between. Its points are floats, whose rounding turns the normal by the same fraction of
     * a radius.
     */
    @ParameterizedTest
    @CsvSource({"4, 1e-5", "1e4, 1e-2", "1e-3, 1e-5"})
    void glassBall_deflectsRaysByGeometry(double distance, double off) {
        Scene scene = new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT,
                List.of(Material.of("glass").withTransmission(GLASS)),
                List.of(new Shape(Solid.SPHERE, "ball", "glass",
                        new Placement(new Vec3(0, 0, -distance), Vec3.ZERO, new Vec3(distance / 4, distance / 4, distance / 4)))),
                List.of());
        Geometry geometry = Geometry.of(scene);
        for (double b : new double[] {0, 0.1, 0.5, 0.9, 0.99}) {
            double angle = Math.asin(b / 4);
            Ray ray = new Ray(Vec3.ZERO, new Vec3(Math.sin(angle), 0, -Math.cos(angle)));
            SurfacePoint entered = geometry.surface(BruteForce.nearest(geometry, ray), ray);
            assertThat(entered.backSide().isInside()).isFalse();
            Ray inside = entered.refractedRay();
            SurfacePoint left = geometry.surface(BruteForce.nearest(geometry, inside), inside);
            assertThat(left.backSide().isInside()).isTrue();
            assertThat((double) left.backSide().insideDistance()).isCloseTo(2 * Math.cos(Math.asin(b / 1.5)) * distance / 4,
                    within(off * distance));
            Ray out = left.refractedRay();
            assertThat(BruteForce.nearest(geometry, out)).isNegative();
            double turned = Math.acos(Math.min(1, out.direction().dot(ray.direction())));
            assertThat(turned).as("at " + b).isCloseTo(2 * (Math.asin(b) - Math.asin(b / 1.5)), within(1e-3));
        }
    }
}

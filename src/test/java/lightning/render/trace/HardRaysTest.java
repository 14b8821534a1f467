package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Tests hits and distances of difficult rays against numbers of 130 digits. */
class HardRaysTest {
    /** Ulp of 1. */
    private static final double ULP = 0x1p-52;
    /** Maximum error in ulps of the distance from the ray's origin to the shape. */
    private static final double ULPS = 8;
    private static final int RAYS = 10;
    static final List<Solid.Canonical> TEXTBOOK = List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER);

    @Provide
    Arbitrary<Solid.Canonical> solids() {
        return Arbitraries.of(Stream.concat(CanonicalSolids.CLOSED.stream(), CanonicalSolids.OPEN.stream()).toList());
    }

    /** Scales 10^±6, and both in one shape. */
    @Provide
    Arbitrary<Vec3> scales() {
        return Arbitraries.of(Vec3.ONE, new Vec3(1e6, 1e6, 1e6), new Vec3(1e-6, 1e-6, 1e-6), new Vec3(1e6, 1, 1),
                new Vec3(1, 1e6, 1), new Vec3(1e-3, 1, 1), new Vec3(1, 1e-3, 1), new Vec3(1e6, 1, 1e-3), new Vec3(-2, 1, -0.5));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void canonicalSolid_isHitAtExactDistance(@ForAll HardRay hard, @ForAll("solids") Solid.Canonical solid, @ForAll Random random) {
        for (int n = 0; n < RAYS; n++) {
            Ray ray = hard.unnormalized(solid, random);
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            double t = CanonicalSolids.distance(solid, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            assertThat(error(solid, ray, t)).as("%s %s", hard, ray).isNull();
        }
    }

    private static String error(Solid.Canonical solid, Ray ray, double t) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        double margin = ULPS * ULP * Math.max(1, o.length());
        return ExactSolids.error(solid, ExactSolids.exact(o.x(), o.y(), o.z()), ExactSolids.exact(d.x(), d.y(), d.z()), t, margin);
    }

    /** Counterexample: shows that these rays distinguish good formulas from bad ones. */
    @ParameterizedTest
    @FieldSource("TEXTBOOK")
    void textbookFormulas_failForEverySolid(Solid.Canonical solid) {
        Random random = new Random(1);
        int wrong = 0;
        for (int n = 0; n < 1000; n++) {
            Ray ray = HardRay.values()[n % HardRay.values().length].create(solid, random);
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            wrong += error(solid, ray, NaiveSolids.distance(solid, o.x(), o.y(), o.z(), d.x(), d.y(), d.z())) != null ? 1 : 0;
        }
        assertThat(wrong).as("wrong answers for the " + solid.typeName() + " among 1000 hard rays").isGreaterThan(50);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void placedSolid_isHitAtExactDistance(@ForAll HardRay hard, @ForAll("solids") Solid.Canonical solid, @ForAll("scales") Vec3 scale,
            @ForAll Random random) {
        Vec3 at = HardRay.direction(random).times(random.nextInt(3) == 0 ? 0 : Math.pow(10, 8 * random.nextDouble()));
        Vec3 camera = random.nextBoolean() ? Vec3.ZERO : at.plus(HardRay.direction(random).times(scale.maxAbs()));
        PrimitiveTable table = TraceScenes.singleShape(solid, new Placement(at, Vec3.ZERO, scale), camera);
        for (int n = 0; n < RAYS; n++) {
            Ray local = hard.create(solid, random);
            Vec3 o = new Vec3(local.origin().x() * scale.x(), local.origin().y() * scale.y(), local.origin().z() * scale.z())
                    .plus(at.minus(camera));
            Vec3 d = new Vec3(local.direction().x() * scale.x(), local.direction().y() * scale.y(), local.direction().z() * scale.z());
            double t = table.distance(0, o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            Vec3 far = at.minus(camera);
            double margin = ULPS * ULP * Math.max(Math.max(1 + (Math.abs(o.x()) + Math.abs(far.x())) / Math.abs(scale.x()),
                    (Math.abs(o.y()) + Math.abs(far.y())) / Math.abs(scale.y())),
                    (Math.abs(o.z()) + Math.abs(far.z())) / Math.abs(scale.z()));
            if (margin > 0.5) {
                // The spacing of doubles at the shape's position equals its size.
                return;
            }
            assertThat(ExactSolids.error(solid, toLocal(o, camera, at, scale), toLocal(d, Vec3.ZERO, Vec3.ZERO, scale), t, margin))
                    .as("%s %s, scale %s at %s from %s", hard, local, scale, at, camera).isNull();
        }
    }

    /** Computes (o + camera − at) / scale in arbitrary precision. */
    private static BigDecimal[] toLocal(Vec3 o, Vec3 camera, Vec3 at, Vec3 scale) {
        BigDecimal[] p = ExactSolids.exact(o.x(), o.y(), o.z());
        BigDecimal[] c = ExactSolids.exact(camera.x(), camera.y(), camera.z());
        BigDecimal[] a = ExactSolids.exact(at.x(), at.y(), at.z());
        BigDecimal[] s = ExactSolids.exact(scale.x(), scale.y(), scale.z());
        for (int i = 0; i < 3; i++) {
            p[i] = p[i].add(c[i]).subtract(a[i]).divide(s[i], new MathContext(130));
        }
        return p;
    }

    /** A square has no inside: the sign of t and the position in the square decide. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void square_isHitAtExactDistance(@ForAll HardRay hard, @ForAll Random random) {
        for (int n = 0; n < RAYS; n++) {
            Ray ray = hard.unnormalized(Solid.PLANE, random);
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            double t = CanonicalSolids.plane(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            double margin = ULPS * ULP * Math.max(1, o.length());
            boolean ahead = o.y() != 0 && d.y() != 0 && o.y() > 0 != d.y() > 0;
            if (!ahead) {
                assertThat(t).as("%s %s", hard, ray).isEqualTo(SolidGeometry.MISS);
                continue;
            }
            BigDecimal exact = new BigDecimal(o.y()).negate().divide(new BigDecimal(d.y()), new MathContext(130));
            double off = 0;
            for (double[] axis : List.of(new double[] {o.x(), d.x()}, new double[] {o.z(), d.z()})) {
                off = Math.max(off, new BigDecimal(axis[0]).add(exact.multiply(new BigDecimal(axis[1]))).abs().doubleValue() - 0.5);
            }
            if (Math.abs(off) > margin) {
                assertThat(t < SolidGeometry.MISS).as("%s %s: %s from the edge", hard, ray, off).isEqualTo(off < 0);
            }
            if (t < SolidGeometry.MISS) {
                assertThat(new BigDecimal(t).subtract(exact).abs().doubleValue()).isLessThanOrEqualTo(ULP * t);
            }
        }
    }
}

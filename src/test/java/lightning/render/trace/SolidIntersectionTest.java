package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.node.Solid;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests distances against calculations by hand. */
class SolidIntersectionTest {
    private static final double MISS = SolidGeometry.MISS;

    @Test
    void sphereHeadOn_isHitAtNearSide() {
        assertThat(CanonicalSolids.sphere(0, 0, 5, 0, 0, -1)).isEqualTo(4);
        assertThat(CanonicalSolids.sphere(0, 0, 5, 0, 0, -2)).isEqualTo(2);
        assertThat(CanonicalSolids.sphere(0, 0, 5, 0, 0, 1)).isEqualTo(MISS);
        assertThat(CanonicalSolids.sphere(0, 0, 5, 0, 1, 0)).isEqualTo(MISS);
    }

    @Test
    void solidBounds_matchExtent() {
        for (Solid.Canonical solid : CanonicalSolids.ALL) {
            assertThat(solid.bounds()).as("%s", solid).containsExactly(CanonicalSolids.extent(solid));
        }
    }

    @Test
    void sphereFromInside_isHitAhead() {
        assertThat(CanonicalSolids.sphere(0, 0, 0, 0, 0, 3)).isEqualTo(1 / 3.0);
        assertThat(CanonicalSolids.sphere(0, 0.5, 0, 0, 1, 0)).isEqualTo(0.5);
        assertThat(CanonicalSolids.sphere(0, 0.5, 0, 0, -1, 0)).isEqualTo(1.5);
    }

    @Test
    void sphereFromSurface_isHitOnlyOnFarSide() {
        assertThat(CanonicalSolids.sphere(0, 1, 0, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.sphere(0, 1, 0, 0, 1, 0)).isEqualTo(MISS);
    }

    /** Uses points with c = |o|² − 1 exactly 0: the first root is then 0 itself, and the second the chord −2·o·d. */
    @Test
    void sphereFromExactSurface_isNotHitAtOrigin() {
        Random random = new Random(1);
        for (int n = 0; n < 1000; n++) {
            Vec3 o = HardRay.direction(random).normalized();
            Vec3 d = HardRay.direction(random).normalized();
            if (o.dot(o) == 1) {
                double chord = -2 * o.dot(d);
                double t = CanonicalSolids.sphere(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
                assertThat(t).as("%s %s", o, d).isCloseTo(chord > 0 ? chord : MISS, within(1e-15 / Math.min(1, Math.abs(chord))));
            }
        }
    }

    @Test
    void cylinderFromExactSide_isNotHitAtOrigin() {
        Random random = new Random(1);
        for (int n = 0; n < 1000; n++) {
            double angle = 2 * Math.PI * random.nextDouble();
            double x = Math.cos(angle);
            double z = Math.sin(angle);
            double along = 2 * Math.PI * random.nextDouble();
            double dx = Math.cos(along);
            double dz = Math.sin(along);
            if (x * x + z * z == 1) {
                double chord = -2 * (x * dx + z * dz);
                assertThat(CanonicalSolids.cylinder(x, 0.5, z, dx, 0, dz)).as("%s %s along %s %s", x, z, dx, dz)
                        .isCloseTo(chord > 0 ? chord : MISS, within(1e-15 / Math.min(1, Math.abs(chord))));
            }
        }
    }

    /** Such a ray is outside except for rounding; so are both roots and their divisors. */
    @Test
    void tangentFromSurface_hitsNothingElsewhere() {
        Random random = new Random(2);
        for (int n = 0; n < 300_000; n++) {
            Vec3 o = HardRay.direction(random).normalized();
            Vec3 d = o.cross(HardRay.direction(random)).normalized();
            assertHitAtOriginOrMiss(CanonicalSolids.sphere(o.x(), o.y(), o.z(), d.x(), d.y(), d.z()), o, d);
            Vec3 out = new Vec3(o.x(), 0, o.z()).normalized();
            Vec3 around = new Vec3(-out.z(), 0, out.x());
            double h = random.nextDouble();
            double slope = n % 2 == 0 ? 0 : random.nextDouble() - 0.5;
            Vec3 up = around.plus(new Vec3(0, slope, 0)).normalized();
            assertHitAtOriginOrMiss(CanonicalSolids.cylinder(out.x(), h, out.z(), up.x(), up.y(), up.z()), out, up);
            Vec3 side = out.times(1 - h).plus(new Vec3(0, h, 0));
            Vec3 slanted = around.plus(Vec3.Y.minus(out).times(slope)).normalized();
            assertHitAtOriginOrMiss(CanonicalSolids.cone(side.x(), side.y(), side.z(), slanted.x(), slanted.y(), slanted.z()), side,
                    slanted);
        }
    }

    private static void assertHitAtOriginOrMiss(double t, Vec3 o, Vec3 d) {
        if (t > 1e-5 && t < MISS) {
            assertThat(t).as("from %s along %s", o, d).isEqualTo(MISS);
        }
    }

    @Property
    void distantSphere_isHitAtFullPrecision(@ForAll @DoubleRange(min = 0, max = 0.999) @Scale(6) double offset,
            @ForAll @DoubleRange(min = 2, max = 1e7) double far) {
        double expected = far - Math.sqrt((1 - offset) * (1 + offset));
        assertThat(CanonicalSolids.sphere(offset, 0, far, 0, 0, -1)).isCloseTo(expected, within(far * 0x1p-51));
    }

    @Test
    void cylinderFromSide_isHitAtRadius() {
        assertThat(CanonicalSolids.cylinder(3, 0.5, 0, -1, 0, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.cylinder(3, 0, 0, -1, 0, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.cylinder(3, 1.01, 0, -1, 0, 0)).isEqualTo(MISS);
    }

    @Test
    void cylinderFromInsideAlongAxis_isHitAtCap() {
        assertThat(CanonicalSolids.cylinder(0, 0.25, 0, 0, 1, 0)).isEqualTo(0.75);
        assertThat(CanonicalSolids.cylinder(0.5, 0.25, 0.5, 0, -1, 0)).isEqualTo(0.25);
        assertThat(CanonicalSolids.cylinder(0, 0.25, 0, 1, 0, 0)).isEqualTo(1);
    }

    @Test
    void cylinderFromAboveAlongAxis_isHitAtCapInsideRadius() {
        assertThat(CanonicalSolids.cylinder(0.9, 3, 0, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.cylinder(1, 3, 0, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.cylinder(1.001, 3, 0, 0, -1, 0)).isEqualTo(MISS);
    }

    @Test
    void cylinderThroughCap_isHitWhereRayCrossesCap() {
        assertThat(CanonicalSolids.cylinder(-1, 2, 0, 1, -1, 0)).isEqualTo(1);
        assertThat(CanonicalSolids.cylinder(-2.5, 1.5, 0, 1, -0.5, 0)).isEqualTo(1.5);
    }

    @Test
    void frustumFromSide_isHitAtInterpolatedRadius() {
        Solid.Canonical narrow = new Solid.Frustum(0.5, true);
        Solid.Canonical wide = new Solid.Frustum(3, true);
        assertThat(CanonicalSolids.distance(narrow, 3, 0.5, 0, -1, 0, 0)).isEqualTo(2.25);
        assertThat(CanonicalSolids.distance(narrow, 3, 1, 0, -1, 0, 0)).isEqualTo(2.5);
        assertThat(CanonicalSolids.distance(narrow, 3, 1.01, 0, -1, 0, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.distance(wide, 5, 0.5, 0, -1, 0, 0)).isEqualTo(3);
        assertThat(CanonicalSolids.distance(wide, 2.5, 3, 0, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.distance(wide, 2, -1, 0, 0, 1, 0)).isEqualTo(1.5);
    }

    @Test
    void extremeFrustums_matchConeAndCylinder() {
        Random random = new Random(3);
        for (int n = 0; n < 1000; n++) {
            Ray ray = HardRay.FROM_AFAR.create(Solid.CONE, random);
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            assertThat(CanonicalSolids.distance(new Solid.Frustum(0, true), o.x(), o.y(), o.z(), d.x(), d.y(), d.z()))
                    .isEqualTo(CanonicalSolids.cone(o.x(), o.y(), o.z(), d.x(), d.y(), d.z()));
            assertThat(CanonicalSolids.distance(new Solid.Frustum(1, true), o.x(), o.y(), o.z(), d.x(), d.y(), d.z()))
                    .isEqualTo(CanonicalSolids.cylinder(o.x(), o.y(), o.z(), d.x(), d.y(), d.z()));
        }
    }

    @Test
    void openCylinder_isOpenAtEnds_andHitFromInside() {
        Solid.Canonical tube = new Solid.Cylinder(false);
        assertThat(CanonicalSolids.distance(tube, 0, 3, 0, 0, -1, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.distance(tube, 0, 0.5, 0, 0, 1, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.distance(tube, 0, 0.5, 0, 1, 0, 0)).isEqualTo(1);
        assertThat(CanonicalSolids.distance(tube, 3, 0.5, 0, -1, 0, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.distance(tube, -0.5, 1.5, 0, 1, -0.5, 0)).as("over the rim to the inner face").isEqualTo(1.5);
    }

    @Test
    void openConeFromBelow_isHitInside() {
        Solid.Canonical hat = new Solid.Cone(false);
        assertThat(CanonicalSolids.distance(hat, 0.5, -1, 0, 0, 1, 0)).isEqualTo(1.5);
        assertThat(CanonicalSolids.distance(hat, 1.5, -1, 0, 0, 1, 0)).isEqualTo(MISS);
    }

    @Test
    void coneFromSide_isHitAtOneMinusHeight() {
        assertThat(CanonicalSolids.cone(3, 0.25, 0, -1, 0, 0)).isEqualTo(2.25);
        assertThat(CanonicalSolids.cone(3, 0.75, 0, -1, 0, 0)).isEqualTo(2.75);
        assertThat(CanonicalSolids.cone(3, 1.25, 0, -1, 0, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.cone(3, -0.25, 0, -1, 0, 0)).isEqualTo(MISS);
    }

    @Test
    void coneAlongAxis_isHitAtApexFromAbove_andAtBaseFromBelow() {
        assertThat(CanonicalSolids.cone(0, 3, 0, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.cone(0.5, 3, 0, 0, -1, 0)).isEqualTo(2.5);
        assertThat(CanonicalSolids.cone(0.5, -3, 0, 0, 1, 0)).isEqualTo(3);
        assertThat(CanonicalSolids.cone(1.5, -3, 0, 0, 1, 0)).isEqualTo(MISS);
    }

    /** The discriminant is 0 and may round to either side: the base must still be hit. */
    @Test
    void coneFromBelowTowardApex_isHitAtBase() {
        Random random = new Random(3);
        for (int n = 0; n < 100_000; n++) {
            // Up to 45° off the axis, and far less.
            double tilt = Math.scalb(1.0, -random.nextInt(100));
            Vec3 d = new Vec3(tilt * (random.nextDouble() - 0.5), 1, tilt * (random.nextDouble() - 0.5)).normalized();
            double far = 2 + random.nextInt(50);
            Vec3 o = Vec3.Y.minus(d.times(far));
            double expected = far - 1 / d.y();
            double t = CanonicalSolids.cone(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            if (!(Math.abs(t - expected) < 1e-15 * far * far)) {
                assertThat(t).as("%s %s", o, d).isCloseTo(expected, within(1e-15 * far * far));
            }
        }
    }

    @Test
    void coneFromInside_isHitAhead() {
        assertThat(CanonicalSolids.cone(0, 0.5, 0, 1, 0, 0)).isEqualTo(0.5);
        assertThat(CanonicalSolids.cone(0, 0.5, 0, 0, -1, 0)).isEqualTo(0.5);
        assertThat(CanonicalSolids.cone(0, 0.5, 0, 0, 1, 0)).isEqualTo(0.5);
    }

    @Test
    void coneAlongGenerator_isHitOnceFromInside() {
        // Parallel to the generator from (1, 0, 0) to the apex, half as far from the axis.
        assertThat(CanonicalSolids.cone(0.5, 0, 0, -1, 1, 0)).isEqualTo(0.75);
        assertThat(CanonicalSolids.cone(-1, -1, 0, 1, 1, 0)).isEqualTo(1);
    }

    @Test
    void coneNextToGenerator_isMissed() {
        assertThat(CanonicalSolids.cone(0, 1, 0.01, 1, -1, 0)).isEqualTo(MISS);
    }

    @Test
    void coneAboveApex_isMissed() {
        // Through the upper half of the double cone only.
        assertThat(CanonicalSolids.cone(3, 2, 0, -1, 0, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.cone(3, 2, 0, -1, 0.1, 0)).isEqualTo(MISS);
    }

    @Test
    void plane_isHitUpToEdgeFromBothSides() {
        assertThat(CanonicalSolids.plane(0.5, 2, 0.5, 0, -1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.plane(-0.5, -2, 0.5, 0, 1, 0)).isEqualTo(2);
        assertThat(CanonicalSolids.plane(Math.nextUp(0.5), 2, 0, 0, -1, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.plane(0, 2, -0.6, 0, -1, 0)).isEqualTo(MISS);
    }

    @Test
    void rayInPlane_missesPlane() {
        assertThat(CanonicalSolids.plane(0, 0, 0, 1, 0, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.plane(0, 0, 0, 1, -1, 0)).isEqualTo(MISS);
        assertThat(CanonicalSolids.plane(0, 1, 0, 1, 0, 0)).isEqualTo(MISS);
    }

    /** Distances are in lengths of the direction, however short or long it is. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-60, 1e-40, 1e-30, 1, 1e30, 1e60})
    void solids_areHitForAnyDirectionLength(double length) {
        Percentage rounding = withinPercentage(1e-12);
        assertThat(CanonicalSolids.sphere(0, 0, 5, 0, 0, -length) * length).isCloseTo(4, rounding);
        assertThat(CanonicalSolids.cylinder(3, 0.5, 0, -length, 0.1 * length, 0) * length).isCloseTo(2, rounding);
        assertThat(CanonicalSolids.cylinder(0.5, 3, 0, 0, -length, 0) * length).isCloseTo(2, rounding);
        assertThat(CanonicalSolids.cone(3, 0.25, 0, -length, 0, 0) * length).isCloseTo(2.25, rounding);
        assertThat(CanonicalSolids.plane(0.1, 2, 0.1, 0, -length, 0) * length).isCloseTo(2, rounding);
    }

    @Test
    void zeroDirection_missesEverything() {
        for (double y : new double[] {0, 0.5, 3}) {
            assertThat(CanonicalSolids.sphere(0, y, 0, 0, 0, 0)).isEqualTo(MISS);
            assertThat(CanonicalSolids.cylinder(0, y, 0, 0, 0, 0)).isEqualTo(MISS);
            assertThat(CanonicalSolids.cone(0, y, 0, 0, 0, 0)).isEqualTo(MISS);
            assertThat(CanonicalSolids.plane(0, y, 0, 0, 0, 0)).isEqualTo(MISS);
        }
    }

    /** Every hit is on the surface, and the midpoint between origin and hit is not beyond another surface. */
    @Property
    void hitPoint_liesOnSurface(@ForAll @DoubleRange(min = -4, max = 4) double ox, @ForAll @DoubleRange(min = -4, max = 4) double oy,
            @ForAll @DoubleRange(min = -4, max = 4) double oz, @ForAll @DoubleRange(min = -1, max = 1) double tx,
            @ForAll @DoubleRange(min = 0, max = 1) double ty, @ForAll @DoubleRange(min = -1, max = 1) double tz) {
        Vec3 o = new Vec3(ox, oy, oz);
        Vec3 d = new Vec3(tx - ox, ty - oy, tz - oz);
        org.junit.jupiter.api.Assumptions.assumeTrue(d.maxAbs() > 1e-3);
        Vec3 sphere = o.plus(d.times(finite(CanonicalSolids.sphere(ox, oy, oz, d.x(), d.y(), d.z()))));
        assertOnSurface(sphere.length() - 1, o, sphere);
        Vec3 cylinder = o.plus(d.times(finite(CanonicalSolids.cylinder(ox, oy, oz, d.x(), d.y(), d.z()))));
        assertOnSurface(Math.max(Math.hypot(cylinder.x(), cylinder.z()) - 1, Math.abs(cylinder.y() - 0.5) - 0.5), o, cylinder);
        Vec3 cone = o.plus(d.times(finite(CanonicalSolids.cone(ox, oy, oz, d.x(), d.y(), d.z()))));
        assertOnSurface(Math.max(Math.hypot(cone.x(), cone.z()) - (1 - cone.y()), -cone.y()), o, cone);
    }

    private static double finite(double t) {
        assertThat(t).isPositive();
        return t < MISS ? t : 0;
    }

    private static void assertOnSurface(double outside, Vec3 o, Vec3 p) {
        if (!p.equals(o)) {
            assertThat(outside).as("%s from %s", p, o).isCloseTo(0, within(1e-7));
        }
    }
}

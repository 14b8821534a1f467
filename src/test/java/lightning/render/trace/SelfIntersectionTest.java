package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import lightning.sample.Slow;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests rays that leave a shape from a visible point on it. Acne is a ray that hits the shape it leaves; a leak is one that
 * enters the shape without hitting it. {@code -Dlightning.points=1000000} tests a million points for each shape and place.
 */
@Slow
class SelfIntersectionTest {
    private static final List<Solid.Canonical> SOLIDS = List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.PLANE, Solid.FRUSTUM,
            new Solid.Frustum(2, true));

    /** Solids whose sides are walls. */
    private static final List<Solid.Canonical> OPEN = List.of(new Solid.Cylinder(false), new Solid.Cone(false),
            new Solid.Frustum(0.5, false), new Solid.Frustum(2, false));
    /** Minimum distance of points from a rim or the axis, local units: nearer ones may hit another part of the wall. */
    private static final double NARROW = 0.05;

    private static final int POINTS = Integer.getInteger("lightning.points", 10_000);

    /** Returns scales and camera positions in units of the scale, for which floats can represent the points. */
    static Stream<Arguments> places() {
        return Stream.of(
                Arguments.of(Vec3.ONE, new Vec3(0, 0, -10)),
                Arguments.of(Vec3.ONE, new Vec3(300, -200, 500)),
                Arguments.of(new Vec3(1e6, 1e6, 1e6), new Vec3(3, 1, -2)),
                Arguments.of(new Vec3(1e-6, 1e-6, 1e-6), new Vec3(3, 1, -2)),
                Arguments.of(new Vec3(1e6, 1, 1), new Vec3(1e-5, 5, -8)),
                Arguments.of(new Vec3(1, 1e-3, 1), new Vec3(1, -2e3, 3)),
                Arguments.of(new Vec3(2, 2, 2), new Vec3(6, -2, -5)));
    }

    /** Returns places with round walls, so that an outward ray is along the normal, or leans like the wall. */
    static Stream<Arguments> roundPlaces() {
        return places().filter(p -> ((Vec3) p.get()[0]).x() == ((Vec3) p.get()[0]).z());
    }

    /** Returns rooms whose points, and wedges at their rims, floats can represent. */
    static Stream<Arguments> rooms() {
        return Stream.of(Arguments.of(Vec3.ONE), Arguments.of(new Vec3(1e6, 1e6, 1e6)), Arguments.of(new Vec3(1e-6, 1e-6, 1e-6)),
                Arguments.of(new Vec3(1, 0.1, 1)), Arguments.of(new Vec3(100, 3, 5)));
    }

    /** Returns places where the spacing of floats equals the size of the shape, or its thickness. */
    static Stream<Arguments> farPlaces() {
        return Stream.of(
                Arguments.of(Vec3.ONE, new Vec3(3e4, 1e4, -2e4)),
                Arguments.of(new Vec3(2, 2, 2), new Vec3(148376 / 2.0, 1234 / 2.0, -223423 / 2.0)),
                Arguments.of(new Vec3(1e6, 1e-3, 1e6), new Vec3(1e-6, -1e3, 1e-6)),
                Arguments.of(Vec3.ONE, new Vec3(1e6, -2e6, 1e6)));
    }

    private final Random random = new Random(1);
    private int acneCount;
    private int leakCount;
    private long rayCount;

    @ParameterizedTest
    @MethodSource("places")
    void raysFromOuterSurface_leaveAndEnter(Vec3 scale, Vec3 at) {
        checkFromOutside(scale, at);
        assertThat(acneCount).as("acne among %s rays, %s", rayCount, scale).isZero();
        assertThat(leakCount).as("leaks among %s rays, %s", rayCount, scale).isZero();
    }

    /** Beyond the precision of floats, one in a million may fail. */
    @ParameterizedTest
    @MethodSource("farPlaces")
    void raysFromDistantPoints_leaveAndEnter(Vec3 scale, Vec3 at) {
        checkFromOutside(scale, at);
        assertThat(acneCount).as("acne among %s rays, %s", rayCount, scale).isLessThanOrEqualTo((int) (rayCount / 1_000_000));
        assertThat(leakCount).as("leaks among %s rays, %s", rayCount, scale).isLessThanOrEqualTo((int) (rayCount / 1_000_000));
    }

    /**
     * From inside, nothing outside is visible, and nothing hides what is inside; one in a million may fail at a cone's sharp
     * rim.
     */
    @ParameterizedTest
    @MethodSource("rooms")
    void raysFromInnerSurface_stayInside(Vec3 scale) {
        for (Solid.Canonical solid : List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.FRUSTUM)) {
            for (double rotation : new double[] {0, 37}) {
                Vec3 rotate = new Vec3(rotation, 2 * rotation, -rotation);
                Vec3 camera = new Placement(Vec3.ZERO, rotate, scale).transform().transformPoint(CanonicalSolids.center(solid));
                Placement placement = new Placement(camera.negated(), rotate, scale);
                checkSurface(solid, placement, Vec3.ZERO, (geometry, from, normal) -> {
                    leakCount += geometry.distance(0, new Ray(from, outwardDirection(normal))) < SolidGeometry.MISS ? 0 : 1;
                    acneCount += geometry.distance(0, new Ray(from, from.negated())) < 1 ? 1 : 0;
                });
            }
        }
        assertThat(acneCount).as("acne among %s rays, %s", rayCount, scale).isLessThanOrEqualTo((int) (rayCount / 1_000_000));
        assertThat(leakCount).as("leaks among %s rays, %s", rayCount, scale).isLessThanOrEqualTo((int) (rayCount / 1_000_000));
    }

    /**
     * A side without caps has two faces. An outward ray from the outer face hits nothing. A ray across the wall hits it
     * immediately, from either face. An inward ray from the inner face hits only the opposite side.
     */
    @ParameterizedTest
    @MethodSource("roundPlaces")
    void raysFromEitherWallFace_hitWallOnlyWhenCrossing(Vec3 scale, Vec3 at) {
        int[] faces = new int[2];
        for (Solid.Canonical solid : OPEN) {
            for (double rotation : new double[] {0, 37}) {
                Placement placement = new Placement(new Vec3(at.x() * scale.x(), at.y() * scale.y(), at.z() * scale.z()),
                        new Vec3(rotation, 2 * rotation, -rotation), scale);
                checkSurface(solid, placement, Vec3.ZERO,
                        (geometry, from, normal) -> castFromWall(placement, geometry, from, normal, faces));
            }
        }
        assertThat(faces[0]).as("points on outer faces").isGreaterThan(POINTS);
        assertThat(faces[1]).as("points on inner faces").isGreaterThan(POINTS / 10);
        assertThat(acneCount).as("acne among %s rays, %s", rayCount, scale).isZero();
        assertThat(leakCount).as("leaks among %s rays, %s", rayCount, scale).isZero();
    }

    private void castFromWall(Placement placement, Geometry geometry, Vec3 from, Vec3 normal, int[] faces) {
        Vec3 local = placement.directionsToLocal().transformVector(from.minus(placement.position()));
        double ring = Math.hypot(local.x(), local.z());
        if (local.y() < NARROW || local.y() > 1 - NARROW || ring < NARROW) {
            return;
        }
        Vec3 outwards = placement.transform().transformVector(new Vec3(local.x() / ring, 0, local.z() / ring));
        double out = geometry.distance(0, new Ray(from, outwards));
        double in = geometry.distance(0, new Ray(from, outwards.negated()));
        if (normal.dot(outwards) > 0) {
            faces[0]++;
            acneCount += out < SolidGeometry.MISS ? 1 : 0;
            leakCount += in < ring ? 0 : 1;
        } else {
            faces[1]++;
            acneCount += in > ring ? 0 : 1;
            leakCount += out < ring ? 0 : 1;
        }
    }

    /**
     * The precision of the hit is the spacing of doubles at the mirror: 10⁻⁶ of the shape at 10¹⁰. One in a million points,
     * close to an apex or a rim, may be under the other side of it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e7, 1e10})
    void raysFromPointsInDistantMirror_leave(double far) {
        for (Solid.Canonical solid : SOLIDS) {
            Placement placement = new Placement(new Vec3(0.5, -1, -2), new Vec3(37, 74, -37), Vec3.ONE);
            checkSurface(solid, placement, new Vec3(far, 0.6 * far, -0.8 * far),
                    (geometry, from, normal) -> acneCount +=
                            geometry.distance(0, new Ray(from, outwardDirection(normal))) < SolidGeometry.MISS ? 1 : 0);
        }
        assertThat(acneCount).as("acne among %s rays", rayCount).isLessThanOrEqualTo(far <= 1e7 ? 0 : 1 + (int) (rayCount / 1_000_000));
    }

    /** The point has the small coordinates of near objects, and the error of a shape with large ones. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-3, 1e-6})
    void raysFromHugeBallSeenUpClose_leave(double height) {
        Vec3 up = new Vec3(0.48, 0.6, 0.64);
        double radius = 1e8;
        Geometry geometry = Geometry.of(TraceScenes.singleShape(Solid.SPHERE,
                new Placement(up.times(-radius - height), new Vec3(11, 23, 7), Vec3.ONE.times(radius)), Vec3.ZERO, new Vec3(0, 0, -1)));
        for (int n = 0; n < POINTS; n++) {
            Vec3 d = HardRay.direction(random).normalized();
            Ray ray = new Ray(Vec3.ZERO, d.dot(up) > 0 ? d.negated() : d);
            if (geometry.distance(0, ray) < SolidGeometry.MISS) {
                SurfacePoint p = geometry.surface(0, ray);
                Ray leaving = new Ray(new Vec3(p.px(), p.py(), p.pz()), outwardDirection(new Vec3(p.nx(), p.ny(), p.nz())));
                acneCount += geometry.distance(0, leaving) < SolidGeometry.MISS ? 1 : 0;
                rayCount++;
            }
        }
        assertThat(rayCount).isGreaterThan(POINTS / 2);
        assertThat(acneCount).as("acne among %s rays", rayCount).isZero();
    }

    private void checkFromOutside(Vec3 scale, Vec3 at) {
        for (Solid.Canonical solid : SOLIDS) {
            for (double rotation : new double[] {0, 37}) {
                Placement placement = new Placement(new Vec3(at.x() * scale.x(), at.y() * scale.y(), at.z() * scale.z()),
                        new Vec3(rotation, 2 * rotation, -rotation), scale);
                Vec3 middle = placement.transform().transformPoint(CanonicalSolids.center(solid));
                checkSurface(solid, placement, Vec3.ZERO, (geometry, from, normal) -> {
                    acneCount += geometry.distance(0, new Ray(from, outwardDirection(normal))) < SolidGeometry.MISS ? 1 : 0;
                    leakCount += geometry.distance(0, new Ray(from, middle.minus(from))) < SolidGeometry.MISS ? 0 : 1;
                });
            }
        }
    }

    private interface SurfaceCheck {
        void check(Geometry geometry, Vec3 from, Vec3 normal);
    }

    /** Traces rays from a point to points of the shape. */
    private void checkSurface(Solid.Canonical solid, Placement placement, Vec3 eye, SurfaceCheck check) {
        Geometry geometry = Geometry.of(TraceScenes.singleShape(solid, placement, Vec3.ZERO, new Vec3(0, 0, -1)));
        Transform map = placement.transform();
        for (int n = 0; n < POINTS; n++) {
            Ray ray = new Ray(eye, map.transformPoint(HardRay.pointOnSurface(solid, random)).minus(eye).normalized());
            if (geometry.distance(0, ray) < SolidGeometry.MISS) {
                SurfacePoint p = geometry.surface(0, ray);
                check.check(geometry, new Vec3(p.px(), p.py(), p.pz()), new Vec3(p.nx(), p.ny(), p.nz()));
                rayCount++;
            }
        }
    }

    /**
     * Returns a direction on the normal's side: any, and often almost along the surface, as close as a float normal can
     * distinguish its sides.
     */
    private Vec3 outwardDirection(Vec3 normal) {
        Vec3 d = HardRay.direction(random).normalized();
        double cosine = d.dot(normal);
        double lift = random.nextBoolean() ? Math.abs(cosine) : Math.scalb(1.0, -random.nextInt(22));
        Vec3 away = d.minus(normal.times(cosine)).normalized().plus(normal.times(lift));
        return away.dot(normal) > 0 ? away : normal;
    }
}

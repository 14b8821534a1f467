package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.Form;
import lightning.sample.Slow;
import lightning.scene.Placement;
import lightning.scene.Solid;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Rays that leave a shape from a point that was seen on it: acne is a ray that meets the shape it leaves, a leak one
 * that goes into the shape and does not meet it. {@code -Dlightning.points=1000000} takes a million points for
 * each shape and place.
 */
@Slow
class LeavingRaysTest {
    private static final List<Solid.Canonical> SOLIDS = List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.PLANE, Solid.FRUSTUM,
            new Solid.Frustum(2, true));

    /** Their sides are walls. */
    private static final List<Solid.Canonical> OPEN = List.of(new Solid.Cylinder(false), new Solid.Cone(false),
            new Solid.Frustum(0.5, false), new Solid.Frustum(2, false));
    /** Points nearer to a rim or the axis, own units, are left out: what is met there may be another part of the wall. */
    private static final double NARROW = 0.05;

    private static final int POINTS = Integer.getInteger("lightning.points", 10_000);

    /** Scales and where the camera sees the shape, in units of the scale: a float holds the points of all of these. */
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

    /** Those whose walls are round, so that a ray outwards is one along the normal, or leans as the wall does. */
    static Stream<Arguments> roundPlaces() {
        return places().filter(p -> ((Vec3) p.get()[0]).x() == ((Vec3) p.get()[0]).z());
    }

    /** Rooms: their points, and the wedges at their rims, are held by floats too. */
    static Stream<Arguments> rooms() {
        return Stream.of(Arguments.of(Vec3.ONE), Arguments.of(new Vec3(1e6, 1e6, 1e6)), Arguments.of(new Vec3(1e-6, 1e-6, 1e-6)),
                Arguments.of(new Vec3(1, 0.1, 1)), Arguments.of(new Vec3(100, 3, 5)));
    }

    /** Where floats are as far apart as the shape is large, or as it is thick. */
    static Stream<Arguments> farPlaces() {
        return Stream.of(
                Arguments.of(Vec3.ONE, new Vec3(3e4, 1e4, -2e4)),
                Arguments.of(new Vec3(2, 2, 2), new Vec3(148376 / 2.0, 1234 / 2.0, -223423 / 2.0)),
                Arguments.of(new Vec3(1e6, 1e-3, 1e6), new Vec3(1e-6, -1e3, 1e-6)),
                Arguments.of(Vec3.ONE, new Vec3(1e6, -2e6, 1e6)));
    }

    private final Random random = new Random(1);
    private int acne;
    private int leaks;
    private long rays;

    @ParameterizedTest
    @MethodSource("places")
    void raysFromPointsSeenFromOutside_leaveAndEnter(Vec3 scale, Vec3 at) {
        lookFromOutside(scale, at);
        assertThat(acne).as("acne among %s rays, %s", rays, scale).isZero();
        assertThat(leaks).as("leaks among %s rays, %s", rays, scale).isZero();
    }

    /** Beyond what a float holds, one in a million may go wrong. */
    @ParameterizedTest
    @MethodSource("farPlaces")
    void raysFromPointsFarAway_leaveAndEnter(Vec3 scale, Vec3 at) {
        lookFromOutside(scale, at);
        assertThat(acne).as("acne among %s rays, %s", rays, scale).isLessThanOrEqualTo((int) (rays / 1_000_000));
        assertThat(leaks).as("leaks among %s rays, %s", rays, scale).isLessThanOrEqualTo((int) (rays / 1_000_000));
    }

    /** Whoever is inside sees nothing of what is outside, and nothing hides what is inside; where a cone's rim is sharp, one in a million may. */
    @ParameterizedTest
    @MethodSource("rooms")
    void raysFromPointsSeenFromWithin_stayWithin(Vec3 scale) {
        for (Solid.Canonical solid : List.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.FRUSTUM)) {
            for (double turn : new double[] {0, 37}) {
                Vec3 rotate = new Vec3(turn, 2 * turn, -turn);
                Vec3 camera = new Placement(Vec3.ZERO, rotate, scale).transform().point(CanonicalSolids.middle(solid));
                Placement placement = new Placement(camera.negated(), rotate, scale);
                look(solid, placement, Vec3.ZERO, (geometry, from, normal) -> {
                    leaks += geometry.distance(0, new Ray(from, away(normal))) < Form.MISS ? 0 : 1;
                    acne += geometry.distance(0, new Ray(from, from.negated())) < 1 ? 1 : 0;
                });
            }
        }
        assertThat(acne).as("acne among %s rays, %s", rays, scale).isLessThanOrEqualTo((int) (rays / 1_000_000));
        assertThat(leaks).as("leaks among %s rays, %s", rays, scale).isLessThanOrEqualTo((int) (rays / 1_000_000));
    }

    /**
     * A side without caps has two faces. Outwards from the outer one is nothing; across the wall it is met at once, from either face;
     * inwards from the inner one only what stands opposite is met.
     */
    @ParameterizedTest
    @MethodSource("roundPlaces")
    void raysFromEitherFaceOfAWall_meetItWhereTheyCrossItAlone(Vec3 scale, Vec3 at) {
        int[] faces = new int[2];
        for (Solid.Canonical solid : OPEN) {
            for (double turn : new double[] {0, 37}) {
                Placement placement = new Placement(new Vec3(at.x() * scale.x(), at.y() * scale.y(), at.z() * scale.z()),
                        new Vec3(turn, 2 * turn, -turn), scale);
                look(solid, placement, Vec3.ZERO, (geometry, from, normal) -> leaveWall(placement, geometry, from, normal, faces));
            }
        }
        assertThat(faces[0]).as("points on outer faces").isGreaterThan(POINTS);
        assertThat(faces[1]).as("points on inner faces").isGreaterThan(POINTS / 10);
        assertThat(acne).as("acne among %s rays, %s", rays, scale).isZero();
        assertThat(leaks).as("leaks among %s rays, %s", rays, scale).isZero();
    }

    private void leaveWall(Placement placement, Geometry geometry, Vec3 from, Vec3 normal, int[] faces) {
        Vec3 own = placement.directionsBack().vector(from.minus(placement.at()));
        double ring = Math.hypot(own.x(), own.z());
        if (own.y() < NARROW || own.y() > 1 - NARROW || ring < NARROW) {
            return;
        }
        Vec3 outwards = placement.transform().vector(new Vec3(own.x() / ring, 0, own.z() / ring));
        double out = geometry.distance(0, new Ray(from, outwards));
        double in = geometry.distance(0, new Ray(from, outwards.negated()));
        if (normal.dot(outwards) > 0) {
            faces[0]++;
            acne += out < Form.MISS ? 1 : 0;
            leaks += in < ring ? 0 : 1;
        } else {
            faces[1]++;
            acne += in > ring ? 0 : 1;
            leaks += out < ring ? 0 : 1;
        }
    }

    /**
     * The hit is then as inexact as doubles are where the mirror stands: at 10¹⁰ by 10⁻⁶ of the shape, so that one in a
     * million, seen that near to an apex or a rim, may lie under the other side of it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e7, 1e10})
    void raysFromPointsSeenInAFarMirror_leave(double far) {
        for (Solid.Canonical solid : SOLIDS) {
            Placement placement = new Placement(new Vec3(0.5, -1, -2), new Vec3(37, 74, -37), Vec3.ONE);
            look(solid, placement, new Vec3(far, 0.6 * far, -0.8 * far),
                    (geometry, from, normal) -> acne += geometry.distance(0, new Ray(from, away(normal))) < Form.MISS ? 1 : 0);
        }
        assertThat(acne).as("acne among %s rays", rays).isLessThanOrEqualTo(far <= 1e7 ? 0 : 1 + (int) (rays / 1_000_000));
    }

    /** The point has the small coordinates of what is near, and the error of a shape with large ones. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-3, 1e-6})
    void raysFromAHugeBallSeenFromNear_leave(double height) {
        Vec3 up = new Vec3(0.48, 0.6, 0.64);
        double radius = 1e8;
        Geometry geometry = new Geometry(TraceScenes.one(Solid.SPHERE,
                new Placement(up.times(-radius - height), new Vec3(11, 23, 7), Vec3.ONE.times(radius)), Vec3.ZERO, new Vec3(0, 0, -1)));
        for (int n = 0; n < POINTS; n++) {
            Vec3 d = HardRay.direction(random).normalized();
            Ray ray = new Ray(Vec3.ZERO, d.dot(up) > 0 ? d.negated() : d);
            if (geometry.distance(0, ray) < Form.MISS) {
                SurfacePoint p = geometry.surface(0, ray);
                Ray leaving = new Ray(new Vec3(p.px(), p.py(), p.pz()), away(new Vec3(p.nx(), p.ny(), p.nz())));
                acne += geometry.distance(0, leaving) < Form.MISS ? 1 : 0;
                rays++;
            }
        }
        assertThat(rays).isGreaterThan(POINTS / 2);
        assertThat(acne).as("acne among %s rays", rays).isZero();
    }

    private void lookFromOutside(Vec3 scale, Vec3 at) {
        for (Solid.Canonical solid : SOLIDS) {
            for (double turn : new double[] {0, 37}) {
                Placement placement = new Placement(new Vec3(at.x() * scale.x(), at.y() * scale.y(), at.z() * scale.z()),
                        new Vec3(turn, 2 * turn, -turn), scale);
                Vec3 middle = placement.transform().point(CanonicalSolids.middle(solid));
                look(solid, placement, Vec3.ZERO, (geometry, from, normal) -> {
                    acne += geometry.distance(0, new Ray(from, away(normal))) < Form.MISS ? 1 : 0;
                    leaks += geometry.distance(0, new Ray(from, middle.minus(from))) < Form.MISS ? 0 : 1;
                });
            }
        }
    }

    private interface Leaver {
        void leave(Geometry geometry, Vec3 from, Vec3 normal);
    }

    /** Looks from a point at points of the shape. */
    private void look(Solid.Canonical solid, Placement placement, Vec3 eye, Leaver leaver) {
        Geometry geometry = new Geometry(TraceScenes.one(solid, placement, Vec3.ZERO, new Vec3(0, 0, -1)));
        Transform map = placement.transform();
        for (int n = 0; n < POINTS; n++) {
            Ray ray = new Ray(eye, map.point(HardRay.onSurface(solid, random)).minus(eye).normalized());
            if (geometry.distance(0, ray) < Form.MISS) {
                SurfacePoint p = geometry.surface(0, ray);
                leaver.leave(geometry, new Vec3(p.px(), p.py(), p.pz()), new Vec3(p.nx(), p.ny(), p.nz()));
                rays++;
            }
        }
    }

    /**
     * A direction on the normal's side: anywhere, and often almost along the surface, as near to it as a normal
     * made of floats tells its two sides apart.
     */
    private Vec3 away(Vec3 normal) {
        Vec3 d = HardRay.direction(random).normalized();
        double cosine = d.dot(normal);
        double lift = random.nextBoolean() ? Math.abs(cosine) : Math.scalb(1.0, -random.nextInt(22));
        Vec3 away = d.minus(normal.times(cosine)).normalized().plus(normal.times(lift));
        return away.dot(normal) > 0 ? away : normal;
    }
}

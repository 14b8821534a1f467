package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests points and normals against calculations by hand. */
class SurfaceHitTest {
    private static final double H = Math.sqrt(0.5);

    private static SurfacePoint hit(Solid solid, Placement placement, Ray ray) {
        return Geometry.of(TraceScenes.singleShape(solid, placement, Vec3.ZERO, new Vec3(0, 0, -1))).surface(0, ray);
    }

    private static Vec3 normal(SurfacePoint p) {
        return new Vec3(p.nx(), p.ny(), p.nz());
    }

    private static void assertNormal(SurfacePoint p, Vec3 expected) {
        assertThat(normal(p).minus(expected).maxAbs()).as("%s instead of %s", normal(p), expected).isLessThan(1e-6);
    }

    /** Origins straight outside a point of the surface and straight inside: the normal faces the ray. */
    @ParameterizedTest
    @CsvSource({"0, 0.6,0,0.8, 0.6,0,0.8", "0, 0,-1,0, 0,-1,0", "1, 0.5,0.5,0, 1,1,0", "1, 0,0.25,-0.75, 0,1,-1", "1, 0.3,0,0.2, 0,-1,0",
        "2, 0.6,0.3,0.8, 0.6,0,0.8", "2, 0.2,1,0.3, 0,1,0", "2, 0.2,0,0.3, 0,-1,0", "3, 0.1,0,0.2, 0,1,0",
        "4, 0.75,0.5,0, 1,0.5,0", "4, 0.3,1,0.2, 0,1,0", "4, 0.3,0,0.2, 0,-1,0"})
    void normal_isPerpendicularToSurface_andFacesRay(int kind, double x, double y, double z, double nx, double ny, double nz) {
        Vec3 out = new Vec3(nx, ny, nz).normalized();
        for (double side : new double[] {1, -1}) {
            Vec3 towards = out.times(side);
            Vec3 slanted = towards.plus(new Vec3(0.02, -0.03, 0.01)).normalized();
            SurfacePoint p = hit(CanonicalSolids.BASIC.get(kind), Placement.IDENTITY,
                    new Ray(new Vec3(x, y, z).plus(slanted.times(0.125)), slanted.negated()));
            assertNormal(p, towards);
            Vec3 at = new Vec3(p.px(), p.py(), p.pz());
            assertThat(at.minus(new Vec3(x, y, z)).maxAbs()).isLessThan(1e-6);
            assertThat(at.minus(new Vec3(x, y, z)).dot(towards)).as("off the surface").isGreaterThanOrEqualTo(0);
        }
    }

    /** Uses a ball with semi-axes 2, 3, 5: its normal is the gradient of x²/4 + y²/9 + z²/25 under any rotation. */
    @ParameterizedTest
    @CsvSource({"0,0,0", "90,0,0", "10,20,30"})
    void stretchedBall_hasGradientNormal(double rx, double ry, double rz) {
        Placement placement = new Placement(new Vec3(7, -4, 11), new Vec3(rx, ry, rz), new Vec3(2, 3, 5));
        Vec3 local = new Vec3(2 / 7.0, 3 / 7.0, 6 / 7.0);
        Vec3 gradient =
                lightning.base.math.Transform.rotation(placement.rotation())
                        .transformVector(new Vec3(local.x() / 2, local.y() / 3, local.z() / 5))
                        .normalized();
        Vec3 at = placement.transform().transformPoint(local);
        assertNormal(hit(Solid.SPHERE, placement, new Ray(at.plus(gradient), gradient.negated())), gradient);
    }

    /** Tests random views of every kind of surface: the normal has length 1 and faces the ray, even at grazing angles. */
    @Test
    void normal_alwaysFacesTheRay() {
        Random random = new Random(1);
        for (int n = 0; n < 50_000; n++) {
            Solid.Canonical solid = CanonicalSolids.ALL.get(n % CanonicalSolids.ALL.size());
            Ray ray = HardRay.values()[random.nextInt(HardRay.values().length)].create(solid, random);
            Geometry geometry = Geometry.of(TraceScenes.singleShape(solid, Placement.IDENTITY, Vec3.ZERO, new Vec3(0, 0, -1)));
            if (geometry.distance(0, ray) < SolidGeometry.MISS) {
                Vec3 normal = normal(geometry.surface(0, ray));
                assertThat(normal.length()).isCloseTo(1, within(1e-6));
                assertThat(normal.dot(ray.direction())).as("%s", ray).isLessThanOrEqualTo(1e-7);
            }
        }
    }

    @Test
    void openSolidInterior_normalFacesViewer() {
        assertNormal(hit(new Solid.Cylinder(false), Placement.IDENTITY, new Ray(new Vec3(0, 3, 0), new Vec3(0.4, -1, 0))),
                new Vec3(-1, 0, 0));
        assertNormal(hit(new Solid.Cone(false), Placement.IDENTITY, new Ray(new Vec3(0.5, -1, 0), new Vec3(0, 1, 0))),
                new Vec3(-1, -1, 0).normalized());
    }

    /** The side has no normal there. */
    @Test
    void coneApex_normalFacesRay() {
        assertNormal(hit(Solid.CONE, Placement.IDENTITY, new Ray(new Vec3(0, 3, 0), new Vec3(0, -1, 0))), Vec3.Y);
        assertNormal(hit(Solid.CONE, Placement.IDENTITY, new Ray(new Vec3(1, 3, 0), new Vec3(-0.5, -1, 0))),
                new Vec3(0.5, 1, 0).normalized());
    }

    /** If side and cap are equally near, the side counts: the rim of a cylinder, the edge of a cone. */
    @Test
    void rim_belongsToSide() {
        assertThat(CanonicalSolids.isSide(Solid.CYLINDER, 1, 1, 0)).isTrue();
        assertThat(CanonicalSolids.isSide(Solid.CYLINDER, 0, 0, 1)).isTrue();
        assertThat(CanonicalSolids.isSide(Solid.CYLINDER, 0.75, 0.25, 0)).as("equally near to side and cap").isTrue();
        assertThat(CanonicalSolids.isSide(Solid.CYLINDER, 0.5, 0.25, 0)).isFalse();
        assertThat(CanonicalSolids.isSide(Solid.CYLINDER, 0.5, 0.75, 0)).isFalse();
        assertThat(CanonicalSolids.isSide(Solid.CONE, 1, 0, 0)).isTrue();
        assertThat(CanonicalSolids.isSide(Solid.CONE, 0.5, 0.25, 0)).as("equally near to side and base").isTrue();
        assertThat(CanonicalSolids.isSide(Solid.CONE, 0.25, 0.25, 0)).isFalse();
    }

    /** From the camera, the shape is a single double: its inverse transform has no correct digits. */
    @Test
    void shapeSmallerThanDoubleSpacing_normalFacesRay() {
        double far = 0x1p39;
        double size = 0x1p-29;
        Placement placement = new Placement(new Vec3(0, 0, -far), Vec3.ZERO, new Vec3(size, size, size));
        PrimitiveTable table = Geometry.of(TraceScenes.singleShape(Solid.SPHERE, placement, Vec3.ZERO, new Vec3(0, 0, -1))).primitives();
        SurfaceHit surface = new SurfaceHit();
        surface.compute(table, 0, 0, 0, far, 0, 0, -1, -1, far);
        assertThat(new Vec3(surface.nx, surface.ny, surface.nz).minus(new Vec3(0, H, H)).maxAbs()).isLessThan(1e-7);
    }

    /** The offset is twice Σ|n·p|·2⁻²⁴ for the floats, plus 2⁻⁴⁶ of the coordinates of origin and shape for the hit. */
    @Test
    void storedPoint_isOffsetByErrorBound() {
        Placement wall = new Placement(new Vec3(0, 0, -1000), new Vec3(90, 0, 0), new Vec3(1e9, 1, 1e9));
        SurfacePoint near = hit(Solid.PLANE, wall, new Ray(Vec3.ZERO, new Vec3(0, 0, -1)));
        assertThat(near.pz()).isEqualTo((float) (-1000 + 1000 * 0x1p-23 + 5e8 * 0x1p-46));
        double far = 0x1p40;
        SurfacePoint mirrored = hit(Solid.PLANE, wall, new Ray(new Vec3(0, 0, far), new Vec3(0, 0, -1)));
        assertThat((double) mirrored.pz()).isCloseTo(-1000 + 1000 * 0x1p-23 + (5e8 + far) * 0x1p-46, within(1e-4));
    }

    /** Checks V + 2|N·V|N: the angle of reflection equals that of incidence, and the ray has length 1. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 30, 60, 89})
    void reflectedRay_leavesAtAngleOfIncidence(double degrees) {
        double s = Math.sin(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        Vec3 u = new Vec3(H, 0, H);
        Vec3 v = u.times(s).plus(new Vec3(0, -c, 0));
        SurfacePoint p =
                new SurfacePoint(0, 0, 2, 3, 5, 0, 1, 0, (float) v.x(), (float) v.y(), (float) v.z(), new float[3], new float[3], 0,
                        new float[3], null, null);
        Ray mirrored = p.reflectedRay();
        assertThat(mirrored.origin()).isEqualTo(new Vec3(2, 3, 5));
        assertThat(mirrored.direction().minus(u.times(s).plus(new Vec3(0, c, 0))).maxAbs()).isLessThan(1e-6);
        assertThat(mirrored.direction().length()).isCloseTo(1, within(1e-15));
    }

    /** Uses N = (2, 3, 6)/7 and V against each axis: V + 2·|N·V|·N in forty-ninths. */
    @ParameterizedTest
    @CsvSource({"-1,0,0, -41,12,24", "0,-1,0, 12,-31,36", "0,0,-1, 24,36,23"})
    void reflectedRay_matchesHandCalculation(float vx, float vy, float vz, double rx, double ry, double rz) {
        SurfacePoint p =
                new SurfacePoint(0, 0, 0, 0, 0, 2 / 7f, 3 / 7f, 6 / 7f, vx, vy, vz, new float[3], new float[3], 0, new float[3], null,
                        null);
        assertThat(p.reflectedRay().direction().minus(new Vec3(rx, ry, rz).times(1 / 49.0)).maxAbs()).isLessThan(1e-6);
    }

    /** A normal that by rounding does not face the ray must not reflect it into the surface. */
    @Test
    void reflectedRay_alwaysLeavesSurface() {
        SurfacePoint p =
                new SurfacePoint(0, 0, 0, 0, 0, 0.6f, 0.8f, 0, 0.8f, -0.59999996f, 1e-7f, new float[3], new float[3], 0, new float[3], null,
                        null);
        assertThat(0.6f * 0.8f + 0.8f * -0.59999996f).as("N·V").isPositive();
        assertThat(p.reflectedRay().direction().dot(new Vec3(0.6f, 0.8f, 0))).isPositive();
        SurfacePoint slanted =
                new SurfacePoint(0, 0, 0, 0, 0, 0, 0.6f, -0.8f, 0.28f, 0.768f, 0.576f, new float[3], new float[3], 0, new float[3], null,
                        null);
        Ray mirrored = slanted.reflectedRay();
        assertThat(mirrored.direction().dot(new Vec3(0, 0.6f, -0.8f))).isGreaterThanOrEqualTo(0);
    }
}

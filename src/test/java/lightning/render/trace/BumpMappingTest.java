package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.SampleMeshes;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

/** Tests normals bent by bump and normal maps against calculations by hand. */
class BumpMappingTest {
    private static final Vec3 EYE = new Vec3(0.3, 20, 30);
    /** Rises by 1 from left to right, except at its edge. */
    private static final Texture RAMP_U = heights(4, 1, 0, 0.25f, 0.5f, 0.75f);
    /** Rises by 1 from its bottom to its top, except at its edge. */
    private static final Texture RAMP_V = heights(1, 4, 0.75f, 0.5f, 0.25f, 0);

    @Example
    void rampAlongUOnSquare_tiltsNormalAgainstU() {
        BumpMapping relief = bump(RAMP_U, 0.5);
        // Two units wide, so it rises by a quarter per unit.
        assertNormal(plane(relief, 2), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0), new Vec3(-0.25, 1, 0));
    }

    @Example
    void rampAlongVOnSquare_tiltsNormalAgainstV() {
        assertNormal(plane(bump(RAMP_V, 0.5), 2), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0), new Vec3(0, 1, -0.25));
    }

    @Example
    void rampSeenFromBehind_isInverted() {
        assertNormal(plane(bump(RAMP_U, 0.5), 2), new Vec3(0.01, -5, 0.02), new Vec3(0, 1, 0), new Vec3(0.25, -1, 0));
    }

    @Example
    void rampRepeatedMinusTwice_isTwiceAsSteepInReverse() {
        BumpMapping relief = new BumpMapping(Optional.of(new TextureMap("a.png", -2, 1, RAMP_U)), 0.5, Optional.empty(), 1);
        assertNormal(plane(relief, 2), new Vec3(-0.49, 5, 0.02), new Vec3(0, -1, 0), new Vec3(0.5, 1, 0));
    }

    /** The image shows its u where the surface has its v. */
    @Example
    void rampTurnedByQuarter_tiltsAgainstV() {
        BumpMapping relief =
                new BumpMapping(Optional.of(new TextureMap("a.png", 1, 1, RAMP_U).withPlacement(new TexturePlacement(0, 0.25, -90))),
                        0.5, Optional.empty(), 1);
        assertNormal(plane(relief, 2), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0), new Vec3(0, 1, -0.25));
    }

    @Example
    void rampAlongUOnBall_tiltsByLongitude() {
        Scene ball = scene(Solid.SPHERE, bump(RAMP_U, 1.5), new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(3, 3, 3)));
        assertNormal(ball, new Vec3(0, 0, 9), new Vec3(0, 0, -1), new Vec3(-1.5 / (2 * Math.PI * 3), 0, 1));
    }

    @Example
    void rampAlongVOnBall_tiltsByLatitude() {
        Scene ball = scene(Solid.SPHERE, bump(RAMP_V, 1.5), new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(3, 3, 3)));
        assertNormal(ball, new Vec3(0, 0, 9), new Vec3(0, 0, -1), new Vec3(0, -1.5 / (Math.PI * 3), 1));
    }

    @Example
    void rampAlongVOnCylinder_tiltsByHeight() {
        Scene drum = scene(new Solid.Cylinder(true), bump(RAMP_V, 0.5), new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1, 4, 1)));
        assertNormal(drum, new Vec3(0, 2.01, 9), new Vec3(0, 0, -1), new Vec3(0, -0.125, 1));
    }

    @Example
    void rampOnTriangle_tiltsByTextureCoordinates() {
        // u along x, v along −z: half an image per unit.
        Mesh mesh = new Mesh(new float[] {-1, 0, 1, 1, 0, 1, -1, 0, -1}, new int[] {0, 1, 2}, null, new float[] {0, 0, 1, 0, 0, 1}, null);
        Scene scene = scene(new Solid.TriangleMesh("a.ply", "", true, mesh), bump(RAMP_U, 0.5), Placement.IDENTITY);
        assertNormal(scene, new Vec3(-0.01, 5, 0.02), new Vec3(0, -1, 0), new Vec3(-0.25, 1, 0));
    }

    @Example
    void tiltedNormalMapOnSquare_tiltsAlongUAndV() {
        assertNormal(plane(normals(0.6f, 0, 0.8f, 1), 2), new Vec3(0.1, 5, 0.1), new Vec3(0, -1, 0), new Vec3(0.6, 0.8, 0));
        assertNormal(plane(normals(0, 0.6f, 0.8f, 1), 2), new Vec3(0.1, 5, 0.1), new Vec3(0, -1, 0), new Vec3(0, 0.8, 0.6));
    }

    @Example
    void tiltedNormalMapOnMirroredBall_tiltsAlongU() {
        Placement mirrored = new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(-1, 1, 1));
        assertNormal(scene(Solid.SPHERE, normals(0.6f, 0, 0.8f, 1), mirrored), new Vec3(0, 0, 9), new Vec3(0, 0, -1),
                new Vec3(-0.6, 0, 0.8));
        assertNormal(scene(Solid.SPHERE, normals(0, 0.6f, 0.8f, 1), mirrored), new Vec3(0, 0, 9), new Vec3(0, 0, -1),
                new Vec3(0, 0.6, 0.8));
    }

    /** Normal maps do not contain such pixels, but photographs do. */
    @Example
    void normalPointingIntoSurface_isBentTowardViewer() {
        SurfacePoint at =
                Geometry.of(plane(normals(0, 0, -1, 1), 2)).surface(0, new Ray(new Vec3(0.1, 5, 0.1).minus(EYE), new Vec3(0, -1, 0)));
        assertThat(at.ny()).isPositive();
        NormalSteps steps = normalSteps(plane(normals(0.6f, 0, -0.8f, 1), 2), new Vec3(0.1, 5, 0.1), new Vec3(0, -1, 0));
        assertThat(steps.bumped().minus(new Vec3(0.6, -0.8, 0)).maxAbs()).isLessThan(1e-7);
        assertThat(steps.isBent()).isTrue();
    }

    /** Tangents as from the coordinates, rotated by 90 degrees, and with the other handedness. */
    @Example
    void meshTangents_orientNormalMap() {
        Vec3 from = new Vec3(-0.01, 5, 0.02);
        Vec3 down = new Vec3(0, -1, 0);
        assertNormal(tiltedNormalMap(1, 0, 0, 1, Placement.IDENTITY), from, down, new Vec3(0.48, 0.8, -0.36));
        assertNormal(tiltedNormalMap(0, 0, -1, 1, Placement.IDENTITY), from, down, new Vec3(-0.36, 0.8, -0.48));
        assertNormal(tiltedNormalMap(1, 0, 0, -1, Placement.IDENTITY), from, down, new Vec3(0.48, 0.8, 0.36));
    }

    /** A tangent is stretched like the surface; a mirrored mesh shows a mirrored image. */
    @Example
    void placedMeshTangents_followPlacement() {
        float half = (float) Math.sqrt(0.5);
        Placement stretched = new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(4, 1, 3));
        Vec3 t = new Vec3(4, 0, -3).normalized();
        Vec3 b = Vec3.Y.cross(t);
        assertNormal(tiltedNormalMap(half, 0, -half, 1, stretched), new Vec3(-0.01, 5, 0.02), new Vec3(0, -1, 0),
                t.times(0.48).plus(b.times(0.36)).plus(new Vec3(0, 0.8, 0)));
        Placement mirrored = new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(-1, 1, 1));
        assertNormal(tiltedNormalMap(1, 0, 0, 1, mirrored), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0), new Vec3(-0.48, 0.8, -0.36));
    }

    @Example
    void zeroTangents_fallBackToTextureCoordinates() {
        assertNormal(tiltedNormalMap(0, 0, 0, 1, Placement.IDENTITY), new Vec3(-0.01, 5, 0.02), new Vec3(0, -1, 0),
                new Vec3(0.48, 0.8, -0.36));
        assertNormal(tiltedNormalMap(0, 1, 0, 1, Placement.IDENTITY), new Vec3(-0.01, 5, 0.02), new Vec3(0, -1, 0),
                new Vec3(0.48, 0.8, -0.36));
    }

    @Example
    void strength_scalesTilt() {
        assertNormal(plane(normals(0.6f, 0, 0.8f, 0.5), 2), new Vec3(0.1, 5, 0.1), new Vec3(0, -1, 0), new Vec3(0.3, 0.8, 0));
    }

    @Example
    void normalSteps_areGeometricAndMappedNormals() {
        NormalSteps steps = normalSteps(plane(bump(RAMP_U, 0.5), 2), new Vec3(0.01, -5, 0.02), new Vec3(0, 1, 0));
        assertThat(steps.geometric().minus(new Vec3(0, -1, 0)).maxAbs()).isLessThan(1e-15);
        assertThat(steps.bumped().minus(new Vec3(0.25, -1, 0).normalized()).maxAbs()).isLessThan(1e-15);
        assertThat(steps.smooth()).isNull();
        assertThat(steps.isBent()).isFalse();
        assertThat(steps.lift()).isZero();
    }

    @Example
    void plainSurface_hasNoNormalSteps() {
        assertThat(normalSteps(plane(BumpMapping.NONE, 2), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0))).isNull();
        assertThat(normalSteps(plane(bump(heights(2, 2, 0.5f, 0.5f, 0.5f, 0.5f), 9), 2), new Vec3(0.01, 5, 0.02), new Vec3(0, -1, 0)))
                .isNull();
    }

    /** A reflection on that slope would point below the square. */
    @Example
    void steepSlopeAtGrazingAngle_isReportedAsBent() {
        Scene scene = plane(normals(0.6f, 0, 0.8f, 1), 2);
        Vec3 from = new Vec3(-5, 1, 0);
        Vec3 direction = new Vec3(5, -1, 0).normalized();
        NormalSteps steps = normalSteps(scene, from, direction);
        assertThat(steps.isBent()).isTrue();
        assertThat(steps.bumped().minus(new Vec3(0.6, 0.8, 0)).maxAbs()).isLessThan(1e-7);
        SurfacePoint at = Geometry.of(scene).surface(0, new Ray(from.minus(EYE), direction));
        assertThat(at.nx()).isLessThan(0.2f);
        assertThat(normalSteps(scene, new Vec3(0.1, 5, 0), new Vec3(0, -1, 0)).isBent()).isFalse();
    }

    @Example
    void smoothMeshSteps_startWithInterpolatedNormal() {
        Scene scene = scene(SampleMeshes.solid(SampleMeshes.ball(6, 9, true)), bump(RAMP_U, 0.2), Placement.IDENTITY);
        NormalSteps steps = normalSteps(scene, new Vec3(0.03, 0.21, 9), new Vec3(0, 0, -1));
        // A ball's normals point away from its center; the triangle is flat.
        Vec3 out = new Vec3(0.03, 0.21, Math.sqrt(1 - 0.03 * 0.03 - 0.21 * 0.21));
        assertThat(steps.smooth().dot(out)).isGreaterThan(Math.cos(Math.toRadians(4)));
        assertThat(steps.geometric().dot(steps.smooth())).isBetween(0.9, 1 - 1e-6);
        assertThat(steps.bumped().minus(steps.smooth()).maxAbs()).isGreaterThan(1e-3);
        assertThat(steps.lift()).isPositive();
    }

    @Property(tries = 100)
    void flatImages_changeNoBit(@ForAll @DoubleRange(min = -0.9, max = 0.9) double x, @ForAll @DoubleRange(min = -0.9,
            max = 0.9) double y, @ForAll @DoubleRange(min = -40, max = 0) double exponent) {
        Placement placed = new Placement(new Vec3(1, 0.2, 0), new Vec3(10, 20, 30), new Vec3(2, 3, 4));
        Ray ray = new Ray(new Vec3(1 + x, 0.2 + y, 20).minus(EYE), new Vec3(0.01, 0.02, -1).normalized());
        float h = (float) Math.pow(10, exponent);
        SurfacePoint smooth = Geometry.of(scene(Solid.SPHERE, BumpMapping.NONE, placed)).surface(0, ray);
        assertThat(hasSameBits(smooth, Geometry.of(scene(Solid.SPHERE, bump(heights(2, 2, h, h, h, h), 5), placed)).surface(0, ray)))
                .isTrue();
        assertThat(hasSameBits(smooth, Geometry.of(scene(Solid.SPHERE, normals(0, 0, 1, 5), placed)).surface(0, ray))).isTrue();
    }

    /** The surface itself blocks the light, however steep the bumps are. */
    @Property(tries = 30)
    void lightBelowSurface_contributesNothing(@ForAll @DoubleRange(min = -9, max = 9) double exponent) {
        double height = Math.pow(10, exponent);
        BumpMapping relief = new BumpMapping(Optional.of(new TextureMap("a.png", 3, 5, RAMP_U)), height,
                Optional.of(new TextureMap("b.png", 7, 3, heights(2, 2, 0.1f, 0.9f, 0.8f, 0.3f))), 2);
        Vec3 light = new Vec3(4, 3, -6);
        Scene scene = scene(Solid.SPHERE, relief, new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(2, 2, 2)))
                .withWorld(new World(0, new Rgb(0, 0, 0))).withPicture(new PictureSettings(24, 24, 0))
                .withCamera(new Camera(new Vec3(0, 0, 9), Vec3.ZERO, new Vec3(0, 1, 0), 28))
                .withLights(List.of(Light.of("sun", LightType.POINT).withPosition(light)));
        Geometry smooth = Geometry.of(scene.withMaterials(List.of(Material.of("m"))));
        ReferenceTracer tracer = new ReferenceTracer(scene);
        int seen = 0;
        for (int i = 0; i < 24 * 24; i++) {
            Ray ray = new PixelRays(scene).ray(i % 24, i / 24);
            if (BruteForce.nearest(smooth, ray) >= 0) {
                SurfacePoint at = BruteForce.surface(smooth, 0, ray);
                Vec3 way = light.minus(smooth.toScene(new Vec3(at.px(), at.py(), at.pz())));
                if (way.normalized().dot(new Vec3(at.nx(), at.ny(), at.nz())) < -1e-3) {
                    seen++;
                    assertThat(tracer.pixel(i % 24, i / 24)).containsExactly(0, 0, 0);
                }
            }
        }
        assertThat(seen).isGreaterThan(100);
    }

    /** Creates a triangle with coordinates u along x, v along −z, and a normal that leans by 0.48 along u and 0.36 along v. */
    private static Scene tiltedNormalMap(float x, float y, float z, float hand, Placement placement) {
        float[] tangents = {x, y, z, hand, x, y, z, hand, x, y, z, hand};
        Mesh mesh = new Mesh(new float[] {-1, 0, 1, 1, 0, 1, -1, 0, -1}, new int[] {0, 1, 2}, new float[] {0, 1, 0, 0, 1, 0, 0, 1, 0},
                new float[] {0, 0, 1, 0, 0, 1}, null, tangents);
        return scene(new Solid.TriangleMesh("a.glb", "", true, mesh), normals(0.48f, 0.36f, 0.8f, 1), placement);
    }

    private static NormalSteps normalSteps(Scene scene, Vec3 from, Vec3 direction) {
        return Geometry.of(scene).normalSteps(0, new Ray(from.minus(EYE), direction));
    }

    private static boolean hasSameBits(SurfacePoint a, SurfacePoint b) {
        return a.nx() == b.nx() && a.ny() == b.ny() && a.nz() == b.nz() && a.px() == b.px() && a.py() == b.py() && a.pz() == b.pz();
    }

    private static void assertNormal(Scene scene, Vec3 from, Vec3 direction, Vec3 expected) {
        SurfacePoint at = Geometry.of(scene).surface(0, new Ray(from.minus(EYE), direction));
        Vec3 unit = expected.normalized();
        assertThat((double) at.nx()).isCloseTo(unit.x(), within(1e-6));
        assertThat((double) at.ny()).isCloseTo(unit.y(), within(1e-6));
        assertThat((double) at.nz()).isCloseTo(unit.z(), within(1e-6));
    }

    private static Scene plane(BumpMapping relief, double size) {
        return scene(Solid.PLANE, relief, new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(size, 1, size)));
    }

    private static Scene scene(Solid solid, BumpMapping relief, Placement placement) {
        return new Scene(PictureSettings.DEFAULT, new Camera(EYE, Vec3.ZERO, new Vec3(0, 1, 0), 40), World.DEFAULT,
                List.of(Material.of("m").withBumpMapping(relief)), List.of(new Shape(solid, "shape", "m", placement)), List.of());
    }

    private static BumpMapping bump(Texture image, double height) {
        return new BumpMapping(Optional.of(new TextureMap("a.png", 1, 1, image)), height, Optional.empty(), 1);
    }

    private static BumpMapping normals(float x, float y, float z, double strength) {
        Texture image = new Texture(1, 1, new float[] {(x + 1) / 2, (y + 1) / 2, (z + 1) / 2});
        return new BumpMapping(Optional.empty(), 1, Optional.of(new TextureMap("n.png", 1, 1, image)), strength);
    }

    private static Texture heights(int width, int height, float... grey) {
        float[] rgb = new float[3 * grey.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = grey[i / 3];
        }
        return new Texture(width, height, rgb);
    }
}

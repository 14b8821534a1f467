package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import lightning.sample.SampleMeshes;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests surfaces of meshes: against the solids that they approximate, and by the rules of smooth normals. */
class MeshSurfaceTest {
    private static final int SIDE = 96;

    private final Random random = new Random(1);

    private static Scene scene(Solid solid, Placement placement) {
        return new Scene(new PictureSettings(SIDE, SIDE, 1), new Camera(new Vec3(2, 3, 6), new Vec3(0, 0.2, 0), Vec3.Y, 30), World.DEFAULT,
                List.of(),
                List.of(new Shape(solid, "s", "default", placement)), List.of());
    }

    static Stream<Arguments> pairs() {
        return Stream.of(Arguments.of(SampleMeshes.ball(120, 180, true), Solid.SPHERE, 0.03),
                Arguments.of(SampleMeshes.ball(120, 180, false), Solid.SPHERE, 0.03),
                Arguments.of(SampleMeshes.cone(400), Solid.CONE, 0.03));
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void tessellatedSolid_matchesOutlineWithinPixel_andNormalsWithinFacet(Mesh mesh, Solid solid, double facet) {
        Placement placement = new Placement(new Vec3(0.1, -0.2, 0.3), new Vec3(20, 30, 40), new Vec3(1, 1.3, 0.8));
        Scene scene = scene(SampleMeshes.solid(mesh), placement);
        Geometry triangles = Geometry.of(scene);
        Geometry exact = Geometry.of(scene(solid, placement));
        PixelRays eye = new PixelRays(scene);
        boolean[] visible = new boolean[SIDE * SIDE];
        for (int i = 0; i < visible.length; i++) {
            visible[i] = exact.nearest(eye.ray(i % SIDE, i / SIDE)) == 0;
        }
        int both = 0;
        int bent = 0;
        for (int i = 0; i < visible.length; i++) {
            Ray ray = eye.ray(i % SIDE, i / SIDE);
            boolean hit = triangles.nearest(ray) == 0;
            if (hit != visible[i]) {
                assertThat(isOutline(visible, i)).as("pixel %s", i).isTrue();
            } else if (hit) {
                both++;
                SurfacePoint a = triangles.surface(0, ray);
                SurfacePoint b = exact.surface(0, ray);
                double cosine = a.nx() * b.nx() + a.ny() * b.ny() + a.nz() * b.nz();
                bent += cosine > Math.cos(2 * facet) ? 0 : 1;
                assertThat(new Vec3(a.px() - b.px(), a.py() - b.py(), a.pz() - b.pz()).length()).isLessThan(0.2);
            }
        }
        assertThat(both).isGreaterThan(500);
        // At a rim or an edge a ray may hit another side.
        assertThat(bent).isLessThan(both / 50);
    }

    private static boolean isOutline(boolean[] visible, int i) {
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                if (visible[i + dy * SIDE + dx] != visible[i]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns scales, positions and rotations. */
    static Stream<Arguments> places() {
        return Stream.of(Arguments.of(Vec3.ONE, new Vec3(0, 0, -10)), Arguments.of(Vec3.ONE, new Vec3(300, -200, 500)),
                Arguments.of(new Vec3(1e6, 1e6, 1e6), new Vec3(3, 1, -2)), Arguments.of(new Vec3(1e-6, 1e-6, 1e-6), new Vec3(3, 1, -2)),
                Arguments.of(new Vec3(1e6, 1, 1), new Vec3(1e-5, 5, -8)), Arguments.of(new Vec3(1, 1e-3, 1), new Vec3(1, -2e3, 3)));
    }

    @ParameterizedTest
    @MethodSource("places")
    void raysLeavingFlatConvexMesh_doNotHitItAgain(Vec3 scale, Vec3 at) {
        Vec3 place = new Vec3(at.x() * scale.x(), at.y() * scale.y(), at.z() * scale.z());
        int rays = 0;
        int acne = 0;
        for (Mesh mesh : List.of(SampleMeshes.cube(), SampleMeshes.ball(7, 9, false), SampleMeshes.cone(6))) {
            Placement placement = new Placement(place, new Vec3(37, 74, -37), scale);
            Geometry geometry = Geometry.of(TraceScenes.singleShape(SampleMeshes.solid(mesh), placement, Vec3.ZERO, new Vec3(0, 0, -1)));
            for (int n = 0; n < 3000; n++) {
                int v = 3 * random.nextInt(mesh.vertexCount());
                double inwards = random.nextInt(3) == 0 ? 1 : random.nextDouble();
                Vec3 aim = placement.transform()
                        .transformPoint(new Vec3(mesh.positions()[v], mesh.positions()[v + 1], mesh.positions()[v + 2]).times(inwards)
                                .plus(HardRay.direction(random).normalized().times(0.3 * random.nextDouble())));
                Ray ray = new Ray(Vec3.ZERO, aim.normalized());
                if (geometry.nearest(ray) == 0) {
                    SurfacePoint p = geometry.surface(0, ray);
                    Vec3 normal = new Vec3(p.nx(), p.ny(), p.nz());
                    assertThat(normal.dot(ray.direction())).isLessThanOrEqualTo(1e-7);
                    Ray leaving = new Ray(new Vec3(p.px(), p.py(), p.pz()), outwardDirection(normal));
                    acne += geometry.distance(0, leaving) < SolidGeometry.MISS ? 1 : 0;
                    rays++;
                }
            }
        }
        assertThat(rays).isGreaterThan(1000);
        assertThat(acne).as("acne among %s rays", rays).isZero();
    }

    private Vec3 outwardDirection(Vec3 normal) {
        Vec3 d = HardRay.direction(random).normalized();
        double cosine = d.dot(normal);
        double lift = random.nextBoolean() ? Math.abs(cosine) : Math.scalb(1.0, -random.nextInt(22));
        Vec3 away = d.minus(normal.times(cosine)).normalized().plus(normal.times(lift));
        return away.dot(normal) > 0 ? away : normal;
    }

    /** A coarse round body is lit up to where its smooth normals turn away from the light, and no facet shadows another. */
    @Test
    void smoothRoundMesh_castsNoShadowOnItself() {
        Geometry smooth = Geometry.of(scene(SampleMeshes.solid(SampleMeshes.ball(8, 12, true)), Placement.IDENTITY));
        PixelRays eye = new PixelRays(scene(Solid.SPHERE, Placement.IDENTITY));
        int lit = 0;
        int shaded = 0;
        for (int n = 0; n < 20_000; n++) {
            Ray ray = eye.ray(random.nextInt(SIDE), random.nextInt(SIDE));
            if (smooth.nearest(ray) == 0) {
                SurfacePoint p = smooth.surface(0, ray);
                Vec3 light = outwardDirection(new Vec3(p.nx(), p.ny(), p.nz())).normalized();
                lit++;
                shaded += smooth.isBlocked(new Ray(new Vec3(p.px(), p.py(), p.pz()), light), SolidGeometry.MISS) ? 1 : 0;
            }
        }
        assertThat(lit).isGreaterThan(3000);
        assertThat((double) shaded / lit).isEqualTo(0, within(0.01));
    }

    /** Uses the unit square as two triangles with the plane's coordinates and the same texture. */
    @Test
    void vertexColors_areInterpolated_andMultiplyTexture() {
        float[] v = {0, 0, 0, 4, 0, 0, 0, 4, 0};
        Mesh triangle = new Mesh(v, new int[] {0, 1, 2}, null, null, new float[] {1, 0, 0.5f, 0, 1, 0.5f, 0, 0, 0.5f});
        Ray ray = new Ray(new Vec3(2, 1, 9), new Vec3(0, 0, -1));
        assertThat(point(SampleMeshes.solid(triangle), Optional.empty(), ray).diffuse()).containsExactly(0.25f * 0.8f, 0.5f * 0.8f,
                0.5f * 0.8f);
        TextureMap red = new TextureMap("red.png", 1, 1, new Texture(1, 1, new float[] {0.5f, 0, 0}));
        assertThat(point(SampleMeshes.solid(triangle), Optional.of(red), ray).diffuse()).containsExactly(0.125f * 0.8f, 0, 0);
        assertThat(point(SampleMeshes.solid(triangle).withShowsColors(false), Optional.empty(), ray).diffuse()).containsExactly(0.8f, 0.8f,
                0.8f);
    }

    private static SurfacePoint point(Solid solid, Optional<TextureMap> texture, Ray ray) {
        Material material = Material.of("m").withDiffuse(Rgb.gray(0.8)).withTexture(texture);
        Geometry geometry =
                Geometry.of(new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT,
                        List.of(material), List.of(new Shape(solid, "s", "m", Placement.IDENTITY)), List.of()));
        return geometry.surface(0, ray);
    }

    @Test
    void meshTexture_followsTextureCoordinates() {
        float[] v = {-0.5f, 0, -0.5f, 0.5f, 0, -0.5f, -0.5f, 0, 0.5f, 0.5f, 0, 0.5f};
        Mesh square = new Mesh(v, new int[] {0, 2, 1, 1, 2, 3}, null, new float[] {0, 0, 1, 0, 0, 1, 1, 1}, null);
        float[] rgb = new float[3 * 7 * 5];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat();
        }
        Material painted = Material.of("default").withTexture(Optional.of(new TextureMap("a.png", 2, -3, new Texture(7, 5, rgb))));
        Placement placement = new Placement(Vec3.ZERO, new Vec3(10, 20, 30), new Vec3(4, 1, 4));
        Geometry mesh = Geometry.of(scene(SampleMeshes.solid(square), placement).withMaterials(List.of(painted)));
        Geometry plane = Geometry.of(scene(Solid.PLANE, placement).withMaterials(List.of(painted)));
        PixelRays eye = new PixelRays(scene(Solid.PLANE, placement));
        int visible = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            Ray ray = eye.ray(i % SIDE, i / SIDE);
            if (mesh.nearest(ray) == 0 && plane.nearest(ray) == 0) {
                visible++;
                for (int c = 0; c < 3; c++) {
                    assertThat(mesh.surface(0, ray).texel()[c]).isEqualTo(plane.surface(0, ray).texel()[c], within(1e-4f));
                }
            }
        }
        assertThat(visible).isGreaterThan(1000);
    }

    @Test
    void bentNormals_faceViewer_andReflectAwayFromSurface() {
        for (Mesh mesh : List.of(SampleMeshes.ball(3, 4, true), SampleMeshes.ball(5, 8, true), SampleMeshes.randomTriangles(60, 3),
                SampleMeshes.randomTriangles(60, 6))) {
            Geometry geometry =
                    Geometry.of(scene(SampleMeshes.solid(mesh), new Placement(Vec3.ZERO, new Vec3(10, 20, 30), new Vec3(1, 0.5, 2))));
            Geometry flat = Geometry.of(scene(SampleMeshes.solid(new Mesh(mesh.positions(), mesh.triangles(), null, null, null)),
                    new Placement(Vec3.ZERO, new Vec3(10, 20, 30), new Vec3(1, 0.5, 2))));
            for (int n = 0; n < 3000; n++) {
                Ray ray = new Ray(HardRay.direction(random).times(3), HardRay.direction(random).normalized());
                if (geometry.nearest(ray) == 0) {
                    SurfacePoint p = geometry.surface(0, ray);
                    SurfacePoint g = flat.surface(0, ray);
                    Vec3 v = ray.direction().normalized().negated();
                    Vec3 normal = new Vec3(p.nx(), p.ny(), p.nz());
                    Vec3 face = new Vec3(g.nx(), g.ny(), g.nz());
                    Vec3 mirrored = normal.times(2 * normal.dot(v)).minus(v);
                    assertThat(normal.length()).isEqualTo(1, within(1e-6));
                    assertThat(normal.dot(v)).isGreaterThan(-1e-6);
                    assertThat(mirrored.dot(face)).isGreaterThan(Math.min(0x1p-7, v.dot(face)) - 1e-3);
                }
            }
        }
    }
}

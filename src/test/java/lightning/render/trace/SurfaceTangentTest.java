package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the directions from which the rotation of anisotropic materials counts. */
class SurfaceTangentTest {
    private static final double FLOAT = 1e-6;

    private static SurfacePoint hit(Solid solid, Placement placement, Vec3 from, Vec3 direction) {
        Material brushed = Material.of("m").withModel(ShadingModel.PRINCIPLED).withAnisotropy(new Anisotropy(0.5, 0));
        Camera camera = new Camera(from, direction.plus(from), new Vec3(0.1, 1, 0.3), 40);
        Geometry geometry = Geometry.of(new Scene(PictureSettings.DEFAULT, camera, World.DEFAULT, List.of(brushed),
                List.of(new Shape(solid, "s", "m", placement)), List.of()));
        Ray ray = new Ray(from.minus(camera.origin()), direction.normalized());
        return geometry.surface(geometry.nearest(ray), ray);
    }

    private static Vec3 tangent(Solid solid, Placement placement, Vec3 from, Vec3 direction) {
        SurfacePoint point = hit(solid, placement, from, direction);
        Vec3 tangent = new Vec3(point.tangent()[0], point.tangent()[1], point.tangent()[2]);
        assertThat(tangent.length()).isCloseTo(1, within(FLOAT));
        assertThat(tangent.dot(new Vec3(point.nx(), point.ny(), point.nz()))).isCloseTo(0, within(FLOAT));
        return tangent;
    }

    private static void assertIs(Vec3 tangent, double x, double y, double z) {
        assertThat(tangent.minus(new Vec3(x, y, z)).length()).as("%s", tangent).isLessThan(1e-5);
    }

    @Test
    void solidsOfRevolution_haveTangentsAroundTheirAxis() {
        assertIs(tangent(Solid.SPHERE, Placement.IDENTITY, new Vec3(0, 0, 5), new Vec3(0, 0, -1)), 1, 0, 0);
        assertIs(tangent(Solid.CYLINDER, Placement.IDENTITY, new Vec3(5, 0.5, 0), new Vec3(-1, 0, 0)), 0, 0, -1);
        // The cap of a cylinder is turned, too.
        assertIs(tangent(Solid.CYLINDER, Placement.IDENTITY, new Vec3(0.5, 5, 0), new Vec3(0, -1, 0)), 0, 0, -1);
    }

    @Test
    void plane_hasTangentAlongItsXAxis() {
        assertIs(tangent(Solid.PLANE, new Placement(Vec3.ZERO, new Vec3(0, 90, 0), Vec3.ONE), new Vec3(0.1, 5, 0.2), new Vec3(0, -1, 0)), 0,
                0, -1);
    }

    @Test
    void transformedSolid_takesItsTangentsAlong() {
        // The axis y of the cylinder lies along z of the scene.
        Placement lying = new Placement(Vec3.ZERO, new Vec3(90, 0, 0), new Vec3(2, 1, 1));
        Vec3 tangent = tangent(Solid.CYLINDER, lying, new Vec3(0, 5, 0.5), new Vec3(0, -1, 0));
        assertThat(Math.abs(tangent.x())).isCloseTo(1, within(FLOAT));
    }

    @ParameterizedTest
    @CsvSource({"0, 5, 0", "0, -5, 0"})
    void pole_hasAFixedTangent(double x, double y, double z) {
        assertIs(tangent(Solid.SPHERE, Placement.IDENTITY, new Vec3(x, y, z), new Vec3(-x, -y, -z)), 1, 0, 0);
    }

    private static Mesh quad(float[] uv, float[] normals) {
        return new Mesh(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, new int[] {0, 1, 2, 0, 2, 3}, normals, uv, null);
    }

    private static Vec3 onQuad(float[] uv, float[] normals) {
        return tangent(new Solid.TriangleMesh("q.obj", "", quad(uv, normals)), Placement.IDENTITY, new Vec3(0.3, 0.4, 5),
                new Vec3(0, 0, -1));
    }

    @Test
    void mesh_hasTangentsWhereUGrows() {
        float[] normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
        float[] turned = {0, 0, 0, 1, -1, 1, -1, 0};
        assertIs(onQuad(new float[] {0, 0, 1, 0, 1, 1, 0, 1}, normals), 1, 0, 0);
        assertIs(onQuad(turned, normals), 0, -1, 0);
        assertIs(onQuad(turned, null), 0, -1, 0);
        // u grows along x while v stays, even if v is not perpendicular to it.
        assertIs(onQuad(new float[] {0, 0, 1, 0, 2, 1, 1, 1}, normals), 1, 0, 0);
    }

    @Test
    void meshWithoutTextureCoordinates_hasTangentsAroundTheAxisOfItsBox() {
        // The point is left of the middle of the box, in the plane of the axis.
        Mesh wall = new Mesh(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, -2}, new int[] {0, 1, 2, 0, 2, 3, 0, 1, 4}, null, null,
                null);
        assertIs(tangent(new Solid.TriangleMesh("q.obj", "", wall), Placement.IDENTITY, new Vec3(0.3, 0.4, 5), new Vec3(0, 0, -1)), 1,
                0, 0);
    }

    @Test
    void meshWithOneTextureCoordinate_hasAFixedTangent() {
        assertIs(onQuad(new float[8], null), 1, 0, 0);
    }
}

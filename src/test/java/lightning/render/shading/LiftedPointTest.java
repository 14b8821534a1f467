package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;
import lightning.sample.SampleMeshes;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Photometry;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Triangle in z = 0 around the origin, whose normals lean outwards by 30°. At its center the tangent planes are cos 30° · sin 30°
 * above it. The light is at 45° from that point.
 */
class LiftedPointTest {
    private static final double LEAN = Math.toRadians(30);
    private static final double LIFT = Math.cos(LEAN) * Math.sin(LEAN);
    private static final Vec3 AT = new Vec3(2, 0, LIFT + 2);
    private static final Light LIGHT = Light.of("l", LightType.POINT).withPosition(AT);
    private static final double COSINE = Math.sqrt(0.5);
    private static final double TOLERANCE = 1e-5;

    /** Returns the red of the center, seen from straight above. */
    private static double centerValue(double diffuse, double specular, Light light) {
        float[] positions = new float[9];
        float[] normals = new float[9];
        for (int v = 0; v < 3; v++) {
            double angle = Math.toRadians(120 * v);
            positions[3 * v] = (float) Math.cos(angle);
            positions[3 * v + 1] = (float) Math.sin(angle);
            normals[3 * v] = (float) (Math.sin(LEAN) * Math.cos(angle));
            normals[3 * v + 1] = (float) (Math.sin(LEAN) * Math.sin(angle));
            normals[3 * v + 2] = (float) Math.cos(LEAN);
        }
        Mesh mesh = new Mesh(positions, new int[] {0, 1, 2}, normals, null, null);
        Material material = Material.of("m").withDiffuse(Rgb.gray(diffuse)).withSpecular(Rgb.gray(specular)).withShininess(3);
        return new ReferenceTracer(
                new Scene(new PictureSettings(1, 1, 0), new Camera(new Vec3(0, 0, 9), Vec3.ZERO, Vec3.Y, 1), World.DEFAULT,
                        List.of(material), List.of(new Shape(SampleMeshes.solid(mesh), "s", "m", Placement.IDENTITY)), List.of(light)))
                .trace().red(0, 0);
    }

    @Test
    void cosine_usesLiftedPoint() {
        assertThat(centerValue(1, 0, LIGHT)).isEqualTo(COSINE, within(TOLERANCE));
    }

    @Test
    void distance_usesLiftedPoint() {
        assertThat(centerValue(1, 0, LIGHT.withAttenuation(new Attenuation(0, 0, 1)))).isEqualTo(COSINE / 8, within(TOLERANCE));
    }

    @Test
    void highlight_usesLiftedPoint() {
        assertThat(centerValue(0, 1, LIGHT)).isEqualTo(Math.pow(COSINE, 3), within(TOLERANCE));
    }

    /** The profile is 0 from 45.1° off the axis on: the triangle's own center would be lit. */
    @Test
    void profile_usesDirectionToLiftedPoint() {
        var narrow = new Photometry(Photometry.Type.C, new double[] {0, 44.9}, new double[] {0}, new double[] {1, 1});
        Light light = Light.of("l", LightType.SPOT).withPosition(AT).withDirection(new Vec3(0, 0, -1)).withAngle(90)
                .withProfile(Optional.of(new IesProfile("p.ies", narrow)));
        assertThat(centerValue(1, 0, light)).isZero();
        var wide = new Photometry(Photometry.Type.C, new double[] {0, 45.1}, new double[] {0}, new double[] {1, 1});
        assertThat(centerValue(1, 0, light.withProfile(Optional.of(new IesProfile("p.ies", wide))))).isEqualTo(COSINE, within(TOLERANCE));
    }

    /** The normals of a beveled cube's large faces lean at their corners, but its facets say that they are flat: other bodies lie on them. */
    @Test
    void largeFaceBesideBevel_isNotLifted() {
        Shape cube = new Shape(SampleMeshes.solid(SampleMeshes.beveledCube(0.01)), "s", "m", Placement.IDENTITY);
        Geometry geometry = Geometry.of(new Scene(new PictureSettings(1, 1, 0), new Camera(new Vec3(0, 0, 3), Vec3.ZERO, Vec3.Y, 1),
                World.DEFAULT, List.of(Material.of("m")), List.of(cube), List.of()));
        SurfacePoint middle = geometry.surface(0, new Ray(Vec3.ZERO, new Vec3(0.1, 0.2, -2)));
        assertThat((double) middle.pz()).isCloseTo(1 - 3, within(0.01));
    }
}

package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Texture coordinates of surfaces in a written file. */
class TextureCoordinatesTest {
    private static Scene scene(Solid solid, Placement placement) {
        Scene studio = StudioScene.of(LightType.POINT);
        return studio.withNodes(List.of(new Shape(solid, "shape", "matt", placement)))
                .withCamera(new Camera(new Vec3(0, 5, 0.001), Vec3.ZERO, Vec3.Y, 60));
    }

    /** A plane's coordinates grow from 0 to 1 along x and z; the camera looks down on it. */
    @Test
    void planes_coordinatesFollowItsSides() throws IOException {
        ExrValues file =
                ExrValues.of(scene(Solid.PLANE, new Placement(new Vec3(0.5, 0, 0), Vec3.ZERO, new Vec3(4, 1, 3))), Optional.empty());
        int hits = 0;
        for (int i = 0; i < file.width * file.height; i++) {
            boolean hit = file.channel("shape.id")[i] > 0;
            hits += hit ? 1 : 0;
            assertThat((double) file.channel("uv.U")[i]).isCloseTo(hit ? (file.channel("P.X")[i] - 0.5) / 4 + 0.5 : 0, within(1e-6));
            assertThat((double) file.channel("uv.V")[i]).isCloseTo(hit ? file.channel("P.Z")[i] / 3 + 0.5 : 0, within(1e-6));
        }
        assertThat(hits).isBetween(100, file.width * file.height - 100);
    }

    /** The coordinates of the vertices are an affine map of their positions, which holds at all points. */
    @Test
    void meshes_coordinatesAreThoseOfItsVertices() throws IOException {
        float[] positions = {-2, 0, -2, 2, 0, -2, 2, 0, 2, -2, 0, 2};
        float[] coordinates = new float[8];
        for (int v = 0; v < 4; v++) {
            coordinates[2 * v] = 3 + positions[3 * v] / 2 + positions[3 * v + 2] / 4;
            coordinates[2 * v + 1] = 1 - positions[3 * v + 2];
        }
        Mesh mesh = new Mesh(positions, new int[] {0, 2, 1, 0, 3, 2}, null, coordinates, null);
        ExrValues file = ExrValues.of(scene(new Solid.TriangleMesh("a.obj", "", mesh), Placement.IDENTITY), Optional.empty());
        for (int i = 0; i < file.width * file.height; i++) {
            boolean hit = file.channel("shape.id")[i] > 0;
            double x = file.channel("P.X")[i];
            double z = file.channel("P.Z")[i];
            assertThat((double) file.channel("uv.U")[i]).isCloseTo(hit ? 3 + x / 2 + z / 4 : 0, within(1e-5));
            assertThat((double) file.channel("uv.V")[i]).isCloseTo(hit ? 1 - z : 0, within(1e-5));
        }
    }
}

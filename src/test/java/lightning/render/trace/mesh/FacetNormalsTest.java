package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import lightning.sample.SampleMeshes;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;

/** Tests the mean normals of the facets around vertices. */
class FacetNormalsTest {
    /** Returns the cosine between the means and other directions at a vertex. */
    private static double cosine(float[] means, float[] others, int v) {
        return (double) means[3 * v] * others[3 * v] + (double) means[3 * v + 1] * others[3 * v + 1]
                + (double) means[3 * v + 2] * others[3 * v + 2];
    }

    /** The bevel has less than 2 % of the area around a vertex, and its vertex normal leans by 30° or more. */
    @Test
    void largeFacetBesideBevel_hasItsNormal() {
        Mesh mesh = SampleMeshes.beveledCube(0.01);
        float[] means = FacetNormals.of(mesh);
        for (int v = 0; v < mesh.vertexCount(); v++) {
            assertThat(Math.abs(means[3 * v + v % 3])).as("vertex %d", v).isGreaterThan((float) Math.cos(Math.toRadians(1)));
            assertThat(Math.abs(Objects.requireNonNull(mesh.normals())[3 * v + v % 3])).isLessThan((float) Math.cos(Math.toRadians(30)));
        }
    }

    @Test
    void roundBody_hasItsVertexNormals() {
        Mesh mesh = SampleMeshes.ball(16, 32, true);
        float[] means = FacetNormals.of(mesh);
        for (int v = 0; v < mesh.vertexCount(); v++) {
            assertThat(cosine(means, Objects.requireNonNull(mesh.normals()), v)).as("vertex %d", v)
                    .isGreaterThan(Math.cos(Math.toRadians(4)));
        }
    }

    /** Two triangles of one plane do not tell how the surface bends. */
    @Test
    void facetsOfOnePlane_leaveVertexNormals() {
        float[] normals = {0.6f, 0, 0.8f, 0, 0.6f, 0.8f, -0.6f, 0, 0.8f, 0, -0.6f, 0.8f};
        Mesh mesh = new Mesh(new float[] {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0}, new int[] {0, 1, 2, 0, 2, 3}, normals, null, null);
        assertThat(FacetNormals.of(mesh)).containsExactly(normals);
    }

    /** Vertices that only differ in texture coordinates have the facets of both sides of the seam. */
    @Test
    void seamOfTexture_joinsFacets() {
        float half = (float) Math.sqrt(0.5);
        float[] positions = {0, 0, 0, 0, 0, 1, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, -1, 0};
        float[] normals = {0, 1, 0, 0, 1, 0, half, half, 0, 0, 1, 0, 0, 1, 0, -half, half, 0};
        float[] means = FacetNormals.of(new Mesh(positions, new int[] {0, 1, 2, 3, 5, 4}, normals, null, null));
        assertThat((double) means[0]).isCloseTo(0, within(1e-6));
        assertThat((double) means[1]).isCloseTo(1, within(1e-6));
        assertThat((double) means[9]).isCloseTo(0, within(1e-6));
    }

    @Test
    void trianglesWithoutArea_leaveVertexNormals() {
        float[] normals = {0, 1, 0, 0, 1, 0, 0, 1, 0};
        assertThat(FacetNormals.of(new Mesh(new float[9], new int[] {0, 1, 2}, normals, null, null))).containsExactly(normals);
    }
}

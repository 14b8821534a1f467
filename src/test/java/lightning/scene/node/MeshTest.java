package lightning.scene.node;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

/** Tests the validation of meshes. */
class MeshTest {
    private static final float[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    private static final int[] ONE = {0, 1, 2};

    @Test
    void mesh_countsVerticesAndTriangles() {
        Mesh mesh = new Mesh(new float[12], new int[] {0, 1, 2, 3, 3, 3}, null, null, null);
        assertThat(mesh.vertexCount()).isEqualTo(4);
        assertThat(mesh.triangleCount()).isEqualTo(2);
    }

    @Test
    void emptyMesh_isValid() {
        assertThat(new Mesh(new float[0], new int[0], new float[0], new float[0], new float[0]))
                .hasToString("mesh of 0 triangles over 0 vertices");
    }

    @Test
    void equality_comparesAllArrays() {
        Mesh mesh = new Mesh(CORNERS, ONE, null, new float[6], null);
        assertThat(mesh).isEqualTo(new Mesh(CORNERS.clone(), ONE.clone(), null, new float[6], null)).isNotEqualTo(flat(CORNERS, ONE))
                .hasSameHashCodeAs(new Mesh(CORNERS.clone(), ONE.clone(), null, new float[6], null));
    }

    @Test
    void vertexWithTwoNumbers_isRejected() {
        assertRejected(() -> flat(new float[8], ONE), "positions must be three numbers for each vertex, were 8 numbers");
    }

    @Test
    void triangleWithTwoVertices_isRejected() {
        assertRejected(() -> flat(CORNERS, new int[2]), "triangles must have three vertices each, were 2 vertices");
    }

    @Test
    void nanPosition_isRejected() {
        assertRejected(() -> flat(new float[] {0, 0, 0, 1, Float.NaN, 0, 0, 1, 0}, ONE),
                "vertex 1: each number of its position must be from -1e12 to 1e12, was NaN");
        assertRejected(() -> flat(new float[] {0, 0, Float.NEGATIVE_INFINITY}, new int[0]),
                "vertex 0: each number of its position must be from -1e12 to 1e12, was -Infinity");
    }

    @Test
    void missingVertex_isRejected() {
        assertRejected(() -> flat(CORNERS, new int[] {0, 1, 3}), "triangle 0: vertices must be from 0 to 2, was 3");
        assertRejected(() -> flat(CORNERS, new int[] {0, 1, 2, 0, -1, 2}), "triangle 1: vertices must be from 0 to 2, was -1");
    }

    @Test
    void normals_mustBeUnitPerVertex() {
        assertThat(new Mesh(CORNERS, ONE, new float[] {1, 0, 0, 0, 0.6f, 0.8f, 0, 0, -1}, null, null).normals()).hasSize(9);
        assertRejected(() -> new Mesh(CORNERS, ONE, new float[6], null, null),
                "normals must be 3 numbers for each of 3 vertices, were 6 numbers");
        assertRejected(() -> new Mesh(CORNERS, ONE, new float[] {1, 0, 0, 0, 0, 0, 0, 0, 1}, null, null),
                "vertex 1: its normal must have length 1, was 0 0 0");
        assertRejected(() -> new Mesh(CORNERS, ONE, new float[] {1, 0, 0, Float.NaN, 0, 0, 0, 0, 1}, null, null),
                "vertex 1: its normal must have length 1, was NaN 0 0");
    }

    @Test
    void textureCoordinates_mustBeTwoPerVertex() {
        assertRejected(() -> new Mesh(CORNERS, ONE, null, new float[9], null),
                "texture coordinates must be 2 numbers for each of 3 vertices, were 9 numbers");
        assertRejected(() -> new Mesh(CORNERS, ONE, null, new float[] {0, 0, 0, 2e6f, 0, 0}, null),
                "vertex 1: each number of its texture coordinate must be from -1000000 to 1000000, was 2000000");
    }

    @Test
    void colors_mustBeThreePerVertex() {
        assertRejected(() -> new Mesh(CORNERS, ONE, null, null, new float[3]),
                "colors must be 3 numbers for each of 3 vertices, were 3 numbers");
        assertRejected(() -> new Mesh(CORNERS, ONE, null, null, new float[] {0, 0, 0, 0, 0, 0, 0, 0, -1}),
                "vertex 2: each number of its color must be from 0 to 1, was -1");
    }

    private static Mesh flat(float[] positions, int[] triangles) {
        return new Mesh(positions, triangles, null, null, null);
    }

    private static void assertRejected(Runnable mesh, String message) {
        assertThatIllegalArgumentException().isThrownBy(mesh::run).withMessage(message);
    }
}

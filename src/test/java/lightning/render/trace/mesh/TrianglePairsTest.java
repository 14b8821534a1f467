package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.sample.SampleMeshes;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;

/** Tests that pairs contain each triangle once, with its vertices in order. */
class TrianglePairsTest {
    private final Random random = new Random(1);

    @Test
    void adjacentTriangles_formPairs() {
        Mesh ball = SampleMeshes.ball(30, 40, true);
        assertThat(singles(ball)).isLessThan(ball.triangleCount() / 20);
    }

    @Test
    void shuffledTriangles_formPairs() {
        Mesh ball = shuffled(SampleMeshes.ball(30, 40, true));
        assertThat(singles(ball)).isLessThan(ball.triangleCount() / 4);
    }

    /** Flat triangles repeat the positions of their vertices. */
    @Test
    void trianglesWithVerticesOfTheirOwn_formPairs() {
        Mesh ball = shuffled(SampleMeshes.ball(30, 40, true));
        float[] position = new float[9 * ball.triangleCount()];
        int[] triangle = new int[3 * ball.triangleCount()];
        for (int i = 0; i < triangle.length; i++) {
            triangle[i] = i;
            System.arraycopy(ball.positions(), 3 * ball.triangles()[i], position, 3 * i, 3);
        }
        assertThat(singles(new Mesh(position, triangle, null, null, null))).isLessThan(ball.triangleCount() / 4);
    }

    /** A common edge is not enough: the strip's second triangle has the opposite order of corners. */
    @Test
    void trianglesOfOppositeOrientation_stayAlone() {
        float[] p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
        assertThat(singles(new Mesh(p, new int[] {0, 1, 2, 1, 2, 3}, null, null, null))).isEqualTo(2);
        assertThat(singles(new Mesh(p, new int[] {0, 1, 2, 2, 1, 3}, null, null, null))).isZero();
    }

    /** Any number of triangles may share an edge. */
    @Test
    void coincidentTriangles_arePairedInLinearTime() {
        int[] t = new int[3 * 200_000];
        for (int i = 0; i < t.length; i++) {
            t[i] = i % 3;
        }
        assertThat(singles(new Mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, t, null, null, null))).isEqualTo(200_000);
    }

    /** Returns a mesh with the same triangles in another order, each with another first vertex. */
    private Mesh shuffled(Mesh mesh) {
        int[] t = mesh.triangles().clone();
        for (int i = mesh.triangleCount() - 1; i >= 0; i--) {
            int j = random.nextInt(i + 1);
            int turn = random.nextInt(3);
            int[] moved = {t[3 * i], t[3 * i + 1], t[3 * i + 2]};
            System.arraycopy(t, 3 * j, t, 3 * i, 3);
            for (int k = 0; k < 3; k++) {
                t[3 * j + k] = moved[(k + turn) % 3];
            }
        }
        return new Mesh(mesh.positions(), t, null, null, null);
    }

    /** Checks the BVH of a mesh, and returns the number of triangles without a partner. */
    private static int singles(Mesh mesh) {
        MeshTree tree = MeshTreeBuilder.build(mesh);
        int[] seen = new int[mesh.triangleCount()];
        for (int i = 0; i < tree.triangle.length; i++) {
            int id = MeshTree.id(tree.triangle[i]);
            if (id < 0) {
                continue;
            }
            seen[id]++;
            for (int k = 0; k < 9; k++) {
                assertThat(tree.vertex[tree.corner(i / MeshTree.WIDTH, i % MeshTree.WIDTH, k / 3) + MeshTree.AXIS_FLOATS * (k % 3)])
                        .isEqualTo(mesh.positions()[3 * mesh.triangles()[3 * id + k / 3] + k % 3]);
            }
        }
        assertThat(seen).containsOnly(1);
        TrianglePairs pairs = TrianglePairs.of(mesh);
        int singles = 0;
        for (int i = 0; i < pairs.count(); i++) {
            singles += pairs.second(i) < 0 ? 1 : 0;
        }
        return singles;
    }
}

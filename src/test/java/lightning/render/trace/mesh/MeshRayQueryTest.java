package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.sample.SampleMeshes;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeshRayQueryTest {
    private final MeshRayQuery query = new MeshRayQuery();
    private final MeshRayQuery bruteForceQuery = new MeshRayQuery();
    private final Random random = new Random(1);

    @Property
    void tree_matchesBruteForce(@ForAll @IntRange(min = 0, max = 200) int triangles, @ForAll long seed) {
        Mesh mesh = SampleMeshes.randomTriangles(triangles, seed);
        MeshSolid solid = new MeshSolid(mesh);
        Random own = new Random(seed);
        for (int n = 0; n < 40; n++) {
            double far = own.nextInt(4) == 0 ? 1e6 : 2;
            double[] o = {far * own.nextGaussian(), own.nextInt(3) == 0 ? 0 : far * own.nextGaussian(), far * own.nextGaussian()};
            double[] to = aim(mesh, own);
            double[] d = {to[0] - o[0], to[1] - o[1], to[2] - o[2]};
            if (own.nextInt(8) == 0) {
                d[own.nextInt(3)] = 0;
            }
            if (d[0] == 0 && d[1] == 0 && d[2] == 0) {
                continue;
            }
            bruteForceQuery.setRay(solid, o[0], o[1], o[2], d[0], d[1], d[2]);
            query.setRay(solid, o[0], o[1], o[2], d[0], d[1], d[2]);
            double expected = bruteForceQuery.nearestBruteForce();
            assertThat(query.nearest(Double.POSITIVE_INFINITY)).isEqualTo(expected);
            assertThat(query.triangle()).isEqualTo(bruteForceQuery.triangle());
            assertThat(query.isBlocked(expected)).isFalse();
            assertThat(query.isBlocked(Math.nextUp(expected))).isEqualTo(expected < Double.POSITIVE_INFINITY);
            if (expected < Double.POSITIVE_INFINITY) {
                assertThat(query.nearest(expected)).isEqualTo(expected);
                assertThat(query.nearest(Math.nextDown(expected))).isEqualTo(Double.POSITIVE_INFINITY);
            }
        }
    }

    /** Returns a vertex, a point on an edge, or any point. */
    static double[] aim(Mesh mesh, Random random) {
        double[] at = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
        if (mesh.triangleCount() > 0 && random.nextInt(4) != 0) {
            int t = 3 * random.nextInt(mesh.triangleCount());
            double share = random.nextInt(3) / 2.0;
            for (int a = 0; a < 3; a++) {
                at[a] = (1 - share) * mesh.positions()[3 * mesh.triangles()[t] + a]
                        + share * mesh.positions()[3 * mesh.triangles()[t + 1] + a];
            }
        }
        return at;
    }

    /** {@code -Dlightning.aimed=2000000} aims as many rays. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-3, 0.999})
    void raysFromInsideAtVerticesAndEdges_neverLeak(double off) {
        int rays = Integer.getInteger("lightning.aimed", 100_000);
        Mesh ball = SampleMeshes.ball(60, 97, false);
        MeshSolid solid = new MeshSolid(ball);
        int lost = 0;
        for (int n = 0; n < rays; n++) {
            double[] o = new double[3];
            for (int a = 0; a < 3; a++) {
                // Within the ball, whose inner radius is at least this.
                o[a] = off * (random.nextDouble() - 0.5) * 1.15;
            }
            int t = 3 * random.nextInt(ball.triangleCount());
            double share = n % 2 == 0 ? 0 : random.nextDouble();
            double[] d = new double[3];
            for (int a = 0; a < 3; a++) {
                d[a] = (1 - share) * ball.positions()[3 * ball.triangles()[t] + a]
                        + share * ball.positions()[3 * ball.triangles()[t + 1] + a]
                        - o[a];
            }
            query.setRay(solid, o[0], o[1], o[2], d[0], d[1], d[2]);
            double hit = query.nearest(Double.POSITIVE_INFINITY);
            lost += hit < Double.POSITIVE_INFINITY ? 0 : 1;
            if (hit < Double.POSITIVE_INFINITY) {
                assertThat(hit).isBetween(1 - 1e-9, 1 + 1e-9);
            }
        }
        assertThat(lost).as("of %s rays", rays).isZero();
    }

    /** Seen edge-on a triangle is a line, and depth differences of its vertices are noise; the hit must still be next to it. */
    @Test
    void edgeOnTriangles_areHitInsideTheirBoxes() {
        int hit = 0;
        for (int n = 0; n < 30_000; n++) {
            float[] v = new float[9];
            for (int k = 0; k < 9; k++) {
                v[k] = (float) random.nextGaussian();
            }
            MeshSolid solid = new MeshSolid(new Mesh(v, new int[] {0, 1, 2}, null, null, null));
            double[] from = pointInPlane(v, 5 * random.nextGaussian(), 5 * random.nextGaussian());
            double near = random.nextInt(2) * Math.pow(10, -6 * random.nextDouble());
            double[] to = pointInPlane(v, near, near * random.nextDouble());
            query.setRay(solid, from[0], from[1], from[2], to[0] - from[0], to[1] - from[1], to[2] - from[2]);
            double t = query.nearest(Double.POSITIVE_INFINITY);
            if (t < Double.POSITIVE_INFINITY) {
                hit++;
                for (int a = 0; a < 3; a++) {
                    double x = from[a] + t * (to[a] - from[a]);
                    assertThat(x).isBetween(Math.min(v[a], Math.min(v[3 + a], v[6 + a])) - 1e-12,
                            Math.max(v[a], Math.max(v[3 + a], v[6 + a])) + 1e-12);
                }
            }
        }
        assertThat(hit).isGreaterThan(3000);
    }

    private static double[] pointInPlane(float[] v, double along, double across) {
        double[] p = new double[3];
        for (int a = 0; a < 3; a++) {
            p[a] = v[a] + along * ((double) v[3 + a] - v[a]) + across * ((double) v[6 + a] - v[a]);
        }
        return p;
    }

    @Test
    void equalDistances_lowestTriangleWins() {
        Mesh ball = SampleMeshes.ball(4, 5, false);
        int[] twice = new int[2 * ball.triangles().length];
        System.arraycopy(ball.triangles(), 0, twice, 0, twice.length / 2);
        System.arraycopy(ball.triangles(), 0, twice, twice.length / 2, twice.length / 2);
        MeshSolid solid = new MeshSolid(new Mesh(ball.positions(), twice, null, null, null));
        for (int n = 0; n < 1000; n++) {
            query.setRay(solid, 0.1, 0.2, -0.1, random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            query.nearest(Double.POSITIVE_INFINITY);
            assertThat(query.triangle()).isBetween(0, ball.triangleCount() - 1);
        }
    }

    @Test
    void surfaceDistance_isMinimumOverTriangles() {
        Mesh mesh = SampleMeshes.randomTriangles(100, 5);
        MeshSolid solid = new MeshSolid(mesh);
        for (int n = 0; n < 1000; n++) {
            double x = random.nextGaussian();
            double y = random.nextGaussian();
            double z = random.nextGaussian();
            double minDistance = Double.POSITIVE_INFINITY;
            for (int t = 0; t < mesh.triangleCount(); t++) {
                int[] v = mesh.triangles();
                minDistance = Math.min(minDistance,
                        MeshRay.triangleDistance(mesh.positions(), 3 * v[3 * t], 3 * v[3 * t + 1], 3 * v[3 * t + 2], 1, x, y, z));
            }
            assertThat(solid.surfaceDistance(x, y, z)).isEqualTo(minDistance);
        }
    }

    @Test
    void ignoredTriangles_areNotHit() {
        MeshSolid cube = new MeshSolid(SampleMeshes.cube());
        query.setRay(cube, 0, 0, 0, 0.3, 0.1, 1);
        assertThat(query.nearest(Double.POSITIVE_INFINITY)).isEqualTo(1);
        query.ignoreNear(0.3, 0.1, 1, 1e-9);
        assertThat(query.nearest(Double.POSITIVE_INFINITY)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(query.isBlocked(2)).isFalse();
        query.setRay(cube, 0, 0, 0, 0.3, 0.1, 1);
        assertThat(query.isBlocked(2)).isTrue();
    }

    @Test
    void tree_containsEachTriangleOnce_andUsesAtMost60BytesPerTriangle() {
        Mesh ball = SampleMeshes.ball(200, 251, false);
        MeshTree tree = MeshTreeBuilder.build(ball);
        boolean[] seen = new boolean[ball.triangleCount()];
        for (int reference : tree.triangle) {
            if (reference >= 0) {
                int id = MeshTree.id(reference);
                assertThat(seen[id]).isFalse();
                seen[id] = true;
            }
        }
        assertThat(seen).doesNotContain(false);
        long meshBytes = 4L * (ball.positions().length + ball.triangles().length);
        assertThat((double) (tree.bytes() + meshBytes) / ball.triangleCount()).isLessThanOrEqualTo(60);
    }

    @Test
    void coincidentTriangles_makeShallowTree() {
        int[] t = new int[3 * 10_000];
        for (int i = 0; i < t.length; i++) {
            t[i] = i % 3;
        }
        MeshTree tree = MeshTreeBuilder.build(new Mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, t, null, null, null));
        assertThat(tree.stackSize).isLessThan(100);
    }

    @Test
    void equalMeshes_shareTree() {
        Mesh one = SampleMeshes.ball(9, 9, true);
        assertThat(MeshTree.of(one)).isSameAs(MeshTree.of(SampleMeshes.ball(9, 9, true)));
    }
}

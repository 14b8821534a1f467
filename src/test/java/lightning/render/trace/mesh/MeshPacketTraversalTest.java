package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.ToDoubleFunction;
import lightning.render.trace.solid.LaneRays;
import lightning.sample.SampleMeshes;
import lightning.sample.Slow;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that lanes and scalar traversal agree bit for bit: in beams and as single rays, from near and far. */
class MeshPacketTraversalTest {
    private static final Mesh BALL = SampleMeshes.ball(60, 100, false);

    private final MeshPacketTraversal traversal = new MeshPacketTraversal();
    private final MeshRayQuery rayQuery = new MeshRayQuery();
    private final LaneRays[] group = new LaneRays[MeshPacketTraversal.PACKETS];
    private final int[] masks = new int[MeshPacketTraversal.PACKETS];
    private final double[][] limits = new double[MeshPacketTraversal.PACKETS][LaneRays.WIDTH];
    private final boolean[][] expected = new boolean[MeshPacketTraversal.PACKETS][LaneRays.WIDTH];

    @Property
    void packets_matchSingleRays(@ForAll @IntRange(min = 0, max = 300) int triangles, @ForAll long seed) {
        Random random = new Random(seed);
        Mesh mesh = random.nextBoolean() ? SampleMeshes.randomTriangles(triangles, seed)
                : SampleMeshes.ball(3 + triangles / 20, 5 + triangles / 20, false);
        check(new MeshSolid(mesh), random, 10);
    }

    /** Runs long enough for the optimizing compiler, since interpreted vector code proves nothing about its bits. */
    @Test
    @Slow
    void compiledCode_matchesBitForBit() {
        check(new MeshSolid(BALL), new Random(1), 6000);
    }

    private void check(MeshSolid solid, Random random, int times) {
        double[] m = new double[12];
        for (int n = 0; n < times; n++) {
            double scale = Math.pow(10, random.nextInt(4) == 0 ? random.nextInt(18) - 9 : 0);
            for (int k = 0; k < 12; k++) {
                m[k] = k % 4 == 3 ? 0.2 * random.nextGaussian() : (k % 5 == 0 ? 1 : 0.3) * random.nextGaussian() * scale;
            }
            int count = 1 + random.nextInt(MeshPacketTraversal.PACKETS);
            rays(random, scale, count);
            assertNearest(solid, m, count);
            assertBlocked(solid, m, count, random);
        }
    }

    /** Floats must not reject a hit of the test in doubles: rays through vertices and along edges are the hardest. */
    @Test
    void raysAtVerticesAndEdges_matchBitForBit() {
        assertBitsMatch(new Random(2), 500, random -> Math.pow(10, 3 * random.nextDouble()), BALL.triangleCount());
    }

    /** Uses rays from a point near the mesh that traverse it together, as camera rays do. */
    @Test
    void commonOriginRaysAtNearbyVertices_matchBitForBit() {
        assertBitsMatch(new Random(3), 2000, _ -> 1.5, 10);
    }

    /** A beam that is wider than the mesh's boxes is split while it descends, and each of its rays continues in one part. */
    @Test
    void divergentRays_matchBitForBit() {
        assertBitsMatch(new Random(4), 300, _ -> 2, 3000);
    }

    /** Compares groups of rays of {@link #aim}, from random distances, through triangles of a ball. */
    private void assertBitsMatch(Random random, int groups, ToDoubleFunction<Random> far, int triangles) {
        MeshSolid solid = new MeshSolid(BALL);
        double[] m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        for (int n = 0; n < groups; n++) {
            aim(random, BALL, far.applyAsDouble(random), triangles);
            assertNearest(solid, m, MeshPacketTraversal.PACKETS);
            assertBlocked(solid, m, MeshPacketTraversal.PACKETS, random);
        }
    }

    /** Creates rays from one origin through vertices and edge midpoints of consecutive triangles, or from there to one end. */
    private void aim(Random random, Mesh mesh, double far, int triangles) {
        int first = random.nextInt(mesh.triangleCount() - triangles + 1);
        boolean back = random.nextBoolean();
        double[] eye = new double[3];
        for (int k = 0; k < 3; k++) {
            eye[k] = far * random.nextGaussian();
        }
        float[] v = mesh.positions();
        double[] at = new double[3];
        for (int g = 0; g < MeshPacketTraversal.PACKETS; g++) {
            LaneRays p = new LaneRays();
            group[g] = p;
            masks[g] = -1 >>> -LaneRays.WIDTH;
            for (int i = 0; i < LaneRays.WIDTH; i++) {
                int corner = (first + random.nextInt(triangles)) * 3;
                int a = 3 * mesh.triangles()[corner];
                int b = 3 * mesh.triangles()[corner + random.nextInt(2)];
                for (int k = 0; k < 3; k++) {
                    at[k] = 0.5 * ((double) v[a + k] + v[b + k]);
                }
                p.ox[i] = back ? at[0] + 0.5 * (at[0] - eye[0]) : eye[0];
                p.oy[i] = back ? at[1] + 0.5 * (at[1] - eye[1]) : eye[1];
                p.oz[i] = back ? at[2] + 0.5 * (at[2] - eye[2]) : eye[2];
                p.dx[i] = (back ? eye[0] : at[0]) - p.ox[i];
                p.dy[i] = (back ? eye[1] : at[1]) - p.oy[i];
                p.dz[i] = (back ? eye[2] : at[2]) - p.oz[i];
                limits[g][i] = Double.POSITIVE_INFINITY;
            }
        }
    }

    private void rays(Random random, double scale, int count) {
        double far = random.nextInt(5) == 0 ? Math.pow(10, random.nextInt(10)) : 2;
        double spread = random.nextBoolean() ? 0.02 : 1;
        double[] o = new double[3];
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            o[k] = far * random.nextGaussian() / scale;
            d[k] = 0.3 * random.nextGaussian() / scale - o[k];
        }
        int flat = random.nextInt(6);
        // One origin, nearby origins, or rays that all end at one point, approximately or exactly.
        int kind = random.nextInt(4);
        double off = random.nextBoolean() ? 0 : Math.pow(10, -18 * random.nextDouble()) / scale;
        for (int g = 0; g < count; g++) {
            LaneRays p = new LaneRays();
            group[g] = p;
            do {
                masks[g] = (random.nextInt(3) == 0 ? random.nextInt() : -1) & -1 >>> -LaneRays.WIDTH;
            } while (masks[g] == 0);
            for (int i = 0; i < LaneRays.WIDTH; i++) {
                double apart = kind > 0 ? spread / scale : 0;
                p.ox[i] = o[0] + apart * random.nextGaussian();
                p.oy[i] = o[1] + apart * random.nextGaussian();
                p.oz[i] = o[2] + apart * random.nextGaussian();
                if (kind > 1) {
                    p.dx[i] = o[0] + d[0] + off * random.nextGaussian() - p.ox[i];
                    p.dy[i] = o[1] + d[1] - p.oy[i];
                    p.dz[i] = o[2] + d[2] - p.oz[i];
                } else {
                    p.dx[i] = flat == 0 ? 0 : d[0] + spread * random.nextGaussian() / scale;
                    p.dy[i] = flat == 1 ? -0.0 : d[1] + spread * random.nextGaussian() / scale;
                    p.dz[i] = d[2] + spread * random.nextGaussian() / scale;
                }
                if (random.nextInt(40) == 0) {
                    // Like the shadow ray from a row to a light at the row's position, or almost there.
                    double less = random.nextBoolean() ? 0 : Math.pow(10, -330 * random.nextDouble());
                    p.dx[i] *= less;
                    p.dy[i] *= less;
                    p.dz[i] *= less;
                }
                limits[g][i] = random.nextInt(3) == 0 ? random.nextDouble() * 2 : Double.POSITIVE_INFINITY;
            }
        }
    }

    private void setRay(MeshSolid solid, double[] m, LaneRays p, int i) {
        rayQuery.setRay(solid, m[0] * p.ox[i] + m[1] * p.oy[i] + m[2] * p.oz[i] + m[3],
                m[4] * p.ox[i] + m[5] * p.oy[i] + m[6] * p.oz[i] + m[7], m[8] * p.ox[i] + m[9] * p.oy[i] + m[10] * p.oz[i] + m[11],
                m[0] * p.dx[i] + m[1] * p.dy[i] + m[2] * p.dz[i], m[4] * p.dx[i] + m[5] * p.dy[i] + m[6] * p.dz[i],
                m[8] * p.dx[i] + m[9] * p.dy[i] + m[10] * p.dz[i]);
    }

    private void search(MeshSolid solid, double[] m, int count) {
        traversal.beginGroup(solid, m, 0);
        for (int g = 0; g < count; g++) {
            traversal.addPacket(group[g], masks[g], limits[g]);
        }
    }

    private void assertNearest(MeshSolid solid, double[] m, int count) {
        search(solid, m, count);
        traversal.findNearest();
        for (int g = 0; g < count; g++) {
            assertThat(traversal.hitMask(g) & ~masks[g]).isZero();
            for (int i = 0; i < LaneRays.WIDTH; i++) {
                if ((masks[g] >>> i & 1) != 0) {
                    setRay(solid, m, group[g], i);
                    double t = rayQuery.nearest(limits[g][i]);
                    assertThat(traversal.hitMask(g) >>> i & 1).as("ray %s of packet %s", i, g).isEqualTo(rayQuery.triangle() >= 0 ? 1 : 0);
                    if (rayQuery.triangle() >= 0) {
                        assertThat(traversal.triangle(g, i)).isEqualTo(rayQuery.triangle());
                        assertThat(traversal.distance(g, i)).isEqualTo(t);
                    }
                }
            }
        }
    }

    private void assertBlocked(MeshSolid solid, double[] m, int count, Random random) {
        boolean shadowRays = random.nextBoolean();
        for (int g = 0; g < count; g++) {
            for (int i = 0; i < LaneRays.WIDTH; i++) {
                setRay(solid, m, group[g], i);
                double t = rayQuery.nearest(Double.POSITIVE_INFINITY);
                limits[g][i] = shadowRays ? 1 : random.nextInt(3) == 0 ? limits[g][i] : random.nextBoolean() ? t : Math.nextUp(t);
                expected[g][i] = (masks[g] >>> i & 1) != 0 && rayQuery.isBlocked(limits[g][i]);
            }
        }
        search(solid, m, count);
        traversal.findBlocked();
        for (int g = 0; g < count; g++) {
            for (int i = 0; i < LaneRays.WIDTH; i++) {
                assertThat((traversal.hitMask(g) >>> i & 1) != 0).as("ray %s of packet %s", i, g).isEqualTo(expected[g][i]);
            }
        }
    }
}

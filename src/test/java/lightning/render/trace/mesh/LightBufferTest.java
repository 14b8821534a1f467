package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.TreeMap;
import lightning.sample.SampleMeshes;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class LightBufferTest {
    private final MeshRayQuery query = new MeshRayQuery();

    @Property
    void cells_loseNoHit(@ForAll @IntRange(min = 0, max = 300) int triangles, @ForAll long seed) {
        Random random = new Random(seed);
        Mesh mesh = SampleMeshes.randomTriangles(triangles, seed);
        MeshSolid solid = new MeshSolid(mesh);
        for (int n = 0; n < 8; n++) {
            double far = Math.pow(10, random.nextInt(8) - 1);
            double[] end = {far * random.nextGaussian(), far * random.nextGaussian(), far * random.nextGaussian()};
            LightBuffer buffer = LightBuffer.of(solid, point(end[0], end[1], end[2]));
            for (int i = 0; buffer != null && i < 40; i++) {
                compare(solid, buffer, end, MeshRayQueryTest.aim(mesh, random), random);
            }
        }
    }

    @Property
    void cellsOfNeighboringPoints_loseNoHit(@ForAll @IntRange(min = 0, max = 300) int triangles, @ForAll long seed) {
        Random random = new Random(seed);
        Mesh mesh = SampleMeshes.randomTriangles(triangles, seed);
        MeshSolid solid = new MeshSolid(mesh);
        for (int n = 0; n < 8; n++) {
            double far = Math.pow(10, random.nextInt(5) - 1);
            double[] points = new double[6];
            for (int a = 0; a < 3; a++) {
                points[a] = far * random.nextGaussian();
                points[a + 3] = points[a] + (random.nextInt(4) == 0 ? 0 : far * Math.abs(random.nextGaussian()));
            }
            LightBuffer buffer = LightBuffer.of(solid, points);
            for (int i = 0; buffer != null && i < 40; i++) {
                double[] end = new double[3];
                for (int a = 0; a < 3; a++) {
                    // Corners are likely, because images are largest there.
                    end[a] = random.nextInt(3) == 0 ? points[a] + random.nextDouble() * (points[a + 3] - points[a])
                            : points[a + 3 * random.nextInt(2)];
                }
                compare(solid, buffer, end, MeshRayQueryTest.aim(mesh, random), random);
            }
        }
    }

    @Test
    void pointWithinTheBox_hasNoBuffer() {
        MeshSolid ball = new MeshSolid(SampleMeshes.ball(12, 9, false));
        assertThat(LightBuffer.of(ball, point(0.1, 0.2, 0.3))).isNull();
        assertThat(LightBuffer.of(ball, point(0.1, 3, 0.3))).isNotNull();
    }

    @Test
    void rayToAnotherPoint_findsItsHits() {
        MeshSolid ball = new MeshSolid(SampleMeshes.ball(12, 9, false));
        LightBuffer buffer = LightBuffer.of(ball, point(0, 3, 0));
        assertThat(buffer.place(0, -3, 0, 0, 6, 0)).isNotNegative();
        assertThat(buffer.place(0, -3, 0, 1e-6, 6, 0)).isEqualTo(LightBuffer.OTHER_END);
        query.collectHits(buffer, ball, 0, -3, 0, 1, 6, 0.5);
        assertThat(query.hitCount()).isEqualTo(2);
    }

    @Test
    void rayThatMissesAllBoxes_testsNoLeaf() {
        MeshSolid ball = new MeshSolid(SampleMeshes.ball(12, 9, false));
        LightBuffer buffer = LightBuffer.of(ball, point(0, 3, 0));
        assertThat(buffer.place(5, -3, 0, -5, 6, 0)).isEqualTo(LightBuffer.NO_CELL);
        // The ray starts between the point and the mesh, or beyond the point.
        assertThat(buffer.place(0, 2.5, 0, 0, 0.5, 0)).isEqualTo(LightBuffer.NO_CELL);
        assertThat(buffer.place(0, 4, 0, 0, -1, 0)).isEqualTo(LightBuffer.NO_CELL);
    }

    private void compare(MeshSolid solid, LightBuffer buffer, double[] end, double[] through, Random random) {
        double[] o = new double[3];
        double[] d = new double[3];
        double beyond = random.nextInt(3) == 0 ? 0 : random.nextDouble() * 2 - 0.5;
        for (int a = 0; a < 3; a++) {
            o[a] = through[a] + beyond * (through[a] - end[a]);
            d[a] = end[a] - o[a];
        }
        query.setRay(solid, o[0], o[1], o[2], d[0], d[1], d[2]);
        query.collectHitsBruteForce(1);
        TreeMap<Integer, Double> expected = hits();
        query.collectHits(1);
        assertThat(hits()).isEqualTo(expected);
        query.collectHits(buffer, solid, o[0], o[1], o[2], d[0], d[1], d[2]);
        assertThat(hits()).isEqualTo(expected);
    }

    private TreeMap<Integer, Double> hits() {
        TreeMap<Integer, Double> hits = new TreeMap<>();
        for (int i = 0; i < query.hitCount(); i++) {
            assertThat(hits.put(query.hitTriangle(i), query.hitDistance(i))).isNull();
        }
        return hits;
    }

    /** Returns the bounds of a single point. */
    private static double[] point(double x, double y, double z) {
        return new double[] {x, y, z, x, y, z};
    }
}

package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.sample.SampleMeshes;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Compares the tests of single rays on lanes with the loops. */
class SingleRayLanesTest {
    @Property
    void lanes_findTheHitsOfTheLoops(@ForAll @IntRange(max = 200) int triangles, @ForAll @DoubleRange(min = -25, max = 10) double power,
            @ForAll long seed) {
        Mesh mesh = scaled(SampleMeshes.randomTriangles(triangles, seed), (float) Math.pow(10, power));
        MeshSolid solid = new MeshSolid(mesh);
        var random = new Random(seed);
        var loops = new MeshRayQuery(MeshTests.LOOPS);
        var lanes = new MeshRayQuery(SingleRayLanes::new);
        for (int n = 0; n < 40; n++) {
            double[] ray = ray(mesh, random, Math.pow(10, power));
            for (MeshRayQuery query : new MeshRayQuery[] {loops, lanes}) {
                query.setRay(solid, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
            }
            double expected = loops.nearest(Double.POSITIVE_INFINITY);
            assertThat(lanes.nearest(Double.POSITIVE_INFINITY)).isEqualTo(expected);
            assertThat(lanes.triangle()).isEqualTo(loops.triangle());
            assertThat(lanes.isBlocked(expected)).isFalse();
            assertThat(lanes.isBlocked(Math.nextUp(expected))).isEqualTo(expected < Double.POSITIVE_INFINITY);
            loops.collectHits(Double.POSITIVE_INFINITY);
            lanes.collectHits(Double.POSITIVE_INFINITY);
            assertThat(lanes.hitCount()).isEqualTo(loops.hitCount());
        }
    }

    /** Of a node, the lanes enter every box that the loops enter, at a distance that is not above theirs. */
    @Property
    void boxes_includeThoseOfTheLoops(@ForAll @DoubleRange(min = -17, max = 10) double power, @ForAll long seed) {
        Mesh mesh = scaled(SampleMeshes.randomTriangles(40, seed), (float) Math.pow(10, power));
        MeshTree tree = new MeshSolid(mesh).tree;
        var random = new Random(seed);
        var lanes = new SingleRayLanes();
        var ray = new MeshRay();
        for (int n = 0; n < 40; n++) {
            double[] r = ray(mesh, random, Math.pow(10, power));
            ray.setRay(r[0], r[1], r[2], r[3], r[4], r[5], tree.maxCoordinate);
            if (!lanes.setRay(ray, tree.maxCoordinate)) {
                continue;
            }
            double limit = random.nextBoolean() ? Double.POSITIVE_INFINITY : random.nextDouble();
            int entered = lanes.entered(tree.box, 0, limit);
            for (int c = 0; c < MeshTree.WIDTH; c++) {
                double in = Math.max(0, Math.max(distance(tree, c, 0, ray.nearX, ray.inverseX, true),
                        Math.max(distance(tree, c, 1, ray.nearY, ray.inverseY, true),
                                distance(tree, c, 2, ray.nearZ, ray.inverseZ, true))));
                double out = Math.min(limit, Math.min(distance(tree, c, 0, ray.farX, ray.inverseX, false),
                        Math.min(distance(tree, c, 1, ray.farY, ray.inverseY, false),
                                distance(tree, c, 2, ray.farZ, ray.inverseZ, false))));
                if (in <= out) {
                    assertThat(entered >> c & 1).as("child " + c).isEqualTo(1);
                    assertThat((double) lanes.entries()[c]).isLessThanOrEqualTo(in);
                }
            }
        }
    }

    private static double distance(MeshTree tree, int child, int axis, double origin, double inverse, boolean enters) {
        int side = inverse > 0 == enters ? 0 : 8;
        return (tree.box[16 * axis + side + child] - origin) * inverse;
    }

    @Test
    void rayAlongAnAxis_isLeftToTheLoops() {
        var ray = new MeshRay();
        ray.setRay(0, 0, 0, 0, 1, 0, 1);
        assertThat(new SingleRayLanes().setRay(ray, 1)).isFalse();
        ray.setRay(0, 0, 0, 0.5, 1, 0.25, 1);
        assertThat(new SingleRayLanes().setRay(ray, 1)).isTrue();
    }

    private static Mesh scaled(Mesh mesh, float factor) {
        float[] positions = mesh.positions().clone();
        for (int i = 0; i < positions.length; i++) {
            positions[i] *= factor;
        }
        return new Mesh(positions, mesh.triangles(), null, null, null);
    }

    private static double[] ray(Mesh mesh, Random random, double scale) {
        double far = random.nextInt(4) == 0 ? 1e6 : 2;
        double[] to = MeshRayQueryTest.aim(mesh, random);
        double[] ray = new double[6];
        double length = Math.pow(10, random.nextInt(21) - 10);
        for (int a = 0; a < 3; a++) {
            boolean isOfMesh = mesh.triangleCount() > 0;
            ray[a] = scale * far * random.nextGaussian();
            ray[3 + a] = random.nextInt(24) == 0 ? 1e-9 * random.nextGaussian() : length * ((isOfMesh ? to[a] : scale * to[a]) - ray[a]);
        }
        return ray;
    }
}

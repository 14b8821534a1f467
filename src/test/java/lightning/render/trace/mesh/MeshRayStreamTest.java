package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import lightning.render.trace.solid.LaneRays;
import lightning.sample.SampleMeshes;
import lightning.sample.Slow;
import lightning.scene.node.Mesh;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that rays that walk over a mesh together have the hits of single rays, bit for bit. */
class MeshRayStreamTest {
    private static final double[] UNCHANGED = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    private final MeshRayStream stream = new MeshRayStream();
    private final MeshRayQuery rayQuery = new MeshRayQuery();

    /** A hit: triangle and distance. */
    private record Hit(int triangle, double distance) {}

    @Property
    void streams_matchSingleRays(@ForAll @IntRange(min = 0, max = 400) int triangles, @ForAll long seed) {
        check(triangles, new Random(seed), 3);
    }

    /** Runs long enough for the optimizing compiler, since interpreted vector code proves nothing about its bits. */
    @Test
    @Slow
    void compiledCode_matchesBitForBit() {
        check(2000, new Random(1), 500);
    }

    /** A shadow ray to a light at the row's position is too short for a line. */
    @Test
    void raysWithoutLength_hitNothingElse() {
        MeshSolid solid = new MeshSolid(SampleMeshes.ball(10, 20, false));
        LaneRays packet = packet(new Random(5), SampleMeshes.ball(10, 20, false), 1);
        Arrays.fill(packet.dx, 1e-300);
        Arrays.fill(packet.dy, 0);
        Arrays.fill(packet.dz, 0);
        assertMatches(solid, List.of(packet), new int[] {-1 >>> -LaneRays.WIDTH}, 1);
    }

    private void check(int triangles, Random random, int times) {
        Mesh mesh = random.nextBoolean() ? SampleMeshes.randomTriangles(triangles, random.nextLong())
                : SampleMeshes.ball(3 + triangles / 20, 5 + triangles / 20, false);
        MeshSolid solid = new MeshSolid(mesh);
        for (int n = 0; n < times; n++) {
            int count = 1 + random.nextInt(random.nextBoolean() ? 4 : MeshRayStream.MAX_RAYS / LaneRays.WIDTH);
            double far = Math.pow(10, random.nextInt(6) == 0 ? 6 : random.nextInt(2));
            List<LaneRays> packets = new ArrayList<>();
            int[] masks = new int[count];
            for (int k = 0; k < count; k++) {
                packets.add(packet(random, mesh, far));
                masks[k] = 1 + random.nextInt(-1 >>> -LaneRays.WIDTH);
            }
            assertMatches(solid, packets, masks, random.nextBoolean() ? 1 : Double.POSITIVE_INFINITY);
        }
    }

    /** Creates rays from far and near, many of them through vertices and edges. */
    private static LaneRays packet(Random random, Mesh mesh, double far) {
        LaneRays p = new LaneRays();
        float[] v = mesh.positions();
        double[] at = new double[3];
        for (int i = 0; i < LaneRays.WIDTH; i++) {
            for (int k = 0; k < 3; k++) {
                at[k] = random.nextGaussian();
            }
            if (mesh.triangleCount() > 0 && random.nextInt(3) != 0) {
                int corner = 3 * random.nextInt(mesh.triangleCount());
                int a = 3 * mesh.triangles()[corner];
                int b = 3 * mesh.triangles()[corner + random.nextInt(2)];
                for (int k = 0; k < 3; k++) {
                    at[k] = 0.5 * ((double) v[a + k] + v[b + k]);
                }
            }
            p.ox[i] = far * random.nextGaussian();
            p.oy[i] = far * random.nextGaussian();
            p.oz[i] = random.nextInt(4) == 0 ? at[2] : far * random.nextGaussian();
            double reach = 1 + random.nextInt(3);
            p.dx[i] = (at[0] - p.ox[i]) * reach;
            p.dy[i] = (at[1] - p.oy[i]) * reach;
            p.dz[i] = (at[2] - p.oz[i]) * reach;
        }
        return p;
    }

    private void assertMatches(MeshSolid solid, List<LaneRays> packets, int[] masks, double limit) {
        double[] limits = new double[LaneRays.WIDTH];
        Arrays.fill(limits, limit);
        stream.begin(solid, UNCHANGED, 0);
        for (int k = 0; k < packets.size(); k++) {
            stream.addPacket(packets.get(k), masks[k], limits);
        }
        stream.findAllHits();
        List<List<Hit>> found = new ArrayList<>();
        for (int i = 0; i < packets.size() * LaneRays.WIDTH; i++) {
            found.add(new ArrayList<>());
        }
        for (int n = 0; n < stream.hitCount(); n++) {
            found.get(stream.hitRay(n)).add(new Hit(stream.hitTriangle(n), stream.hitDistance(n)));
        }
        for (int i = 0; i < found.size(); i++) {
            LaneRays p = packets.get(i / LaneRays.WIDTH);
            int lane = i % LaneRays.WIDTH;
            List<Hit> expected = List.of();
            if ((masks[i / LaneRays.WIDTH] >>> lane & 1) != 0) {
                rayQuery.setRay(solid, p.ox[lane], p.oy[lane], p.oz[lane], p.dx[lane], p.dy[lane], p.dz[lane]);
                rayQuery.collectHits(limit);
                expected = IntStream.range(0, rayQuery.hitCount())
                        .mapToObj(n -> new Hit(rayQuery.hitTriangle(n), rayQuery.hitDistance(n)))
                        .filter(hit -> hit.distance < limit).toList();
            }
            assertThat(found.get(i)).as("ray %s", i).containsExactlyInAnyOrderElementsOf(expected);
        }
    }
}

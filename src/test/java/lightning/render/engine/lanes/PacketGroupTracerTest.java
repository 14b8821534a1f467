package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.tree.CandidateList;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Compares every result of a packet group with the scalar functions over all shapes, bit for bit. */
class PacketGroupTracerTest {
    private static final int GROUPS = 8;
    private static final int W = RayPacket.WIDTH;

    private static CandidateList overflowingCandidates() {
        CandidateList candidates = new CandidateList();
        candidates.overflow = true;
        return candidates;
    }

    /** Returns some rays of some packets, at least one. */
    private static long randomSet(Random random) {
        long set = 0;
        for (int k = 0; k < PacketGroupTracer.MAX_PACKETS; k++) {
            long rays = random.nextInt(3) == 0 ? 0 : random.nextBoolean() ? -1 : random.nextLong();
            set |= (rays & -1L >>> -W) << k * W;
        }
        return set == 0 ? 1L << random.nextInt(64) : set;
    }

    @Property
    void nearestHit_matchesBruteForceBitForBit(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        checkGroups(geometry, seed, (tracer, set) -> {
            tracer.findNearest(set, overflowingCandidates());
            checkRays(tracer, set, (p, i, _) -> {
                Ray ray = RandomRays.ray(p, i);
                int expected = BruteForce.nearest(geometry, ray);
                assertThat(p.primitive[i]).as("%s", ray).isEqualTo(expected);
                assertThat(PacketTracerTest.bits(p.t[i]))
                        .isEqualTo(PacketTracerTest.bits(expected < 0 ? SolidGeometry.MISS : geometry.distance(expected, ray)));
            });
        });
    }

    @Property
    void occlusion_matchesBruteForce(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        checkGroups(geometry, seed, (tracer, set) -> {
            long blocked = tracer.findBlocked(set, overflowingCandidates());
            checkRays(tracer, set, (p, i, bit) -> assertThat((blocked & bit) != 0)
                    .isEqualTo(BruteForce.isBlocked(geometry, RandomRays.ray(p, i), p.limit[i])));
            assertThat(blocked & ~set).isZero();
        });
    }

    /** Check of a set of a group's rays. */
    private interface GroupCheck {
        void check(PacketGroupTracer tracer, long set);
    }

    /** Check of ray {@code i} of a packet, which is the given bit of the group. */
    private interface RayCheck {
        void check(RayPacket packet, int i, long bit);
    }

    /** Fills groups with rays, some of which are selected, and checks them with the BVH and with all shapes. */
    private static void checkGroups(Geometry geometry, long seed, GroupCheck check) {
        for (int maxLinear : new int[] {1, Integer.MAX_VALUE}) {
            PacketGroupTracer tracer = new PacketGroupTracer(geometry.bvh(), maxLinear);
            RandomRays rays = new RandomRays(geometry, seed);
            Random random = new Random(seed);
            for (int n = 0; n < GROUPS; n++) {
                long set = randomSet(random);
                for (RayPacket p : tracer.packets) {
                    rays.fill(p);
                }
                check.check(tracer, set);
            }
        }
    }

    private static void checkRays(PacketGroupTracer tracer, long set, RayCheck check) {
        for (long left = set; left != 0; left &= left - 1) {
            int ray = Long.numberOfTrailingZeros(left);
            check.check(tracer.packets[ray / W], ray % W, left & -left);
        }
    }
}

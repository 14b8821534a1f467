package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.solid.Form;
import lightning.render.trace.tree.Candidates;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Every answer of a group is compared with the scalar functions of all shapes, bit for bit. */
class GroupTracerTest {
    private static final int GROUPS = 8;
    private static final int W = RayPacket.WIDTH;

    private static Candidates unknown() {
        Candidates candidates = new Candidates();
        candidates.tooMany = true;
        return candidates;
    }

    /** Some rays of some packets, at least one. */
    private static long set(Random random) {
        long set = 0;
        for (int k = 0; k < GroupTracer.MOST; k++) {
            long rays = random.nextInt(3) == 0 ? 0 : random.nextBoolean() ? -1 : random.nextLong();
            set |= (rays & -1L >>> -W) << k * W;
        }
        return set == 0 ? 1L << random.nextInt(64) : set;
    }

    @Property
    void nearest_isThatOfAllShapesInEveryBit(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(TraceScenes.wild(shapes, seed));
        asked(geometry, seed, (tracer, set) -> {
            tracer.nearest(set, unknown());
            each(tracer, set, (p, i, _) -> {
                Ray ray = TraceRays.ray(p, i);
                int expected = geometry.nearestOfAll(ray);
                assertThat(p.primitive[i]).as("%s", ray).isEqualTo(expected);
                assertThat(PacketTracerTest.bits(p.t[i]))
                        .isEqualTo(PacketTracerTest.bits(expected < 0 ? Form.MISS : geometry.distance(expected, ray)));
            });
        });
    }

    @Property
    void blocked_isThatOfAllShapes(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(TraceScenes.wild(shapes, seed));
        asked(geometry, seed, (tracer, set) -> {
            long blocked = tracer.blocked(set, unknown());
            each(tracer, set, (p, i, bit) -> assertThat((blocked & bit) != 0)
                    .isEqualTo(geometry.blockedByAny(TraceRays.ray(p, i), p.limit[i])));
            assertThat(blocked & ~set).isZero();
        });
    }

    /** What is asked of a group's rays in a set. */
    private interface Question {
        void ask(GroupTracer tracer, long set);
    }

    /** Looks at ray {@code i} of a packet, which is the group's ray of that bit. */
    private interface Look {
        void at(RayPacket packet, int i, long bit);
    }

    /** Fills groups, that go down the tree and that ask all shapes, with rays, some of which are asked. */
    private static void asked(Geometry geometry, long seed, Question question) {
        for (int few : new int[] {1, Integer.MAX_VALUE}) {
            GroupTracer tracer = new GroupTracer(geometry.bvh(), few);
            TraceRays rays = new TraceRays(geometry, seed);
            Random random = new Random(seed);
            for (int n = 0; n < GROUPS; n++) {
                long set = set(random);
                for (RayPacket p : tracer.packets) {
                    rays.fill(p);
                }
                question.ask(tracer, set);
            }
        }
    }

    private static void each(GroupTracer tracer, long set, Look look) {
        for (long left = set; left != 0; left &= left - 1) {
            int ray = Long.numberOfTrailingZeros(left);
            look.at(tracer.packets[ray / W], ray % W, left & -left);
        }
    }
}

package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.solid.SolidGeometry;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that the first of several shapes at equal distance is hit: by single rays and packets, with and without BVH. Also tests
 * that shapes block only nearer than the end of a shadow ray, not exactly at it.
 */
@Slow
class EqualDistanceTest {
    /** 1600 rays on every machine: the width of a packet depends on the processor. */
    private static final int PACKETS = 1600 / RayPacket.WIDTH;

    static Stream<Arguments> scenes() {
        return Stream.of(
                Arguments.of("equal balls at one position", TraceScenes.overlappingShapes(1000)),
                Arguments.of("a thousand shapes at one position", TraceScenes.mixedOverlappingShapes(1000)),
                Arguments.of("nested shapes", TraceScenes.nested()),
                Arguments.of("flat shapes", TraceScenes.flat()),
                Arguments.of("shapes of all scales, many duplicated", TraceScenes.randomScene(60, 8)));
    }

    private final RayPacket rayPacket = new RayPacket();

    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    void equalDistances_lowestIndexWinsInEveryTracer(String name, Scene scene) {
        Geometry geometry = Geometry.of(scene);
        PacketTracer byTree = new PacketTracer(geometry.bvh(), 1);
        PacketTracer inTurn = new PacketTracer(geometry.bvh(), Integer.MAX_VALUE);
        RandomRays rays = new RandomRays(geometry, 1);
        int[] first = new int[RayPacket.WIDTH];
        double[] least = new double[RayPacket.WIDTH];
        int ties = 0;
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(rayPacket);
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Ray ray = RandomRays.ray(rayPacket, i);
                ties += lowest(geometry, ray, i, first, least) > 1 ? 1 : 0;
                assertThat(BruteForce.nearest(geometry, ray)).as("%s", ray).isEqualTo(first[i]);
                assertThat(geometry.nearest(ray)).as("%s", ray).isEqualTo(first[i]);
            }
            for (PacketTracer tracer : new PacketTracer[] {byTree, inTurn}) {
                tracer.findNearest(rayPacket, RayPacket.WIDTH);
                assertThat(rayPacket.primitive).isEqualTo(first);
                assertThat(rayPacket.t).isEqualTo(least);
            }
        }
        assertThat(ties).as("rays with several nearest shapes").isGreaterThan(100);
    }

    /** Searches from the last shape to the first, unlike any tracer; returns the number of shapes at the minimum distance. */
    private static int lowest(Geometry geometry, Ray ray, int lane, int[] nearest, double[] minDistance) {
        nearest[lane] = -1;
        minDistance[lane] = SolidGeometry.MISS;
        int equals = 0;
        for (int s = geometry.primitiveCount() - 1; s >= 0; s--) {
            double t = geometry.distance(s, ray);
            if (t < SolidGeometry.MISS && t <= minDistance[lane]) {
                equals = t < minDistance[lane] ? 1 : equals + 1;
                minDistance[lane] = t;
                nearest[lane] = s;
            }
        }
        return equals;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    void shadowRayEndingAtFirstHit_isUnblocked_andBlockedBeyondIt(String name, Scene scene) {
        Geometry geometry = Geometry.of(scene);
        PacketTracer byTree = new PacketTracer(geometry.bvh(), 1);
        PacketTracer inTurn = new PacketTracer(geometry.bvh(), Integer.MAX_VALUE);
        RandomRays rays = new RandomRays(geometry, 2);
        Random random = new Random(2);
        int[] blocked = new int[2];
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(rayPacket);
            int expected = 0;
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Ray ray = RandomRays.ray(rayPacket, i);
                int first = BruteForce.nearest(geometry, ray);
                double t = first < 0 ? SolidGeometry.MISS : geometry.distance(first, ray);
                boolean beyondLimit = t < SolidGeometry.MISS && random.nextBoolean();
                rayPacket.limit[i] = beyondLimit ? Math.nextUp(t) : t;
                assertThat(BruteForce.isBlocked(geometry, ray, rayPacket.limit[i])).as("%s", ray).isEqualTo(beyondLimit);
                assertThat(geometry.isBlocked(ray, rayPacket.limit[i])).as("%s", ray).isEqualTo(beyondLimit);
                expected |= beyondLimit ? 1 << i : 0;
                blocked[beyondLimit ? 1 : 0]++;
            }
            assertThat(byTree.findBlocked(rayPacket, RayPacket.WIDTH)).isEqualTo(expected);
            assertThat(inTurn.findBlocked(rayPacket, RayPacket.WIDTH)).isEqualTo(expected);
        }
        assertThat(Math.min(blocked[0], blocked[1])).as("rays with each result").isGreaterThan(100);
    }
}

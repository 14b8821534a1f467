package lightning.render.trace.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.engine.lanes.PacketTracer;
import lightning.render.engine.lanes.RandomRays;
import lightning.render.engine.lanes.RayPacket;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.TraceScenes;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class BvhTest {
    private final RayPacket packet = new RayPacket();

    @Property
    void singleRays_matchBruteForce(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        RandomRays rays = new RandomRays(geometry, seed);
        for (int n = 0; n < 10; n++) {
            rays.fill(packet);
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Ray ray = RandomRays.ray(packet, i);
                assertThat(geometry.nearest(ray)).isEqualTo(BruteForce.nearest(geometry, ray));
                assertThat(geometry.isBlocked(ray, packet.limit[i])).isEqualTo(BruteForce.isBlocked(geometry, ray, packet.limit[i]));
            }
        }
    }

    /** Uses lights on shapes, above them, and away from all. */
    @Property
    void shadowRayTargetsAndBlockers_matchBruteForce(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed,
            @ForAll @IntRange(min = 0, max = 60) int up) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        RandomRays rays = new RandomRays(geometry, seed);
        rays.fill(packet);
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            Ray ray = RandomRays.ray(packet, i);
            int hit = BruteForce.nearest(geometry, ray);
            double t = hit < 0 ? 1 : geometry.distance(hit, ray);
            Vec3 light = ray.origin().plus(ray.direction().times(t * (1 - Math.scalb(1, -up))));
            ShadowRayTarget end = geometry.shadowRayTarget(light);
            assertThat(end).usingRecursiveComparison().isEqualTo(BruteForce.shadowRayTarget(geometry, light));
            assertThat(geometry.blocker(ray.origin(), end)).isEqualTo(blockerBruteForce(geometry, ray.origin(), end));
        }
    }

    private static int blockerBruteForce(Geometry geometry, Vec3 point, ShadowRayTarget target) {
        Ray shadowRay = new Ray(point, target.point().minus(point));
        int nearest = -1;
        double min = 1;
        for (int s = 0; s < geometry.primitiveCount(); s++) {
            double t = geometry.distance(s, shadowRay, target);
            if (t < min) {
                min = t;
                nearest = s;
            }
        }
        return nearest;
    }

    @Property
    void movedCamera_refitsBoxesWithSameTopology(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed,
            @ForAll @DoubleRange(min = -100, max = 100) double by) {
        Scene scene = TraceScenes.randomScene(shapes, seed);
        Geometry here = Geometry.of(scene);
        Camera camera = scene.camera();
        Vec3 from = camera.from().plus(new Vec3(by, -by / 3, 1));
        Scene moved = scene.withCamera(new Camera(from, from.plus(new Vec3(0.3, 1, 2)), camera.up(), camera.fov()));
        Geometry there = here.forScene(moved, MaterialTable.CASTS_REFLECTIONS);
        Geometry built = Geometry.of(moved);
        assertThat(there.bvh().child).isSameAs(here.bvh().child);
        assertCovered(there.bvh());
        for (int s = 0; s < shapes; s++) {
            assertThat(box(there, s)).isEqualTo(box(built, s));
        }
        RandomRays rays = new RandomRays(there, seed);
        rays.fill(packet);
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            Ray ray = RandomRays.ray(packet, i);
            assertThat(there.nearest(ray)).isEqualTo(BruteForce.nearest(there, ray));
            assertThat(there.isBlocked(ray, packet.limit[i])).isEqualTo(BruteForce.isBlocked(there, ray, packet.limit[i]));
        }
    }

    @Test
    void rotatedCamera_reusesGeometry() {
        Scene scene = TraceScenes.cloud(10, 1);
        Camera camera = scene.camera();
        Geometry here = Geometry.of(scene);
        Vec3 to = camera.from().plus(new Vec3(1, 2, 3));
        assertThat(here.forScene(scene.withCamera(new Camera(camera.from(), to, camera.up(), 10)), MaterialTable.CASTS_REFLECTIONS))
                .isSameAs(here);
    }

    @Test
    void differentShapes_buildNewTree() {
        Geometry few = Geometry.of(TraceScenes.cloud(10, 1));
        assertThat(few.forScene(TraceScenes.cloud(11, 1), MaterialTable.CASTS_REFLECTIONS).primitiveCount()).isEqualTo(11);
    }

    @Test
    void emptyScene_hasNoHits() {
        Geometry geometry = Geometry.of(TraceScenes.cloud(0, 1));
        Ray ray = new Ray(Vec3.ZERO, new Vec3(0, 0, -1));
        assertThat(geometry.nearest(ray)).isEqualTo(-1);
        assertThat(geometry.isBlocked(ray, Double.POSITIVE_INFINITY)).isFalse();
    }

    @Test
    void eachShape_isInExactlyOneLeaf() {
        Bvh bvh = Geometry.of(TraceScenes.cloud(1000, 1)).bvh();
        boolean[] seen = new boolean[1000];
        for (int c : bvh.child) {
            if (c < 0) {
                assertThat(seen[~c]).isFalse();
                seen[~c] = true;
            }
        }
        assertThat(seen).doesNotContain(false);
    }

    @Test
    void childBoxes_containTheirSubtrees() {
        assertCovered(Geometry.of(TraceScenes.cloud(300, 2)).bvh());
    }

    private static float[] box(Geometry geometry, int s) {
        int at = geometry.bvh().leafBox[s];
        return Arrays.copyOfRange(geometry.bvh().boxes, at, at + 6);
    }

    private static void assertCovered(Bvh bvh) {
        for (int i = 0; i < bvh.child.length; i++) {
            int c = bvh.child[i];
            for (int inner = 0; c >= 0 && inner < 2; inner++) {
                int at = 12 * c + 6 * inner;
                for (int a = 0; a < 3; a++) {
                    assertThat(bvh.boxes[6 * i + a]).isLessThanOrEqualTo(bvh.boxes[at + a]);
                    assertThat(bvh.boxes[6 * i + 3 + a]).isGreaterThanOrEqualTo(bvh.boxes[at + 3 + a]);
                }
            }
        }
    }

    @Test
    void thousandCoincidentShapes_makeShallowTree_andFirstWins() {
        Geometry geometry = Geometry.of(TraceScenes.overlappingShapes(1000));
        assertThat(geometry.bvh().depth).isLessThanOrEqualTo(11);
        Ray ray = new Ray(Vec3.ZERO, geometry.toRenderSpace(Vec3.ZERO));
        assertThat(geometry.nearest(ray)).isZero();
        PacketTracer tracer = new PacketTracer(geometry);
        Arrays.fill(packet.dz, -1);
        tracer.findNearest(packet, RayPacket.WIDTH);
        assertThat(packet.primitive).containsOnly(0);
    }

    /** Distances that grow by a factor would make an SAH split separate one shape at a time. */
    @Test
    void shapesAtGrowingDistances_haveBoundedDepth() {
        float[] boxes = new float[6 * 120];
        for (int s = 0; s < 120; s++) {
            float at = (float) Math.pow(2, s - 60);
            Arrays.fill(boxes, 6 * s, 6 * s + 3, at);
            Arrays.fill(boxes, 6 * s + 3, 6 * s + 6, at * 1.01f);
        }
        assertThat(new BvhBuilder(boxes).depth).isLessThan(70);
    }

    @Test
    @Slow
    void millionShapes_buildInSeconds() {
        Random random = new Random(1);
        float[] boxes = new float[6_000_000];
        for (int s = 0; s < 1_000_000; s++) {
            for (int a = 0; a < 3; a++) {
                boxes[6 * s + a] = random.nextFloat();
                boxes[6 * s + 3 + a] = boxes[6 * s + a] + 0.01f;
            }
        }
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadCpuTime();
        assertThat(new BvhBuilder(boxes).depth).isBetween(20, 60);
        // CPU time, so that other load on the machine does not count.
        assertThat(Duration.ofNanos(threads.getCurrentThreadCpuTime() - before)).isLessThan(Duration.ofSeconds(30));
    }

    /** The shapes are so skewed that the inverse transform is noise: boxes are unusable, and all shapes must be tested. */
    @Property
    void overflowingShapes_matchBruteForce(@ForAll long seed) {
        Geometry geometry;
        try {
            geometry = Geometry.of(TraceScenes.skewedShapes(6, seed));
        } catch (IllegalArgumentException refused) {
            return;
        }
        PacketTracer tracer = new PacketTracer(geometry.bvh(), 1);
        RandomRays rays = new RandomRays(geometry, seed);
        for (int n = 0; n < 20; n++) {
            rays.fill(packet);
            tracer.findNearest(packet, RayPacket.WIDTH);
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Ray ray = RandomRays.ray(packet, i);
                assertThat(packet.primitive[i]).isEqualTo(BruteForce.nearest(geometry, ray));
                assertThat(geometry.nearest(ray)).isEqualTo(BruteForce.nearest(geometry, ray));
            }
        }
    }
}

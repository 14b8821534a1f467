package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.BruteForce;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that a beam's candidates contain every shape that its rays hit: each packet gets the same result as with all shapes. */
class CandidateListTest {
    private final RayPacket packet = new RayPacket();
    private final RayBeam beam = new RayBeam();
    private final CandidateList candidates = new CandidateList();

    @Property
    void eyeRays_withCandidates_hitSamePrimitives(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed) {
        Scene scene = seed % 2 == 0 ? TraceScenes.randomScene(shapes, seed) : TraceScenes.cloud(shapes, seed);
        Geometry geometry = Geometry.of(scene);
        PacketTracer tracer = new PacketTracer(geometry);
        CameraRays camera = new CameraRays(scene.camera(), new PictureSettings(256, 256, 1));
        Random random = new Random(seed);
        for (int tile = 0; tile < 8; tile++) {
            int left = 16 * random.nextInt(14);
            int top = random.nextInt(224);
            camera.boundBeam(beam, left, top, 32, 32);
            candidates.collect(geometry.bvh(), beam);
            for (int y = top; y < top + 32; y += 1 + random.nextInt(8)) {
                RandomRays.loadEyeRays(camera, left + 16 * random.nextInt(2) / RayPacket.WIDTH * RayPacket.WIDTH, y, packet);
                tracer.findNearest(packet, RayPacket.WIDTH, candidates);
                for (int i = 0; i < RayPacket.WIDTH; i++) {
                    Ray ray = RandomRays.ray(packet, i);
                    int expected = BruteForce.nearest(geometry, ray);
                    assertThat(packet.primitive[i]).isEqualTo(expected);
                    assertThat(PacketTracerTest.bits(packet.t[i]))
                            .isEqualTo(PacketTracerTest.bits(expected < 0 ? SolidGeometry.MISS : geometry.distance(expected, ray)));
                }
            }
        }
    }

    @Property
    void pointShadowRays_withCandidates_sameOcclusion(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(seed % 2 == 0 ? TraceScenes.randomScene(shapes, seed) : TraceScenes.cloud(shapes, seed));
        RandomRays rays = new RandomRays(geometry, seed);
        for (int bundle = 0; bundle < 8; bundle++) {
            Vec3 light = rays.origin();
            float[][] points = points(rays, seed + bundle, 5 * RayPacket.WIDTH);
            beam.clear();
            beam.addOrigins(new LaneTracer(geometry).bounds(points[0], points[1], points[2], 0, points[0].length));
            beam.aimAt(light);
            candidates.collect(geometry.bvh(), beam);
            PacketTracer tracer = new PacketTracer(geometry);
            for (int first = 0; first < points[0].length; first += RayPacket.WIDTH) {
                for (int i = 0; i < RayPacket.WIDTH; i++) {
                    Vec3 o = new Vec3(points[0][first + i], points[1][first + i], points[2][first + i]);
                    Vec3 to = light.minus(o);
                    boolean unit = bundle % 2 == 0 && to.maxAbs() > 0;
                    setRay(i, o, unit ? to.normalized() : to, unit ? (float) to.length() : 1);
                }
                assertBlocked(geometry, tracer);
            }
        }
    }

    @Property
    void parallelShadowAndReflectionRays_withCandidates_sameOcclusion(@ForAll @IntRange(min = 1, max = 60) int shapes,
            @ForAll long seed) {
        Geometry geometry = Geometry.of(seed % 2 == 0 ? TraceScenes.randomScene(shapes, seed) : TraceScenes.cloud(shapes, seed));
        RandomRays rays = new RandomRays(geometry, seed);
        Random random = new Random(seed);
        for (int bundle = 0; bundle < 8; bundle++) {
            Vec3 d = rays.direction(Vec3.ZERO);
            float[][] points = points(rays, seed + bundle, RayPacket.WIDTH);
            beam.clear();
            beam.addOrigins(new LaneTracer(geometry).bounds(points[0], points[1], points[2], 0, RayPacket.WIDTH));
            boolean parallel = bundle % 2 == 0;
            if (parallel) {
                beam.aimAlong(d);
            }
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Vec3 jitter = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()).times(0.1 * d.maxAbs());
                Vec3 own = parallel ? d : d.plus(jitter);
                if (!parallel) {
                    beam.addDirection(own.x(), own.y(), own.z());
                }
                setRay(i, new Vec3(points[0][i], points[1][i], points[2][i]), own, Double.POSITIVE_INFINITY);
            }
            candidates.collect(geometry.bvh(), beam);
            assertBlocked(geometry, new PacketTracer(geometry));
        }
    }

    /** Returns points, often all in one small region, as those of a tile. */
    private static float[][] points(RandomRays rays, long seed, int count) {
        Random random = new Random(seed);
        float[][] points = new float[3][count];
        Vec3 center = rays.origin();
        for (int i = 0; i < count; i++) {
            Vec3 o = seed % 3 == 0 ? rays.origin() : new Vec3(
                    center.x() * (1 - 0.05 * random.nextDouble()), center.y() * (1 - 0.05 * random.nextDouble()), center.z());
            points[0][i] = (float) o.x();
            points[1][i] = (float) o.y();
            points[2][i] = (float) o.z();
        }
        return points;
    }

    private void setRay(int i, Vec3 o, Vec3 d, double limit) {
        packet.ox[i] = o.x();
        packet.oy[i] = o.y();
        packet.oz[i] = o.z();
        packet.dx[i] = d.x();
        packet.dy[i] = d.y();
        packet.dz[i] = d.z();
        packet.limit[i] = limit;
    }

    private void assertBlocked(Geometry geometry, PacketTracer tracer) {
        int expected = 0;
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            expected |= BruteForce.isBlocked(geometry, RandomRays.ray(packet, i), packet.limit[i]) ? 1 << i : 0;
        }
        assertThat(tracer.findBlocked(packet, RayPacket.WIDTH, candidates)).isEqualTo(expected);
        assertThat(!candidates.isEmpty() || expected == 0).isTrue();
    }

    @Test
    void beamUpFromRoof_hasNoCandidates() {
        Geometry geometry = Geometry.of(TraceScenes.house());
        Vec3 roof = geometry.toRenderSpace(new Vec3(0, 6, 0));
        beam.clear();
        beam.addOrigin(roof.x(), roof.y(), roof.z());
        beam.aimAt(roof.plus(new Vec3(1, 10, 1)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.isEmpty()).isTrue();
    }

    @Test
    void shapeBeyondLight_isNoCandidate() {
        Geometry geometry = Geometry.of(TraceScenes.balls());
        Vec3 from = geometry.toRenderSpace(new Vec3(0, 8, 0));
        beam.clear();
        beam.addOrigin(from.x(), from.y(), from.z());
        beam.aimAt(geometry.toRenderSpace(new Vec3(0, 3, 0)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.isEmpty()).isTrue();
        beam.aimAt(geometry.toRenderSpace(new Vec3(0, 1.5, 0)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.count).isEqualTo(1);
    }

    @Test
    void tileWithSmallShape_excludesOtherShapes() {
        Scene scene = TraceScenes.balls();
        Geometry geometry = Geometry.of(scene);
        new CameraRays(scene.camera(), new PictureSettings(256, 256, 1)).boundBeam(beam, 0, 224, 32, 32);
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.count).isEqualTo(1);
        assertThat(candidates.primitive[0]).isEqualTo(0);
    }
}

package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.solid.Form;
import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Picture;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** A beam may hold too many shapes, never too few: every packet of it gets the answer of all shapes. */
class CandidatesTest {
    private final RayPacket p = new RayPacket();
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();

    @Property
    void eyeRaysOfATile_meetTheSameAmongCandidates(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed) {
        Scene scene = seed % 2 == 0 ? TraceScenes.wild(shapes, seed) : TraceScenes.cloud(shapes, seed);
        Geometry geometry = new Geometry(scene);
        PacketTracer tracer = new PacketTracer(geometry);
        CameraRays camera = new CameraRays(scene.camera(), new Picture(256, 256, 1));
        Random random = new Random(seed);
        for (int tile = 0; tile < 8; tile++) {
            int left = 16 * random.nextInt(14);
            int top = random.nextInt(224);
            camera.sweep(beam, left, top, 32, 32);
            candidates.collect(geometry.bvh(), beam);
            for (int y = top; y < top + 32; y += 1 + random.nextInt(8)) {
                TraceRays.eye(camera, left + 16 * random.nextInt(2) / RayPacket.WIDTH * RayPacket.WIDTH, y, p);
                tracer.nearest(p, RayPacket.WIDTH, candidates);
                for (int i = 0; i < RayPacket.WIDTH; i++) {
                    Ray ray = TraceRays.ray(p, i);
                    int expected = geometry.nearestOfAll(ray);
                    assertThat(p.primitive[i]).isEqualTo(expected);
                    assertThat(PacketTracerTest.bits(p.t[i]))
                            .isEqualTo(PacketTracerTest.bits(expected < 0 ? Form.MISS : geometry.distance(expected, ray)));
                }
            }
        }
    }

    @Property
    void shadowRaysToAPoint_areBlockedTheSameByCandidates(@ForAll @IntRange(min = 1, max = 60) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(seed % 2 == 0 ? TraceScenes.wild(shapes, seed) : TraceScenes.cloud(shapes, seed));
        TraceRays rays = new TraceRays(geometry, seed);
        for (int bundle = 0; bundle < 8; bundle++) {
            Vec3 light = rays.origin();
            float[][] points = points(rays, seed + bundle, 5 * RayPacket.WIDTH);
            beam.clear();
            beam.origins(new LaneTracer(geometry).box(points[0], points[1], points[2], 0, points[0].length));
            beam.towards(light);
            candidates.collect(geometry.bvh(), beam);
            PacketTracer tracer = new PacketTracer(geometry);
            for (int first = 0; first < points[0].length; first += RayPacket.WIDTH) {
                for (int i = 0; i < RayPacket.WIDTH; i++) {
                    Vec3 o = new Vec3(points[0][first + i], points[1][first + i], points[2][first + i]);
                    Vec3 to = light.minus(o);
                    boolean unit = bundle % 2 == 0 && to.maxAbs() > 0;
                    set(i, o, unit ? to.normalized() : to, unit ? (float) to.length() : 1);
                }
                assertBlocked(geometry, tracer);
            }
        }
    }

    @Property
    void parallelShadowRaysAndReflections_areBlockedTheSameByCandidates(@ForAll @IntRange(min = 1, max = 60) int shapes,
            @ForAll long seed) {
        Geometry geometry = new Geometry(seed % 2 == 0 ? TraceScenes.wild(shapes, seed) : TraceScenes.cloud(shapes, seed));
        TraceRays rays = new TraceRays(geometry, seed);
        Random random = new Random(seed);
        for (int bundle = 0; bundle < 8; bundle++) {
            Vec3 d = rays.direction(Vec3.ZERO);
            float[][] points = points(rays, seed + bundle, RayPacket.WIDTH);
            beam.clear();
            beam.origins(new LaneTracer(geometry).box(points[0], points[1], points[2], 0, RayPacket.WIDTH));
            boolean parallel = bundle % 2 == 0;
            if (parallel) {
                beam.along(d);
            }
            for (int i = 0; i < RayPacket.WIDTH; i++) {
                Vec3 jitter = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()).times(0.1 * d.maxAbs());
                Vec3 own = parallel ? d : d.plus(jitter);
                if (!parallel) {
                    beam.direction(own.x(), own.y(), own.z());
                }
                set(i, new Vec3(points[0][i], points[1][i], points[2][i]), own, Double.POSITIVE_INFINITY);
            }
            candidates.collect(geometry.bvh(), beam);
            assertBlocked(geometry, new PacketTracer(geometry));
        }
    }

    /** Often all in one small region, as the points of a tile are. */
    private static float[][] points(TraceRays rays, long seed, int count) {
        Random random = new Random(seed);
        float[][] points = new float[3][count];
        Vec3 centre = rays.origin();
        for (int i = 0; i < count; i++) {
            Vec3 o = seed % 3 == 0 ? rays.origin() : new Vec3(
                    centre.x() * (1 - 0.05 * random.nextDouble()), centre.y() * (1 - 0.05 * random.nextDouble()), centre.z());
            points[0][i] = (float) o.x();
            points[1][i] = (float) o.y();
            points[2][i] = (float) o.z();
        }
        return points;
    }

    private void set(int i, Vec3 o, Vec3 d, double limit) {
        p.ox[i] = o.x();
        p.oy[i] = o.y();
        p.oz[i] = o.z();
        p.dx[i] = d.x();
        p.dy[i] = d.y();
        p.dz[i] = d.z();
        p.limit[i] = limit;
    }

    private void assertBlocked(Geometry geometry, PacketTracer tracer) {
        int expected = 0;
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            expected |= geometry.blockedByAny(TraceRays.ray(p, i), p.limit[i]) ? 1 << i : 0;
        }
        assertThat(tracer.blocked(p, RayPacket.WIDTH, candidates)).isEqualTo(expected);
        assertThat(!candidates.isEmpty() || expected == 0).isTrue();
    }

    @Test
    void beamUpwardsFromTheRoof_hasNoCandidates() {
        Geometry geometry = new Geometry(TraceScenes.house());
        Vec3 roof = geometry.toRenderSpace(new Vec3(0, 6, 0));
        beam.clear();
        beam.origin(roof.x(), roof.y(), roof.z());
        beam.towards(roof.plus(new Vec3(1, 10, 1)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.isEmpty()).isTrue();
    }

    @Test
    void shapeBehindTheLight_isNoCandidate() {
        Geometry geometry = new Geometry(TraceScenes.balls());
        Vec3 from = geometry.toRenderSpace(new Vec3(0, 8, 0));
        beam.clear();
        beam.origin(from.x(), from.y(), from.z());
        beam.towards(geometry.toRenderSpace(new Vec3(0, 3, 0)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.isEmpty()).isTrue();
        beam.towards(geometry.toRenderSpace(new Vec3(0, 1.5, 0)));
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.count).isEqualTo(1);
    }

    @Test
    void tileOfASmallShape_doesNotHoldTheOthers() {
        Scene scene = TraceScenes.balls();
        Geometry geometry = new Geometry(scene);
        new CameraRays(scene.camera(), new Picture(256, 256, 1)).sweep(beam, 0, 224, 32, 32);
        candidates.collect(geometry.bvh(), beam);
        assertThat(candidates.count).isEqualTo(1);
        assertThat(candidates.primitive[0]).isEqualTo(0);
    }
}

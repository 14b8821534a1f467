package lightning.render.engine.lanes;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** Benchmark of each stage of tracing in nanoseconds per ray, scalar and in packets. Run it alone, on a quiet machine. */
final class TraceBench {
    private static final int SIZE = 512;
    private static final int TILE = 32;
    private static final int W = RayPacket.WIDTH;
    private static final int RUNS = 15;
    private static long sink;

    private final Geometry geometry;
    private final CameraRays camera;
    private final PacketTracer tracer;
    private final RayPacket packet = new RayPacket();
    private final SurfacePacket surfaces = new SurfacePacket();
    private final double[] rays = new double[SIZE * SIZE * 7];
    private int shadowRays;
    private final int[] tileStart = new int[SIZE * SIZE / (TILE * TILE) + 1];
    private int tiles;
    private Vec3 light;
    private final RayBeam[] shadowBeams = new RayBeam[tileStart.length];
    private final RayBeam beam = new RayBeam();
    private final CandidateList candidates = new CandidateList();

    private TraceBench(Scene scene, int few) {
        geometry = Geometry.of(scene);
        camera = new CameraRays(scene.camera(), new PictureSettings(SIZE, SIZE, 1));
        tracer = new PacketTracer(geometry.bvh(), few);
        prepareShadowRays(new Vec3(3, 7, 5));
    }

    private void prepareShadowRays(Vec3 light) {
        Vec3 l = geometry.toRenderSpace(light);
        this.light = l;
        for (int tile = 0; tile < SIZE * SIZE / (TILE * TILE); tile++) {
            tileStart[tiles++] = shadowRays;
            for (int n = 0; n < TILE * TILE; n += W) {
                RandomRays.loadEyeRays(camera, tile % (SIZE / TILE) * TILE + n % TILE, tile / (SIZE / TILE) * TILE + n / TILE, packet);
                tracer.findNearest(packet, W);
                tracer.writeSurfaces(packet, W, surfaces);
                for (int i = 0; i < W; i++) {
                    Vec3 to = new Vec3(l.x() - surfaces.px[i], l.y() - surfaces.py[i], l.z() - surfaces.pz[i]);
                    if (packet.primitive[i] >= 0 && to.dot(new Vec3(surfaces.nx[i], surfaces.ny[i], surfaces.nz[i])) > 0) {
                        Vec3 d = to.normalized();
                        double[] ray = {surfaces.px[i], surfaces.py[i], surfaces.pz[i], d.x(), d.y(), d.z(), to.length()};
                        System.arraycopy(ray, 0, rays, 7 * shadowRays++, 7);
                    }
                }
            }
        }
        tileStart[tiles++] = shadowRays;
        for (int tile = 0; tile + 1 < tiles; tile++) {
            shadowBeams[tile] = new RayBeam();
            for (int i = tileStart[tile]; i < tileStart[tile + 1]; i++) {
                shadowBeams[tile].addOrigin(rays[7 * i], rays[7 * i + 1], rays[7 * i + 2]);
            }
        }
    }

    private void eyeRays() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                RandomRays.loadEyeRays(camera, x, y, packet);
                sink += (long) packet.dx[3];
            }
        }
    }

    private void eyeRaysAndNearest() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                RandomRays.loadEyeRays(camera, x, y, packet);
                tracer.findNearest(packet, W);
                sink += packet.primitive[3];
            }
        }
    }

    private void tileEyeRaysAndNearest() {
        for (int tile = 0; tile < SIZE; tile += TILE) {
            for (int left = 0; left < SIZE; left += TILE) {
                camera.boundBeam(beam, left, tile, TILE, TILE);
                candidates.collect(geometry.bvh(), beam);
                for (int y = tile; y < tile + TILE; y++) {
                    for (int x = left; x < left + TILE; x += W) {
                        RandomRays.loadEyeRays(camera, x, y, packet);
                        tracer.findNearest(packet, W, candidates);
                        sink += packet.primitive[3];
                    }
                }
            }
        }
    }

    private void tileFillAndBlocked() {
        for (int tile = 0; tile + 1 < tiles; tile++) {
            int first = tileStart[tile];
            int end = tileStart[tile + 1];
            RayBeam beam = shadowBeams[tile];
            beam.aimAt(light);
            candidates.collect(geometry.bvh(), beam);
            for (int i = first; i < end && !candidates.isEmpty(); i += W) {
                int live = Math.min(W, end - i);
                load(i, live);
                sink += tracer.findBlocked(packet, live, candidates);
            }
        }
    }

    private void eyeRaysToSurfaces() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                RandomRays.loadEyeRays(camera, x, y, packet);
                tracer.findNearest(packet, W);
                tracer.writeSurfaces(packet, W, surfaces);
                sink += (long) surfaces.nx[3];
            }
        }
    }

    private void scalarNearest() {
        for (int y = 0; y < SIZE; y += 4) {
            for (int x = 0; x < SIZE; x++) {
                sink += geometry.bvh().nearest(camera.pixelRay(x, y));
            }
        }
    }

    private void scalarBlocked() {
        for (int i = 0; i < shadowRays / 4; i++) {
            int r = 7 * i;
            Ray ray = new Ray(new Vec3(rays[r], rays[r + 1], rays[r + 2]), new Vec3(rays[r + 3], rays[r + 4], rays[r + 5]));
            sink += geometry.bvh().isBlocked(ray, rays[r + 6]) ? 1 : 0;
        }
    }

    private void fill() {
        for (int i = 0; i < shadowRays; i += W) {
            load(i, Math.min(W, shadowRays - i));
            sink += (long) packet.limit[3];
        }
    }

    private void fillAndBlocked() {
        for (int i = 0; i < shadowRays; i += W) {
            int live = Math.min(W, shadowRays - i);
            load(i, live);
            sink += tracer.findBlocked(packet, live);
        }
    }

    private void load(int first, int live) {
        for (int i = 0; i < live; i++) {
            int r = 7 * (first + i);
            packet.ox[i] = rays[r];
            packet.oy[i] = rays[r + 1];
            packet.oz[i] = rays[r + 2];
            packet.dx[i] = rays[r + 3];
            packet.dy[i] = rays[r + 4];
            packet.dz[i] = rays[r + 5];
            packet.limit[i] = rays[r + 6];
        }
    }

    private static double measureNanos(Runnable run, double rays) {
        double[] times = new double[RUNS];
        for (int i = 0; i < RUNS; i++) {
            long start = System.nanoTime();
            run.run();
            times[i] = (System.nanoTime() - start) / rays;
        }
        Arrays.sort(times);
        return times[RUNS / 2];
    }

    private static void report(String name, Scene scene, int few) {
        TraceBench b = new TraceBench(scene, few);
        double rays = SIZE * SIZE;
        for (int i = 0; i < 3; i++) {
            b.eyeRaysToSurfaces();
            b.fillAndBlocked();
            b.tileEyeRaysAndNearest();
            b.tileFillAndBlocked();
        }
        com.sun.management.ThreadMXBean mx = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        double eye = measureNanos(b::eyeRays, rays);
        double nearest = measureNanos(b::eyeRaysAndNearest, rays);
        long before = mx.getThreadAllocatedBytes(Thread.currentThread().threadId());
        double surface = measureNanos(b::eyeRaysToSurfaces, rays);
        double tileNearest = measureNanos(b::tileEyeRaysAndNearest, rays);
        double tileBlocked = measureNanos(b::tileFillAndBlocked, b.shadowRays);
        double fill = measureNanos(b::fill, b.shadowRays);
        double blocked = measureNanos(b::fillAndBlocked, b.shadowRays);
        long bytes = mx.getThreadAllocatedBytes(Thread.currentThread().threadId()) - before;
        double scalar = measureNanos(b::scalarNearest, rays / 4);
        double scalarBlocked = measureNanos(b::scalarBlocked, b.shadowRays / 4);
        System.out.printf(Locale.ROOT,
                "%-12s few %3d | eye %5.2f nearest %6.2f surface %5.2f blocked %6.2f (fill %4.2f) | tiles nearest %5.2f blocked with fill %5.2f | scalar nearest %6.1f blocked %6.1f | bytes/ray %.2f%n",
                name, few, eye, nearest - eye, surface - nearest, blocked - fill, fill, tileNearest - eye, tileBlocked, scalar,
                scalarBlocked, bytes / (RUNS * rays));
    }

    public static void main(String[] args) {
        for (int round = 0; round < 2; round++) {
            report("balls", TraceScenes.balls(), PacketTracer.MAX_LINEAR_PRIMITIVES);
            report("bird", TraceScenes.bird(), PacketTracer.MAX_LINEAR_PRIMITIVES);
            report("bird", TraceScenes.bird(), 0);
            report("cloud 40", TraceScenes.cloud(40, 1), PacketTracer.MAX_LINEAR_PRIMITIVES);
            report("cloud 40", TraceScenes.cloud(40, 1), 0);
            report("house", TraceScenes.house(), PacketTracer.MAX_LINEAR_PRIMITIVES);
            report("cloud 1000", TraceScenes.cloud(1000, 1), PacketTracer.MAX_LINEAR_PRIMITIVES);
            report("cloud 100k", TraceScenes.cloud(100_000, 1), PacketTracer.MAX_LINEAR_PRIMITIVES);
        }
        System.out.println(sink);
    }
}

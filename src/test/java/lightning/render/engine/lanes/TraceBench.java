package lightning.render.engine.lanes;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Picture;
import lightning.scene.Scene;

/** Nanoseconds per ray of each stage of tracing, scalar beside packets. Run it by itself, on a quiet machine. */
final class TraceBench {
    private static final int SIZE = 512;
    private static final int TILE = 32;
    private static final int W = RayPacket.WIDTH;
    private static final int RUNS = 15;
    private static long sink;

    private final Geometry geometry;
    private final CameraRays camera;
    private final PacketTracer tracer;
    private final RayPacket p = new RayPacket();
    private final SurfacePacket out = new SurfacePacket();
    private final double[] rays = new double[SIZE * SIZE * 7];
    private int shadowRays;
    private final int[] tileStart = new int[SIZE * SIZE / (TILE * TILE) + 1];
    private int tiles;
    private Vec3 light;
    private final Beam[] shadowBeams = new Beam[tileStart.length];
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();

    private TraceBench(Scene scene, int few) {
        geometry = new Geometry(scene);
        camera = new CameraRays(scene.camera(), new Picture(SIZE, SIZE, 1));
        tracer = new PacketTracer(geometry.bvh(), few);
        shadows(new Vec3(3, 7, 5));
    }

    private void shadows(Vec3 light) {
        Vec3 l = geometry.toRenderSpace(light);
        this.light = l;
        for (int tile = 0; tile < SIZE * SIZE / (TILE * TILE); tile++) {
            tileStart[tiles++] = shadowRays;
            for (int n = 0; n < TILE * TILE; n += W) {
                TraceRays.eye(camera, tile % (SIZE / TILE) * TILE + n % TILE, tile / (SIZE / TILE) * TILE + n / TILE, p);
                tracer.nearest(p, W);
                tracer.surfaces(p, W, out);
                for (int i = 0; i < W; i++) {
                    Vec3 to = new Vec3(l.x() - out.px[i], l.y() - out.py[i], l.z() - out.pz[i]);
                    if (p.primitive[i] >= 0 && to.dot(new Vec3(out.nx[i], out.ny[i], out.nz[i])) > 0) {
                        Vec3 d = to.normalized();
                        double[] ray = {out.px[i], out.py[i], out.pz[i], d.x(), d.y(), d.z(), to.length()};
                        System.arraycopy(ray, 0, rays, 7 * shadowRays++, 7);
                    }
                }
            }
        }
        tileStart[tiles++] = shadowRays;
        for (int tile = 0; tile + 1 < tiles; tile++) {
            shadowBeams[tile] = new Beam();
            for (int i = tileStart[tile]; i < tileStart[tile + 1]; i++) {
                shadowBeams[tile].origin(rays[7 * i], rays[7 * i + 1], rays[7 * i + 2]);
            }
        }
    }

    private void eyes() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                TraceRays.eye(camera, x, y, p);
                sink += (long) p.dx[3];
            }
        }
    }

    private void eyesAndNearest() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                TraceRays.eye(camera, x, y, p);
                tracer.nearest(p, W);
                sink += p.primitive[3];
            }
        }
    }

    private void eyesAndNearestOfTiles() {
        for (int tile = 0; tile < SIZE; tile += TILE) {
            for (int left = 0; left < SIZE; left += TILE) {
                camera.sweep(beam, left, tile, TILE, TILE);
                candidates.collect(geometry.bvh(), beam);
                for (int y = tile; y < tile + TILE; y++) {
                    for (int x = left; x < left + TILE; x += W) {
                        TraceRays.eye(camera, x, y, p);
                        tracer.nearest(p, W, candidates);
                        sink += p.primitive[3];
                    }
                }
            }
        }
    }

    private void fillAndBlockedOfTiles() {
        for (int tile = 0; tile + 1 < tiles; tile++) {
            int first = tileStart[tile];
            int end = tileStart[tile + 1];
            Beam beam = shadowBeams[tile];
            beam.towards(light);
            candidates.collect(geometry.bvh(), beam);
            for (int i = first; i < end && !candidates.isEmpty(); i += W) {
                int live = Math.min(W, end - i);
                load(i, live);
                sink += tracer.blocked(p, live, candidates);
            }
        }
    }

    private void eyesToSurfaces() {
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x += W) {
                TraceRays.eye(camera, x, y, p);
                tracer.nearest(p, W);
                tracer.surfaces(p, W, out);
                sink += (long) out.nx[3];
            }
        }
    }

    private void scalarNearest() {
        for (int y = 0; y < SIZE; y += 4) {
            for (int x = 0; x < SIZE; x++) {
                sink += geometry.bvh().nearest(camera.through(x, y));
            }
        }
    }

    private void scalarBlocked() {
        for (int i = 0; i < shadowRays / 4; i++) {
            int r = 7 * i;
            Ray ray = new Ray(new Vec3(rays[r], rays[r + 1], rays[r + 2]), new Vec3(rays[r + 3], rays[r + 4], rays[r + 5]));
            sink += geometry.bvh().blocked(ray, rays[r + 6]) ? 1 : 0;
        }
    }

    private void fill() {
        for (int i = 0; i < shadowRays; i += W) {
            load(i, Math.min(W, shadowRays - i));
            sink += (long) p.limit[3];
        }
    }

    private void fillAndBlocked() {
        for (int i = 0; i < shadowRays; i += W) {
            int live = Math.min(W, shadowRays - i);
            load(i, live);
            sink += tracer.blocked(p, live);
        }
    }

    private void load(int first, int live) {
        for (int i = 0; i < live; i++) {
            int r = 7 * (first + i);
            p.ox[i] = rays[r];
            p.oy[i] = rays[r + 1];
            p.oz[i] = rays[r + 2];
            p.dx[i] = rays[r + 3];
            p.dy[i] = rays[r + 4];
            p.dz[i] = rays[r + 5];
            p.limit[i] = rays[r + 6];
        }
    }

    private static double nanos(Runnable run, double rays) {
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
            b.eyesToSurfaces();
            b.fillAndBlocked();
            b.eyesAndNearestOfTiles();
            b.fillAndBlockedOfTiles();
        }
        com.sun.management.ThreadMXBean mx = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        double eye = nanos(b::eyes, rays);
        double nearest = nanos(b::eyesAndNearest, rays);
        long before = mx.getThreadAllocatedBytes(Thread.currentThread().threadId());
        double surface = nanos(b::eyesToSurfaces, rays);
        double tileNearest = nanos(b::eyesAndNearestOfTiles, rays);
        double tileBlocked = nanos(b::fillAndBlockedOfTiles, b.shadowRays);
        double fill = nanos(b::fill, b.shadowRays);
        double blocked = nanos(b::fillAndBlocked, b.shadowRays);
        long bytes = mx.getThreadAllocatedBytes(Thread.currentThread().threadId()) - before;
        double scalar = nanos(b::scalarNearest, rays / 4);
        double scalarBlocked = nanos(b::scalarBlocked, b.shadowRays / 4);
        System.out.printf(Locale.ROOT,
                "%-12s few %3d | eye %5.2f nearest %6.2f surface %5.2f blocked %6.2f (fill %4.2f) | tiles nearest %5.2f blocked with fill %5.2f | scalar nearest %6.1f blocked %6.1f | bytes/ray %.2f%n",
                name, few, eye, nearest - eye, surface - nearest, blocked - fill, fill, tileNearest - eye, tileBlocked, scalar,
                scalarBlocked, bytes / (RUNS * rays));
    }

    public static void main(String[] args) {
        for (int round = 0; round < 2; round++) {
            report("balls", TraceScenes.balls(), PacketTracer.FEW);
            report("bird", TraceScenes.bird(), PacketTracer.FEW);
            report("bird", TraceScenes.bird(), 0);
            report("cloud 40", TraceScenes.cloud(40, 1), PacketTracer.FEW);
            report("cloud 40", TraceScenes.cloud(40, 1), 0);
            report("house", TraceScenes.house(), PacketTracer.FEW);
            report("cloud 1000", TraceScenes.cloud(1000, 1), PacketTracer.FEW);
            report("cloud 100k", TraceScenes.cloud(100_000, 1), PacketTracer.FEW);
        }
        System.out.println(sink);
    }
}

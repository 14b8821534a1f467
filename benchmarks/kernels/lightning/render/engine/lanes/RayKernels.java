package lightning.render.engine.lanes;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.format.jen.JenReader;
import lightning.render.engine.KernelAgreement;
import lightning.render.trace.BruteForce;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Benchmark in nanoseconds per ray of a scene: packets of a tile against the candidates of its beam. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class RayKernels {
    private static final int SIZE = 256;
    private static final int TILE = 32;
    private static final int EYE_RAYS = SIZE * SIZE;
    private static final int SHADOW_RAYS = 16384;
    private static final int W = RayPacket.WIDTH;

    @Param({"bird", "balls", "house"})
    public String scene;

    /** Shadow rays of one tile to the first light with a position. */
    private record ShadowTile(RayBeam beam, List<Ray> rays) {}

    private final RayPacket packet = new RayPacket();
    private final RayBeam beam = new RayBeam();
    private final CandidateList candidates = new CandidateList();
    private final List<ShadowTile> shadows = new ArrayList<>();
    private final int[] nearest = new int[EYE_RAYS];
    private final boolean[] blocked = new boolean[SHADOW_RAYS];
    private Geometry geometry;
    private CameraRays camera;
    private PacketTracer tracer;
    private Vec3 light;

    /** Reads the scene, and fails if a kernel disagrees with the scalar code. */
    @Setup
    public void prepare() throws Exception {
        Scene read = JenReader.read(Path.of("scenes", scene + ".jen")).scene();
        geometry = Geometry.of(read);
        camera = new CameraRays(read.camera(), new PictureSettings(SIZE, SIZE, 0));
        tracer = new PacketTracer(geometry);
        light = geometry.toRenderSpace(read.lights().stream().filter(l -> l.type().hasPosition()).findFirst().orElseThrow().position());
        primary();
        for (int i = 0; i < EYE_RAYS; i++) {
            KernelAgreement.requireEqual(nearest[i] == BruteForce.nearest(geometry, camera.pixelRay(i % SIZE, i / SIZE)), "primary ray", i);
        }
        collectShadowRays();
        shadow();
        int at = 0;
        for (ShadowTile tile : shadows) {
            for (Ray ray : tile.rays) {
                KernelAgreement.requireEqual(blocked[at] == BruteForce.isBlocked(geometry, ray, 1), "shadow ray", at++);
            }
        }
    }

    private void collectShadowRays() {
        int count = 0;
        for (int tile = 0; tile < EYE_RAYS / (TILE * TILE) && count < SHADOW_RAYS; tile++) {
            ShadowTile rays = new ShadowTile(new RayBeam(), new ArrayList<>());
            for (int i = 0; i < TILE * TILE && count < SHADOW_RAYS; i++) {
                int x = tile % (SIZE / TILE) * TILE + i % TILE;
                int y = tile / (SIZE / TILE) * TILE + i / TILE;
                if (nearest[y * SIZE + x] >= 0) {
                    SurfacePoint point = geometry.surface(nearest[y * SIZE + x], camera.pixelRay(x, y));
                    Vec3 from = new Vec3(point.px(), point.py(), point.pz());
                    Vec3 shadowRay = light.minus(from);
                    if (shadowRay.dot(new Vec3(point.nx(), point.ny(), point.nz())) > 0) {
                        rays.rays.add(new Ray(from, shadowRay));
                        rays.beam.addOrigin(from.x(), from.y(), from.z());
                        count++;
                    }
                }
            }
            shadows.add(rays);
        }
        if (count < SHADOW_RAYS) {
            throw new IllegalStateException(scene + " has only " + count + " shadow rays at this size");
        }
    }

    /** Traces camera rays to the nearest shape. */
    @Benchmark
    @OperationsPerInvocation(EYE_RAYS)
    public int[] primary() {
        for (int top = 0; top < SIZE; top += TILE) {
            for (int left = 0; left < SIZE; left += TILE) {
                camera.boundBeam(beam, left, top, TILE, TILE);
                candidates.collect(geometry.bvh(), beam);
                for (int y = top; y < top + TILE; y++) {
                    for (int x = left; x < left + TILE; x += W) {
                        eye(camera, x, y);
                        tracer.findNearest(packet, W, candidates);
                        System.arraycopy(packet.primitive, 0, nearest, y * SIZE + x, W);
                    }
                }
            }
        }
        return nearest;
    }

    private void eye(CameraRays camera, int column, int line) {
        Arrays.fill(packet.ox, 0);
        Arrays.fill(packet.oy, 0);
        Arrays.fill(packet.oz, 0);
        CameraRayLanes.pixelRays(camera, column, line, packet.dx, packet.dy, packet.dz, 0);
    }

    /** Returns whether a light is blocked, including the time to load the rays. */
    @Benchmark
    @OperationsPerInvocation(SHADOW_RAYS)
    public boolean[] shadow() {
        int at = 0;
        for (ShadowTile tile : shadows) {
            tile.beam.aimAt(light);
            candidates.collect(geometry.bvh(), tile.beam);
            for (int i = 0; i < tile.rays.size(); i += W) {
                int live = Math.min(W, tile.rays.size() - i);
                for (int lane = 0; lane < live; lane++) {
                    PacketRays.setRay(packet, lane, tile.rays.get(i + lane), 1);
                }
                int mask = candidates.isEmpty() ? 0 : tracer.findBlocked(packet, live, candidates);
                for (int lane = 0; lane < live; lane++) {
                    blocked[at++] = (mask >>> lane & 1) != 0;
                }
            }
        }
        return blocked;
    }
}

package lightning.render.trace.mesh;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import lightning.bench.mesh.BumpySphere;
import lightning.bench.mesh.RaySet;
import lightning.bench.mesh.RaySetGenerator;
import lightning.render.engine.KernelAgreement;
import lightning.render.trace.solid.LaneRays;
import lightning.scene.node.Mesh;
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

/** Benchmark in nanoseconds per ray of a bumpy ball: groups of 64 rays of each kind, including the time to load them. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class MeshKernels {
    private static final int RAYS = 1 << 14;
    private static final int SIZE = 256;
    private static final int GROUP = MeshPacketTraversal.PACKETS * LaneRays.WIDTH;
    private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    @Param({"10000", "1000000"})
    public int triangles;

    @Param
    public RaySet.Kind kind;

    private final MeshPacketTraversal packets = new MeshPacketTraversal();
    private final LaneRays[] rays = new LaneRays[RAYS / LaneRays.WIDTH];
    private final double[] limits = new double[LaneRays.WIDTH];
    private final int[] hitFlags = new int[RAYS];
    private MeshSolid solid;
    private boolean anyHit;

    /** Selects rays from the center of an image, and fails if a kernel disagrees with single rays. */
    @Setup
    public void prepare() {
        Mesh mesh = BumpySphere.of(triangles);
        solid = new MeshSolid(mesh);
        RaySet set = new RaySetGenerator(solid, SIZE, SIZE).of(kind);
        int first = (set.count() - RAYS) / 2 / GROUP * GROUP;
        if (first < 0) {
            throw new IllegalStateException("only " + set.count() + " rays");
        }
        anyHit = kind == RaySet.Kind.SHADOW;
        Arrays.fill(limits, anyHit ? 1 : Double.POSITIVE_INFINITY);
        double[] r = new double[6];
        for (int i = 0; i < RAYS; i++) {
            for (int k = 0; k < 6; k++) {
                r[k] = set.columns()[k][first + i];
            }
            addRay(i, r);
        }
        search();
        MeshRayQuery probe = new MeshRayQuery();
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            LaneRays p = rays[i / LaneRays.WIDTH];
            int k = i % LaneRays.WIDTH;
            probe.setRay(solid, p.ox[k], p.oy[k], p.oz[k], p.dx[k], p.dy[k], p.dz[k]);
            int expected =
                    anyHit ? (probe.isBlocked(1) ? 0 : -1) : probe.nearest(Double.POSITIVE_INFINITY) < MeshRay.MISS ? probe.triangle() : -1;
            KernelAgreement.requireEqual(hitFlags[i] == expected, kind.label(), i);
            hits += expected < 0 ? 0 : 1;
        }
        if (hits == 0 || hits == RAYS) {
            throw new IllegalStateException(hits + " of " + RAYS + " rays hit the ball");
        }
    }

    private void addRay(int i, double[] r) {
        if (i % LaneRays.WIDTH == 0) {
            rays[i / LaneRays.WIDTH] = new LaneRays();
        }
        LaneRays p = rays[i / LaneRays.WIDTH];
        int k = i % LaneRays.WIDTH;
        p.ox[k] = r[0];
        p.oy[k] = r[1];
        p.oz[k] = r[2];
        p.dx[k] = r[3];
        p.dy[k] = r[4];
        p.dz[k] = r[5];
    }

    /** Finds the triangle that each ray hits first; for shadow rays, tests if there is one. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public int[] search() {
        for (int n = 0; n < RAYS; n += GROUP) {
            packets.beginGroup(solid, IDENTITY, 0);
            for (int i = n; i < n + GROUP; i += LaneRays.WIDTH) {
                packets.addPacket(rays[i / LaneRays.WIDTH], -1 >>> -LaneRays.WIDTH, limits);
            }
            if (anyHit) {
                packets.findBlocked();
            } else {
                packets.findNearest();
            }
            for (int i = 0; i < GROUP; i++) {
                int k = i / LaneRays.WIDTH;
                boolean there = (packets.hitMask(k) >>> i % LaneRays.WIDTH & 1) != 0;
                hitFlags[n + i] = !there ? -1 : anyHit ? 0 : packets.triangle(k, i % LaneRays.WIDTH);
            }
        }
        return hitFlags;
    }
}

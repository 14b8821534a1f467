package lightning.render.trace.mesh;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import lightning.bench.mesh.BumpyBall;
import lightning.bench.mesh.RaySet;
import lightning.bench.mesh.RaySets;
import lightning.render.engine.Agreement;
import lightning.render.trace.solid.Rays;
import lightning.scene.Mesh;
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

/** Nanoseconds per ray of a bumpy ball: groups of 64 rays of each kind, loading them included. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class MeshKernels {
    private static final int RAYS = 1 << 14;
    private static final int SIZE = 256;
    private static final int GROUP = MeshPackets.PACKETS * Rays.WIDTH;
    private static final double[] SAME = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    @Param({"10000", "1000000"})
    public int triangles;

    @Param
    public RaySet.Kind kind;

    private final MeshPackets packets = new MeshPackets();
    private final Rays[] rays = new Rays[RAYS / Rays.WIDTH];
    private final double[] limits = new double[Rays.WIDTH];
    private final int[] met = new int[RAYS];
    private MeshSolid solid;
    private boolean any;

    /** Takes rays from the middle of a picture, and refuses a kernel that does not agree with a ray alone. */
    @Setup
    public void prepare() {
        Mesh mesh = BumpyBall.of(triangles);
        solid = new MeshSolid(mesh);
        RaySet set = new RaySets(solid, SIZE, SIZE).of(kind);
        int first = (set.count() - RAYS) / 2 / GROUP * GROUP;
        if (first < 0) {
            throw new IllegalStateException("only " + set.count() + " rays");
        }
        any = kind == RaySet.Kind.SHADOW;
        Arrays.fill(limits, any ? 1 : Double.POSITIVE_INFINITY);
        double[] r = new double[6];
        for (int i = 0; i < RAYS; i++) {
            for (int k = 0; k < 6; k++) {
                r[k] = set.column()[k][first + i];
            }
            put(i, r);
        }
        search();
        MeshProbe probe = new MeshProbe();
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            Rays p = rays[i / Rays.WIDTH];
            int k = i % Rays.WIDTH;
            probe.enter(solid, p.ox[k], p.oy[k], p.oz[k], p.dx[k], p.dy[k], p.dz[k]);
            int expected =
                    any ? (probe.blocked(1) ? 0 : -1) : probe.nearest(Double.POSITIVE_INFINITY) < MeshRay.MISS ? probe.triangle() : -1;
            Agreement.require(met[i] == expected, kind.label(), i);
            hits += expected < 0 ? 0 : 1;
        }
        if (hits == 0 || hits == RAYS) {
            throw new IllegalStateException(hits + " of " + RAYS + " rays meet the ball");
        }
    }

    private void put(int i, double[] r) {
        if (i % Rays.WIDTH == 0) {
            rays[i / Rays.WIDTH] = new Rays();
        }
        Rays p = rays[i / Rays.WIDTH];
        int k = i % Rays.WIDTH;
        p.ox[k] = r[0];
        p.oy[k] = r[1];
        p.oz[k] = r[2];
        p.dx[k] = r[3];
        p.dy[k] = r[4];
        p.dz[k] = r[5];
    }

    /** The triangle that each ray meets first; of ways to the light, whether there is one. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public int[] search() {
        for (int n = 0; n < RAYS; n += GROUP) {
            packets.begin(solid, SAME, 0);
            for (int i = n; i < n + GROUP; i += Rays.WIDTH) {
                packets.add(rays[i / Rays.WIDTH], -1 >>> -Rays.WIDTH, limits);
            }
            if (any) {
                packets.blocked();
            } else {
                packets.nearest();
            }
            for (int i = 0; i < GROUP; i++) {
                int k = i / Rays.WIDTH;
                boolean there = (packets.met(k) >>> i % Rays.WIDTH & 1) != 0;
                met[n + i] = !there ? -1 : any ? 0 : packets.triangle(k, i % Rays.WIDTH);
            }
        }
        return met;
    }
}

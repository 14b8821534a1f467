package lightning.bench.mesh;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.mesh.MeshPacketTraversal;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.LaneRays;

/** Tracer of ray sets with our vector lanes, on the calling thread. */
public final class LaneMeshTracer {
    private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final int RAYS_PER_GROUP = MeshPacketTraversal.PACKETS * LaneRays.WIDTH;
    private static final int ALL_LANES = -1 >>> -LaneRays.WIDTH;

    private static final VectorSpecies<Float> FLOATS =
            VectorSpecies.of(float.class, VectorShape.forBitSize(DoubleLanes.SPECIES.vectorBitSize() / 2));

    private final MeshSolid solid;
    private final MeshPacketTraversal packets = new MeshPacketTraversal();
    private final LaneRays rays = new LaneRays();
    private final double[] limits = new double[LaneRays.WIDTH];
    /** Number of hits, so that the compiler does not eliminate the search. */
    private int hits;

    public LaneMeshTracer(MeshSolid solid) {
        this.solid = solid;
    }

    /** Traces all rays of a set; returns milliseconds of processor time. */
    public double traceMs(RaySet set) {
        long start = THREADS.getCurrentThreadCpuTime();
        boolean isShadow = set.kind() == RaySet.Kind.SHADOW;
        Arrays.fill(limits, isShadow ? 1 : Double.POSITIVE_INFINITY);
        hits = 0;
        for (int n = 0; n < set.count(); n += RAYS_PER_GROUP) {
            packets.beginGroup(solid, IDENTITY, 0);
            int end = Math.min(n + RAYS_PER_GROUP, set.count());
            for (int i = n; i < end; i += LaneRays.WIDTH) {
                load(set, i);
                packets.addPacket(rays, ALL_LANES, limits);
            }
            if (isShadow) {
                packets.findBlocked();
            } else {
                packets.findNearest();
            }
            for (int k = 0; n + k * LaneRays.WIDTH < end; k++) {
                hits += Integer.bitCount(packets.hitMask(k));
            }
        }
        return (THREADS.getCurrentThreadCpuTime() - start) / 1e6;
    }

    private void load(RaySet set, int at) {
        load(set.columns()[0], at, rays.ox);
        load(set.columns()[1], at, rays.oy);
        load(set.columns()[2], at, rays.oz);
        load(set.columns()[3], at, rays.dx);
        load(set.columns()[4], at, rays.dy);
        load(set.columns()[5], at, rays.dz);
    }

    private static void load(float[] from, int at, double[] to) {
        for (int i = 0; i < LaneRays.WIDTH; i += DoubleLanes.COUNT) {
            ((DoubleVector) FloatVector.fromArray(FLOATS, from, at + i).convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0))
                    .intoArray(to, i);
        }
    }
}

package lightning.bench.mesh;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import lightning.render.trace.mesh.MeshPackets;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.solid.Rays;

/** Traces sets of rays by our lanes, on the calling thread. */
public final class OwnSearch {
    private static final double[] SAME = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final int GROUP = MeshPackets.PACKETS * Rays.WIDTH;
    private static final int ALL = -1 >>> -Rays.WIDTH;

    private final MeshSolid solid;
    private final MeshPackets packets = new MeshPackets();
    private final Rays rays = new Rays();
    private final double[] limits = new double[Rays.WIDTH];
    /** The rays that hit something: counted so that the search is not left out. */
    private int hits;

    public OwnSearch(MeshSolid solid) {
        this.solid = solid;
    }

    /** Traces all rays of a set; milliseconds of processor time. */
    public double ms(RaySet set) {
        long start = THREADS.getCurrentThreadCpuTime();
        boolean any = set.kind() == RaySet.Kind.SHADOW;
        Arrays.fill(limits, any ? 1 : Double.POSITIVE_INFINITY);
        hits = 0;
        for (int n = 0; n < set.count(); n += GROUP) {
            packets.begin(solid, SAME, 0);
            int end = Math.min(n + GROUP, set.count());
            for (int i = n; i < end; i += Rays.WIDTH) {
                load(set, i);
                packets.add(rays, ALL, limits);
            }
            if (any) {
                packets.blocked();
            } else {
                packets.nearest();
            }
            for (int k = 0; n + k * Rays.WIDTH < end; k++) {
                hits += Integer.bitCount(packets.met(k));
            }
        }
        return (THREADS.getCurrentThreadCpuTime() - start) / 1e6;
    }

    private void load(RaySet set, int at) {
        load(set.column()[0], at, rays.ox);
        load(set.column()[1], at, rays.oy);
        load(set.column()[2], at, rays.oz);
        load(set.column()[3], at, rays.dx);
        load(set.column()[4], at, rays.dy);
        load(set.column()[5], at, rays.dz);
    }

    private static void load(float[] from, int at, double[] to) {
        for (int i = 0; i < Rays.WIDTH; i++) {
            to[i] = from[at + i];
        }
    }
}

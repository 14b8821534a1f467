package lightning.render.engine.lanes;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.trace.mesh.GroupAlphaTest;
import lightning.render.trace.mesh.MeshPacketTraversal;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.CutoutTest;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;
import org.jspecify.annotations.Nullable;

/**
 * Intersection of one mesh with a group of packets in a single traversal ({@link MeshPacketTraversal}), or ray by ray if rays
 * start or end on the mesh. Sets of rays are bits of a {@code long}, those of packet {@code k} from bit {@code k · WIDTH} on.
 */
final class MeshGroupTracer {
    private static final int W = RayPacket.WIDTH;
    private static final int ALL_LANES = -1 >>> -W;

    private final PrimitiveTable primitives;
    private final MeshRayQuery rayQuery = new MeshRayQuery();
    private final MeshPacketTraversal traversal = new MeshPacketTraversal();
    /** Packets of the group that take part in the traversal. */
    private final int[] packetIndices = new int[MeshPacketTraversal.PACKETS];
    private final double[] unlimited = new double[W];
    /** Current group and mesh. */
    private RayPacket[] currentGroup = {};
    private int currentMesh;
    /** Null if there are no cutouts. */
    private final @Nullable CutoutTest cutoutTest;
    private final GroupAlphaTest alphaTest = this::passes;
    private final RayPacket[] singlePacket = new RayPacket[1];

    MeshGroupTracer(PrimitiveTable primitives) {
        this.primitives = primitives;
        cutoutTest = primitives.hasCutouts() ? new CutoutTest(primitives) : null;
        Arrays.fill(unlimited, SolidGeometry.MISS);
    }

    private void beginMesh(RayPacket[] group, int s) {
        traversal.beginGroup(requireNonNull(primitives.mesh(s)), primitives.data, primitives.dataStart[s]);
        if (cutoutTest != null && primitives.hasCutout(s)) {
            currentGroup = group;
            currentMesh = s;
            traversal.setAlphaTest(alphaTest);
        }
    }

    private boolean passes(int ray, int triangle, double t) {
        RayPacket p = currentGroup[packetIndices[ray / W]];
        int i = ray % W;
        assert cutoutTest != null;
        return cutoutTest.setRay(currentMesh, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]).isHole(triangle, t);
    }

    /** Returns the rays of packet {@code k} that are in a set. */
    static int packetMask(long set, int k) {
        return (int) (set >>> k * W) & ALL_LANES;
    }

    /**
     * Stores mesh {@code s} as the hit of rays of a set for which it is nearer than their hits so far; returns one bit per
     * packet that has such a ray.
     */
    int updateNearest(RayPacket[] group, long set, int s) {
        if (primitives.isEyeOnSurface(s)) {
            return updateNearestScalar(group, set, s);
        }
        beginMesh(group, s);
        int count = 0;
        for (long left = set; left != 0; left &= ~((long) ALL_LANES << packetIndices[count++] * W)) {
            int k = Long.numberOfTrailingZeros(left) / W;
            packetIndices[count] = k;
            traversal.addPacket(group[k], packetMask(set, k), group[k].t);
        }
        traversal.findNearest();
        int nearerPackets = 0;
        for (int j = 0; j < count; j++) {
            for (int left = traversal.hitMask(j); left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                nearerPackets |= storeIfNearer(group[packetIndices[j]], s, i, traversal.distance(j, i),
                        traversal.triangle(j, i)) << packetIndices[j];
            }
        }
        return nearerPackets;
    }

    private int updateNearestScalar(RayPacket[] group, long set, int s) {
        int nearerPackets = 0;
        for (long left = set; left != 0; left &= left - 1) {
            int k = Long.numberOfTrailingZeros(left) / W;
            int i = Long.numberOfTrailingZeros(left) % W;
            RayPacket p = group[k];
            primitives.setProbeRay(rayQuery, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
            nearerPackets |= storeIfNearer(p, s, i, rayQuery.nearest(p.t[i]), rayQuery.triangle()) << k;
        }
        return nearerPackets;
    }

    private static int storeIfNearer(RayPacket p, int s, int i, double t, int part) {
        if (t < p.t[i] || t == p.t[i] && p.nearestPrimitive[i] > s) {
            p.t[i] = t;
            p.part[i] = part;
            p.nearestPrimitive[i] = s;
            return 1;
        }
        return 0;
    }

    /** Returns the rays of a set that hit mesh {@code s} at a distance below their limits; all packets have the same target. */
    long findBlocked(RayPacket[] group, long set, int s) {
        int index = group[Long.numberOfTrailingZeros(set) / W].target.indexOf(s);
        if (index >= 0 || primitives.isEyeOnSurface(s)) {
            return findBlockedScalar(group, set, s, index);
        }
        beginMesh(group, s);
        int count = 0;
        for (long left = set; left != 0; left &= ~((long) ALL_LANES << packetIndices[count++] * W)) {
            int k = Long.numberOfTrailingZeros(left) / W;
            packetIndices[count] = k;
            traversal.addPacket(group[k], packetMask(set, k), group[k].limit);
        }
        traversal.findBlocked();
        long blocked = 0;
        for (int j = 0; j < count; j++) {
            blocked |= (long) traversal.hitMask(j) << packetIndices[j] * W;
        }
        return blocked;
    }

    private long findBlockedScalar(RayPacket[] group, long set, int s, int index) {
        long blocked = 0;
        for (long left = set; left != 0; left &= left - 1) {
            RayPacket p = group[Long.numberOfTrailingZeros(left) / W];
            int i = Long.numberOfTrailingZeros(left) % W;
            boolean endsOnMesh = index >= 0 && p.target.touches(index, p.ox[i], p.oy[i], p.oz[i]);
            primitives.setProbeRay(rayQuery, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], endsOnMesh);
            blocked |= rayQuery.isBlocked(p.limit[i]) ? left & -left : 0;
        }
        return blocked;
    }

    /** Writes {@code t} and {@code part} of the lanes of {@code mask} whose primitive is {@code s}; returns these lanes. */
    int writeDistances(RayPacket p, int s, int mask) {
        int matching = 0;
        for (int left = mask; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            matching |= (p.primitive[i] == s ? 1 : 0) << i;
        }
        if (primitives.isEyeOnSurface(s)) {
            for (int left = matching; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                primitives.setProbeRay(rayQuery, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
                p.t[i] = rayQuery.nearest(SolidGeometry.MISS);
                p.part[i] = rayQuery.triangle();
            }
            return matching;
        }
        singlePacket[0] = p;
        packetIndices[0] = 0;
        beginMesh(singlePacket, s);
        traversal.addPacket(p, matching, unlimited);
        traversal.findNearest();
        for (int left = traversal.hitMask(0); left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            p.t[i] = traversal.distance(0, i);
            p.part[i] = traversal.triangle(0, i);
        }
        return matching;
    }
}

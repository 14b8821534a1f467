package lightning.render.engine.lanes;

import java.util.Arrays;
import lightning.render.trace.mesh.GroupSieve;
import lightning.render.trace.mesh.MeshPackets;
import lightning.render.trace.mesh.MeshProbe;
import lightning.render.trace.primitive.Holes;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;

/**
 * One mesh against a group of packets, asked in one search ({@link MeshPackets}); where a ray begins or ends on the mesh, one ray after the other.
 * Sets of rays are the bits of a {@code long}, those of packet {@code k} from bit {@code k · WIDTH} on.
 */
final class MeshGroup {
    private static final int W = RayPacket.WIDTH;
    private static final int ALL = -1 >>> -W;

    private final PrimitiveTable primitives;
    private final MeshProbe probe = new MeshProbe();
    private final MeshPackets packets = new MeshPackets();
    /** Which of the group's packets are in the search. */
    private final int[] asked = new int[MeshPackets.PACKETS];
    private final double[] unlimited = new double[W];
    /** The group and the mesh that are asked. */
    private RayPacket[] rays;
    private int asking;
    /** Null where nothing has holes. */
    private final Holes holes;
    private final GroupSieve sieve = this::passes;
    private final RayPacket[] alone = new RayPacket[1];

    MeshGroup(PrimitiveTable primitives) {
        this.primitives = primitives;
        holes = primitives.haveHoles() ? new Holes(primitives) : null;
        Arrays.fill(unlimited, Form.MISS);
    }

    private void begin(RayPacket[] group, int s) {
        packets.begin(primitives.mesh(s), primitives.data, primitives.at[s]);
        if (holes != null && primitives.hasHoles(s)) {
            rays = group;
            asking = s;
            packets.sift(sieve);
        }
    }

    private boolean passes(int ray, int triangle, double t) {
        RayPacket p = rays[asked[ray / W]];
        int i = ray % W;
        return holes.enter(asking, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]).passes(triangle, t);
    }

    /** Those rays of packet {@code k} that are in a set. */
    static int of(long set, int k) {
        return (int) (set >>> k * W) & ALL;
    }

    /** Puts mesh {@code s} into the rays of a set where it is nearer than what they have; a bit for each packet that has such a ray. */
    int nearer(RayPacket[] group, long set, int s) {
        if (primitives.isUnderEye(s)) {
            return nearerInTurn(group, set, s);
        }
        begin(group, s);
        int count = 0;
        for (long left = set; left != 0; left &= ~((long) ALL << asked[count++] * W)) {
            int k = Long.numberOfTrailingZeros(left) / W;
            asked[count] = k;
            packets.add(group[k], of(set, k), group[k].t);
        }
        packets.nearest();
        int any = 0;
        for (int j = 0; j < count; j++) {
            for (int left = packets.met(j); left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                any |= take(group[asked[j]], s, i, packets.distance(j, i), packets.triangle(j, i)) << asked[j];
            }
        }
        return any;
    }

    private int nearerInTurn(RayPacket[] group, long set, int s) {
        int any = 0;
        for (long left = set; left != 0; left &= left - 1) {
            int k = Long.numberOfTrailingZeros(left) / W;
            int i = Long.numberOfTrailingZeros(left) % W;
            RayPacket p = group[k];
            primitives.enter(probe, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
            any |= take(p, s, i, probe.nearest(p.t[i]), probe.triangle()) << k;
        }
        return any;
    }

    private static int take(RayPacket p, int s, int i, double t, int part) {
        if (t < p.t[i] || t == p.t[i] && p.found[i] > s) {
            p.t[i] = t;
            p.part[i] = part;
            p.found[i] = s;
            return 1;
        }
        return 0;
    }

    /** The rays of a set that meet mesh {@code s} at a distance below their limits; all packets have one end. */
    long below(RayPacket[] group, long set, int s) {
        int index = group[Long.numberOfTrailingZeros(set) / W].end.indexOf(s);
        if (index >= 0 || primitives.isUnderEye(s)) {
            return belowInTurn(group, set, s, index);
        }
        begin(group, s);
        int count = 0;
        for (long left = set; left != 0; left &= ~((long) ALL << asked[count++] * W)) {
            int k = Long.numberOfTrailingZeros(left) / W;
            asked[count] = k;
            packets.add(group[k], of(set, k), group[k].limit);
        }
        packets.blocked();
        long met = 0;
        for (int j = 0; j < count; j++) {
            met |= (long) packets.met(j) << asked[j] * W;
        }
        return met;
    }

    private long belowInTurn(RayPacket[] group, long set, int s, int index) {
        long met = 0;
        for (long left = set; left != 0; left &= left - 1) {
            RayPacket p = group[Long.numberOfTrailingZeros(left) / W];
            int i = Long.numberOfTrailingZeros(left) % W;
            boolean ends = index >= 0 && p.end.touches(index, p.ox[i], p.oy[i], p.oz[i]);
            primitives.enter(probe, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], ends);
            met |= probe.blocked(p.limit[i]) ? left & -left : 0;
        }
        return met;
    }

    /** Writes {@code t} and {@code part} of those lanes of {@code mask} whose primitive is {@code s}; returns which they are. */
    int distances(RayPacket p, int s, int mask) {
        int done = 0;
        for (int left = mask; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            done |= (p.primitive[i] == s ? 1 : 0) << i;
        }
        if (primitives.isUnderEye(s)) {
            for (int left = done; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                primitives.enter(probe, s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
                p.t[i] = probe.nearest(Form.MISS);
                p.part[i] = probe.triangle();
            }
            return done;
        }
        alone[0] = p;
        asked[0] = 0;
        begin(alone, s);
        packets.add(p, done, unlimited);
        packets.nearest();
        for (int left = packets.met(0); left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            p.t[i] = packets.distance(0, i);
            p.part[i] = packets.triangle(0, i);
        }
        return done;
    }
}

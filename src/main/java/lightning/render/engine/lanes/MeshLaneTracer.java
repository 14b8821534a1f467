package lightning.render.engine.lanes;

import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.ShadowRayTarget;

/** Packet tracer for scenes with meshes: traces packets in groups ({@link PacketGroupTracer}), which traverse a mesh together. */
final class MeshLaneTracer extends LaneTracer {
    private static final int W = RayPacket.WIDTH;
    private static final int MAX_PACKETS = PacketGroupTracer.MAX_PACKETS;
    /** Pixels along a side of a group's square, and of a packet's rectangle. */
    private static final int SQUARE = 8;
    private static final int SIDE = 4;
    private static final int HEIGHT = W / SIDE;

    private final PacketGroupTracer group;
    private final RayPacket[] packet;
    /** Row word of each packet's rays, and its first row in there. */
    private final int[] rowWord = new int[MAX_PACKETS];
    private final int[] firstBit = new int[MAX_PACKETS];
    private int count;
    private long activeRays;

    MeshLaneTracer(Geometry geometry) {
        super(geometry);
        group = new PacketGroupTracer(geometry);
        packet = group.packets;
    }

    @Override
    public void findNearest(RayColumns rays, CandidateList candidates) {
        for (RayPacket p : packet) {
            loadEyeOrigin(rays, p);
        }
        if (rays.columns % SQUARE == 0 && rays.columns > 0 && rays.count / rays.columns % SQUARE == 0) {
            for (int y = 0; y < rays.count; y += SQUARE * rays.columns) {
                for (int x = 0; x < rays.columns; x += SQUARE) {
                    traceSquare(rays, y + x, candidates);
                }
            }
            return;
        }
        for (int ray = 0; ray < rays.count; ray += MAX_PACKETS * W) {
            traceLine(rays, ray, candidates);
        }
    }

    /** Traces the rays starting with {@code ray}. */
    private void traceLine(RayColumns rays, int ray, CandidateList candidates) {
        activeRays = 0;
        for (int k = 0; k < MAX_PACKETS && ray + k * W < rays.count; k++) {
            int laneCount = Math.min(W, rays.count - ray - k * W);
            load(rays, ray + k * W, laneCount, packet[k]);
            activeRays |= (-1L >>> -laneCount) << k * W;
        }
        group.findNearest(activeRays, candidates);
        for (int k = 0; k < MAX_PACKETS && ray + k * W < rays.count; k++) {
            int at = ray + k * W;
            int laneCount = Math.min(W, rays.count - at);
            System.arraycopy(packet[k].t, 0, rays.t, at, laneCount);
            System.arraycopy(packet[k].primitive, 0, rays.primitive, at, laneCount);
            System.arraycopy(packet[k].part, 0, rays.part, at, laneCount);
        }
    }

    /** Traces the rays of a square of pixels that starts with {@code ray}. */
    private void traceSquare(RayColumns rays, int ray, CandidateList candidates) {
        for (int k = 0; k < MAX_PACKETS; k++) {
            RayPacket p = packet[k];
            for (int i = 0; i < W; i++) {
                int from = corner(rays, ray, k) + i / SIDE * rays.columns + i % SIDE;
                p.dx[i] = rays.dx[from];
                p.dy[i] = rays.dy[from];
                p.dz[i] = rays.dz[from];
            }
        }
        group.findNearest(-1, candidates);
        for (int k = 0; k < MAX_PACKETS; k++) {
            RayPacket p = packet[k];
            for (int i = 0; i < W; i++) {
                int to = corner(rays, ray, k) + i / SIDE * rays.columns + i % SIDE;
                rays.t[to] = p.t[i];
                rays.primitive[to] = p.primitive[i];
                rays.part[to] = p.part[i];
            }
        }
    }

    /** Returns the first ray of a packet's rectangle in a square. */
    private static int corner(RayColumns rays, int ray, int k) {
        return ray + k / 2 * HEIGHT * rays.columns + k % 2 * SIDE;
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        traceBlocked(rows, selected, shadowRays.target(), (row, laneMask, p) -> load(rows, shadowRays, row, laneMask, p), candidates,
                blocked);
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        if (!shadowRays.isOffSurface) {
            super.findBlocked(rows, selected, shadowRays, candidates, blocked);
            return;
        }
        traceBlocked(rows, selected, ShadowRayTarget.OFF_SURFACE, (row, laneMask, p) -> {
            load(rows, shadowRays, row, p);
            setLimits(laneMask, shadowRays.limit(), p);
        }, candidates, blocked);
    }

    /** Fills a packet with the shadow rays of the rows starting with {@code row}; bits of {@code laneMask} select the rows. */
    private interface PacketLoader {
        void load(int row, int laneMask, RayPacket packet);
    }

    private void traceBlocked(HitRows rows, int[] selected, ShadowRayTarget target, PacketLoader loader, CandidateList candidates,
            int[] blocked) {
        startGroup(target);
        for (int b = 0, row = 0; row < rows.count; b++, row += ROWS_PER_WORD) {
            blocked[b] = 0;
            for (int part = 0; selected[b] != 0 && part < ROWS_PER_WORD; part += W) {
                int laneMask = selected[b] >>> part & -1 >>> -W;
                if (laneMask != 0) {
                    loader.load(row + part, laneMask, packet[count]);
                    addPacket(b, part, laneMask, candidates, blocked);
                }
            }
        }
        traceGroup(candidates, blocked);
    }

    private void startGroup(ShadowRayTarget target) {
        count = 0;
        activeRays = 0;
        for (RayPacket p : packet) {
            p.target = target;
        }
    }

    /** Adds a filled packet, and traces the group if it is full. */
    private void addPacket(int b, int part, int laneMask, CandidateList candidates, int[] blocked) {
        rowWord[count] = b;
        firstBit[count] = part;
        activeRays |= (long) laneMask << count * W;
        count++;
        if (count == MAX_PACKETS) {
            traceGroup(candidates, blocked);
        }
    }

    private void traceGroup(CandidateList candidates, int[] blocked) {
        long blockedRays = activeRays == 0 ? 0 : group.findBlocked(activeRays, candidates);
        for (int k = 0; k < count; k++) {
            blocked[rowWord[k]] |= MeshGroupTracer.packetMask(blockedRays, k) << firstBit[k];
        }
        count = 0;
        activeRays = 0;
    }
}

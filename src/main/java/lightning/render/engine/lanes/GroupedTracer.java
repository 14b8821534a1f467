package lightning.render.engine.lanes;

import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowWays;
import lightning.render.trace.Ways;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.WayEnd;

/** Traces the rays of a tile where there are meshes: packets in groups ({@link GroupTracer}), which see a mesh together. */
final class GroupedTracer extends LaneTracer {
    private static final int W = RayPacket.WIDTH;
    private static final int MOST = GroupTracer.MOST;
    /** Pixels along a side of the square that a group sees, and along that of a packet's rectangle. */
    private static final int SQUARE = 8;
    private static final int SIDE = 4;
    private static final int HEIGHT = W / SIDE;

    private final GroupTracer group;
    private final RayPacket[] packet;
    /** The rows' word that each packet's rays are of, and its first in there. */
    private final int[] word = new int[MOST];
    private final int[] place = new int[MOST];
    private int count;
    private long set;

    GroupedTracer(Geometry geometry) {
        super(geometry);
        group = new GroupTracer(geometry);
        packet = group.packets;
    }

    @Override
    public void nearest(RayColumns rays, Candidates candidates) {
        for (RayPacket p : packet) {
            begin(rays, p);
        }
        if (rays.columns % SQUARE == 0 && rays.columns > 0 && rays.count / rays.columns % SQUARE == 0) {
            for (int y = 0; y < rays.count; y += SQUARE * rays.columns) {
                for (int x = 0; x < rays.columns; x += SQUARE) {
                    square(rays, y + x, candidates);
                }
            }
            return;
        }
        for (int ray = 0; ray < rays.count; ray += MOST * W) {
            line(rays, ray, candidates);
        }
    }

    /** Traces the rays from {@code ray} on. */
    private void line(RayColumns rays, int ray, Candidates candidates) {
        set = 0;
        for (int k = 0; k < MOST && ray + k * W < rays.count; k++) {
            int live = Math.min(W, rays.count - ray - k * W);
            load(rays, ray + k * W, live, packet[k]);
            set |= (-1L >>> -live) << k * W;
        }
        group.nearest(set, candidates);
        for (int k = 0; k < MOST && ray + k * W < rays.count; k++) {
            int at = ray + k * W;
            int live = Math.min(W, rays.count - at);
            System.arraycopy(packet[k].t, 0, rays.t, at, live);
            System.arraycopy(packet[k].primitive, 0, rays.primitive, at, live);
            System.arraycopy(packet[k].part, 0, rays.part, at, live);
        }
    }

    /** Traces the rays of a square of pixels whose first is {@code ray}. */
    private void square(RayColumns rays, int ray, Candidates candidates) {
        for (int k = 0; k < MOST; k++) {
            RayPacket p = packet[k];
            for (int i = 0; i < W; i++) {
                int from = corner(rays, ray, k) + i / SIDE * rays.columns + i % SIDE;
                p.dx[i] = rays.dx[from];
                p.dy[i] = rays.dy[from];
                p.dz[i] = rays.dz[from];
            }
        }
        group.nearest(-1, candidates);
        for (int k = 0; k < MOST; k++) {
            RayPacket p = packet[k];
            for (int i = 0; i < W; i++) {
                int to = corner(rays, ray, k) + i / SIDE * rays.columns + i % SIDE;
                rays.t[to] = p.t[i];
                rays.primitive[to] = p.primitive[i];
                rays.part[to] = p.part[i];
            }
        }
    }

    /** The first ray of a packet's rectangle in a square. */
    private static int corner(RayColumns rays, int ray, int k) {
        return ray + k / 2 * HEIGHT * rays.columns + k % 2 * SIDE;
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, Ways ways, Candidates candidates, int[] blocked) {
        blocked(rows, chosen, ways.end(), (row, asked, p) -> load(rows, ways, row, asked, p), candidates, blocked);
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, int[] blocked) {
        if (!ways.open) {
            super.blocked(rows, chosen, ways, candidates, blocked);
            return;
        }
        blocked(rows, chosen, WayEnd.OPEN, (row, asked, p) -> {
            load(rows, ways, row, p);
            limit(asked, ways.limit(), p);
        }, candidates, blocked);
    }

    /** Fills a packet with the ways of the rows from {@code row} on, of which bits of {@code asked} are asked. */
    private interface Loading {
        void load(int row, int asked, RayPacket packet);
    }

    private void blocked(HitRows rows, int[] chosen, WayEnd end, Loading loading, Candidates candidates, int[] blocked) {
        start(end);
        for (int b = 0, row = 0; row < rows.count; b++, row += WORD) {
            blocked[b] = 0;
            for (int part = 0; chosen[b] != 0 && part < WORD; part += W) {
                int asked = chosen[b] >>> part & -1 >>> -W;
                if (asked != 0) {
                    loading.load(row + part, asked, packet[count]);
                    add(b, part, asked, candidates, blocked);
                }
            }
        }
        ask(candidates, blocked);
    }

    private void start(WayEnd end) {
        count = 0;
        set = 0;
        for (RayPacket p : packet) {
            p.end = end;
        }
    }

    /** Adds a packet that was filled, and asks the group where it is full. */
    private void add(int b, int part, int asked, Candidates candidates, int[] blocked) {
        word[count] = b;
        place[count] = part;
        set |= (long) asked << count * W;
        count++;
        if (count == MOST) {
            ask(candidates, blocked);
        }
    }

    private void ask(Candidates candidates, int[] blocked) {
        long met = set == 0 ? 0 : group.blocked(set, candidates);
        for (int k = 0; k < count; k++) {
            blocked[word[k]] |= MeshGroup.of(met, k) << place[k];
        }
        count = 0;
        set = 0;
    }
}

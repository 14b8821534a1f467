package lightning.render.engine.lanes;

import java.util.Arrays;
import lightning.render.shading.LampArea;
import lightning.render.shading.Terms;
import lightning.render.trace.CrossingWalk;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.render.trace.Tracer;
import lightning.render.trace.mesh.MeshPackets;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.KindLanes;
import lightning.render.trace.tree.Candidates;

/**
 * {@link CrossingWalk} in lanes: 64 ways at a time are tested against the box of a shape, and those that enter it go through a mesh together, or
 * against a solid in lanes. Rows with the same turn go together, whose ways end at the same place of an area: they are one beam, where those of
 * neighbours are not. Ways of which any may end on a shape, shapes with holes and such that the eye is on are asked way by way. Holds
 * scratch memory: one for each thread.
 */
final class CrossingLanes {
    private static final int W = RayPacket.WIDTH;
    private static final int MOST = MeshPackets.PACKETS;

    private final PrimitiveTable primitives;
    private final CrossingWalk walk;
    private final MeshPackets meshes = new MeshPackets();
    private final KindLanes solids = new KindLanes();
    private final double[] distance = new double[W];
    private final RayPacket[] packet = new RayPacket[MOST];
    private final BoxLanes[] box = new BoxLanes[MOST];
    /** For each packet and candidate the rays that enter its box. */
    private final int[][] masks = new int[MOST][0];
    /** The rows that are asked, and the place there of each packet's first. */
    private final int[] order = new int[Terms.ROWS];
    private final int[] first = new int[MOST];
    /** Where the rows of each turn begin. */
    private final int[] turns = new int[LampArea.TURNS + 1];
    /** The packets that a mesh is asked for. */
    private final int[] asked = new int[MOST];
    private int count;

    CrossingLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        walk = new CrossingWalk(primitives);
        for (int k = 0; k < MOST; k++) {
            packet[k] = new RayPacket();
            box[k] = new BoxLanes();
        }
    }

    /** As {@link Tracer#cross}. */
    void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to) {
        if (!ways.open) {
            walk.cross(rows, chosen, ways, candidates, to);
            return;
        }
        int ordered = order(rows, chosen, ways);
        count = 0;
        for (int i = 0; i < ordered; i += W) {
            add(rows, ways, i, Math.min(W, ordered - i), candidates);
            if (count == MOST) {
                ask(candidates, ways.limit(), to);
            }
        }
        ask(candidates, ways.limit(), to);
    }

    /** Writes the chosen rows to {@link #order}, by their turns; how many there are. */
    private int order(HitRows rows, int[] chosen, RowWays ways) {
        Arrays.fill(turns, 0);
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.WORD) {
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                turns[(int) ways.turn[first + Integer.numberOfTrailingZeros(left)] + 1]++;
            }
        }
        for (int t = 0; t < LampArea.TURNS; t++) {
            turns[t + 1] += turns[t];
        }
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.WORD) {
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                int row = first + Integer.numberOfTrailingZeros(left);
                order[turns[(int) ways.turn[row]]++] = row;
            }
        }
        return turns[LampArea.TURNS];
    }

    /** Adds a packet of {@code live} rows from place {@code from} in their order on. */
    private void add(HitRows rows, RowWays ways, int from, int live, Candidates candidates) {
        RayPacket p = packet[count];
        if (masks[count].length < candidates.count) {
            masks[count] = new int[candidates.primitive.length];
        }
        for (int i = 0; i < W; i++) {
            int row = order[from + Math.min(i, live - 1)];
            p.ox[i] = rows.px[row];
            p.oy[i] = rows.py[row];
            p.oz[i] = rows.pz[row];
            p.dx[i] = ways.ends ? ways.x[row] - p.ox[i] : ways.x[row];
            p.dy[i] = ways.ends ? ways.y[row] - p.oy[i] : ways.y[row];
            p.dz[i] = ways.ends ? ways.z[row] - p.oz[i] : ways.z[row];
        }
        int which = -1 >>> -live;
        LaneTracer.limit(which, ways.limit(), p);
        box[count].enter(p);
        box[count].limit(p.limit);
        box[count].hits(candidates.boxes, 0, candidates.count, masks[count]);
        for (int c = 0; c < candidates.count; c++) {
            masks[count][c] &= which;
        }
        first[count++] = from;
    }

    /** Asks all candidates for the packets, which then are no more. */
    private void ask(Candidates candidates, double limit, Crossings to) {
        for (int c = 0; c < candidates.count; c++) {
            int s = candidates.primitive[c];
            if (primitives.hasHoles(s) || primitives.isUnderEye(s)) {
                inTurn(c, s, limit, to);
            } else if (primitives.mesh(s) != null) {
                mesh(c, s, limit, to);
            } else {
                solid(c, s, limit, to);
            }
        }
        count = 0;
    }

    private void inTurn(int c, int s, double limit, Crossings to) {
        for (int k = 0; k < count; k++) {
            RayPacket p = packet[k];
            for (int left = masks[k][c]; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                to.turnTo(order[first[k] + i]);
                walk.cross(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], limit, to);
            }
        }
    }

    private void mesh(int c, int s, double limit, Crossings to) {
        int n = 0;
        for (int k = 0; k < count; k++) {
            if (masks[k][c] != 0) {
                if (n == 0) {
                    meshes.begin(primitives.mesh(s), primitives.data, primitives.at[s]);
                }
                meshes.add(packet[k], masks[k][c], packet[k].limit);
                asked[n++] = k;
            }
        }
        if (n == 0) {
            return;
        }
        meshes.cross();
        for (int i = 0; i < meshes.crossings(); i++) {
            int ray = meshes.crossingRay(i);
            to.turnTo(order[first[asked[ray / W]] + ray % W]);
            to.add(s, meshes.crossingTriangle(i), meshes.crossingDistance(i), limit, null);
        }
    }

    private void solid(int c, int s, double limit, Crossings to) {
        for (int k = 0; k < count; k++) {
            int mask = masks[k][c];
            if (mask == 0) {
                continue;
            }
            RayPacket p = packet[k];
            int from = SolidLanes.first(mask);
            int end = SolidLanes.end(mask);
            solids.distances(primitives.kind(s), primitives.data, primitives.at[s], p, distance, from, end);
            for (int left = mask; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                if (distance[i] < Form.MISS) {
                    to.turnTo(order[first[k] + i]);
                    primitives.crossings(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], distance[i], limit, to);
                }
            }
        }
    }
}

package lightning.render.engine.lanes;

import java.util.Arrays;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.SamplePattern;
import lightning.render.trace.ShadowRayHitFinder;
import lightning.render.trace.Tracer;
import lightning.render.trace.mesh.MeshPacketTraversal;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidGeometryLanes;
import lightning.render.trace.tree.CandidateList;

/**
 * Lane version of {@link ShadowRayHitFinder}. Tests 64 shadow rays at a time against the box of a shape. Rays that enter it
 * traverse a mesh together, or are tested against a solid in lanes.
 *
 * <p>Rows with the same sample pattern form packets: their shadow rays end at the same position of an area light, so they are
 * one beam, unlike those of neighboring rows. Rays are tested one by one if any may end on the shape, if the shape has cutouts,
 * or if the eye is on it. Holds scratch memory: use one per thread.
 */
final class ShadowRayHitLanes {
    private static final int W = RayPacket.WIDTH;
    private static final int MAX_PACKETS = MeshPacketTraversal.PACKETS;

    private final PrimitiveTable primitives;
    private final ShadowRayHitFinder hitFinder;
    private final MeshPacketTraversal meshTraversal = new MeshPacketTraversal();
    private final SolidGeometryLanes solidGeometry = new SolidGeometryLanes();
    private final double[] distance = new double[W];
    private final RayPacket[] packet = new RayPacket[MAX_PACKETS];
    private final BoxTestLanes[] boxTest = new BoxTestLanes[MAX_PACKETS];
    /** Rays of each packet that enter the box of each candidate. */
    private final int[][] masks = new int[MAX_PACKETS][0];
    /** Selected rows, and the index there of each packet's first row. */
    private final int[] sortedRows = new int[TermKernel.MAX_ROWS];
    private final int[] first = new int[MAX_PACKETS];
    /** Start of the rows of each pattern. */
    private final int[] patternStarts = new int[SamplePattern.MAX_PATTERNS + 1];
    /** Packets to test against a mesh. */
    private final int[] meshPackets = new int[MAX_PACKETS];
    private int count;

    ShadowRayHitLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        hitFinder = new ShadowRayHitFinder(primitives);
        for (int k = 0; k < MAX_PACKETS; k++) {
            packet[k] = new RayPacket();
            boxTest[k] = new BoxTestLanes();
        }
    }

    /** Implements {@link Tracer#findHits}. */
    void findHits(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, ShadowRayHits hits) {
        if (!shadowRays.isOffSurface) {
            hitFinder.findHits(rows, selected, shadowRays, candidates, hits);
            return;
        }
        int rowCount = sortRows(rows, selected, shadowRays);
        count = 0;
        for (int i = 0; i < rowCount; i += W) {
            addPacket(rows, shadowRays, i, Math.min(W, rowCount - i), candidates);
            if (count == MAX_PACKETS) {
                testCandidates(candidates, shadowRays.limit(), hits);
            }
        }
        testCandidates(candidates, shadowRays.limit(), hits);
    }

    /** Writes the selected rows to {@link #sortedRows}, by pattern; returns their number. */
    private int sortRows(HitRows rows, int[] selected, RowShadowRays shadowRays) {
        Arrays.fill(patternStarts, 0);
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.ROWS_PER_WORD) {
            for (int left = selected[b]; left != 0; left &= left - 1) {
                patternStarts[shadowRays.pattern[first + Integer.numberOfTrailingZeros(left)] + 1]++;
            }
        }
        for (int t = 0; t < SamplePattern.MAX_PATTERNS; t++) {
            patternStarts[t + 1] += patternStarts[t];
        }
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.ROWS_PER_WORD) {
            for (int left = selected[b]; left != 0; left &= left - 1) {
                int row = first + Integer.numberOfTrailingZeros(left);
                sortedRows[patternStarts[shadowRays.pattern[row]]++] = row;
            }
        }
        return patternStarts[SamplePattern.MAX_PATTERNS];
    }

    /** Adds a packet of {@code laneCount} rows, starting with index {@code from} of the sorted rows. */
    private void addPacket(HitRows rows, RowShadowRays shadowRays, int from, int laneCount, CandidateList candidates) {
        RayPacket p = packet[count];
        if (masks[count].length < candidates.count) {
            masks[count] = new int[candidates.primitive.length];
        }
        for (int i = 0; i < W; i++) {
            int row = sortedRows[from + Math.min(i, laneCount - 1)];
            p.ox[i] = rows.px[row];
            p.oy[i] = rows.py[row];
            p.oz[i] = rows.pz[row];
            p.dx[i] = shadowRays.toPoints ? shadowRays.x[row] - p.ox[i] : shadowRays.x[row];
            p.dy[i] = shadowRays.toPoints ? shadowRays.y[row] - p.oy[i] : shadowRays.y[row];
            p.dz[i] = shadowRays.toPoints ? shadowRays.z[row] - p.oz[i] : shadowRays.z[row];
        }
        int laneMask = -1 >>> -laneCount;
        LaneTracer.setLimits(laneMask, shadowRays.limit(), p);
        boxTest[count].setRays(p);
        boxTest[count].setLimits(p.limit);
        boxTest[count].hits(candidates.boxes, 0, candidates.count, masks[count]);
        for (int c = 0; c < candidates.count; c++) {
            masks[count][c] &= laneMask;
        }
        first[count++] = from;
    }

    /** Tests all candidates against the packets, then removes the packets. */
    private void testCandidates(CandidateList candidates, double limit, ShadowRayHits hits) {
        for (int c = 0; c < candidates.count; c++) {
            int s = candidates.primitive[c];
            if (primitives.hasCutout(s) || primitives.isEyeOnSurface(s)) {
                testScalar(c, s, limit, hits);
            } else if (primitives.mesh(s) != null) {
                testMesh(c, s, limit, hits);
            } else {
                testSolid(c, s, limit, hits);
            }
        }
        count = 0;
    }

    private void testScalar(int c, int s, double limit, ShadowRayHits hits) {
        for (int k = 0; k < count; k++) {
            RayPacket p = packet[k];
            for (int left = masks[k][c]; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                hits.selectRay(sortedRows[first[k] + i]);
                hitFinder.findHits(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], limit, hits);
            }
        }
    }

    private void testMesh(int c, int s, double limit, ShadowRayHits hits) {
        int n = 0;
        for (int k = 0; k < count; k++) {
            if (masks[k][c] != 0) {
                if (n == 0) {
                    meshTraversal.beginGroup(primitives.mesh(s), primitives.data, primitives.dataStart[s]);
                }
                meshTraversal.addPacket(packet[k], masks[k][c], packet[k].limit);
                meshPackets[n++] = k;
            }
        }
        if (n == 0) {
            return;
        }
        meshTraversal.findAllHits();
        for (int i = 0; i < meshTraversal.hitCount(); i++) {
            int ray = meshTraversal.hitRay(i);
            hits.selectRay(sortedRows[first[meshPackets[ray / W]] + ray % W]);
            hits.add(s, meshTraversal.hitTriangle(i), meshTraversal.hitDistance(i), limit, null);
        }
    }

    private void testSolid(int c, int s, double limit, ShadowRayHits hits) {
        for (int k = 0; k < count; k++) {
            int mask = masks[k][c];
            if (mask == 0) {
                continue;
            }
            RayPacket p = packet[k];
            int from = PrimitiveLanes.firstLane(mask);
            int end = PrimitiveLanes.endLane(mask);
            solidGeometry.distances(primitives.kind(s), primitives.data, primitives.dataStart[s], p, distance, from, end);
            for (int left = mask; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                if (distance[i] < SolidGeometry.MISS) {
                    hits.selectRay(sortedRows[first[k] + i]);
                    primitives.addHits(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], distance[i], limit, hits);
                }
            }
        }
    }
}

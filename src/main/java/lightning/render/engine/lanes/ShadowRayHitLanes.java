package lightning.render.engine.lanes;

import static java.util.Objects.requireNonNull;

import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRayHitFinder;
import lightning.render.trace.Tracer;
import lightning.render.trace.mesh.MeshRayStream;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidGeometryLanes;
import lightning.render.trace.tree.CandidateList;

/**
 * Lane version of {@link ShadowRayHitFinder}. Tests all shadow rays of a batch against the boxes of the shapes. Rays that enter the
 * box of a mesh traverse its BVH together; rays that enter the box of a solid are tested in lanes.
 *
 * <p>Rays are tested one by one if any may end on a shape, if the shape has cutouts, or if the eye is on it. Holds scratch memory:
 * use one per thread.
 */
final class ShadowRayHitLanes {
    private static final int W = RayPacket.WIDTH;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final IntVector LANES = IntVector.zero(INTS).addIndex(1);

    private final PrimitiveTable primitives;
    private final ShadowRayHitFinder hitFinder;
    private final MeshRayStream stream = new MeshRayStream();
    private final SolidGeometryLanes solidGeometry = new SolidGeometryLanes();
    private final double[] distance = new double[W];
    private final RayPacket packet = new RayPacket();
    private final BoxTestLanes boxTest = new BoxTestLanes();
    /** Rays of each packet that enter the box of each candidate. */
    private final int[][] masks = new int[ShadowRayBatch.MAX_RAYS / W][0];
    /** Rays that enter the box of the current candidate. */
    private final int[] entering = new int[ShadowRayBatch.MAX_RAYS + INTS.length()];

    ShadowRayHitLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        hitFinder = new ShadowRayHitFinder(primitives);
    }

    /** Implements {@link Tracer#findHits}. */
    void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits) {
        if (rays.targets != null) {
            hitFinder.findHits(rays, candidates, hits);
            return;
        }
        testBoxes(rays, candidates);
        for (int c = 0; c < candidates.count; c++) {
            int count = collectEntering(rays.count, c);
            if (count > 0) {
                test(rays, candidates.primitive[c], count, hits);
            }
        }
    }

    /** Tests all rays against the boxes of the candidates; writes {@link #masks}. */
    private void testBoxes(ShadowRayBatch rays, CandidateList candidates) {
        for (int from = 0; from < rays.count; from += W) {
            int k = from / W;
            if (masks[k].length < candidates.count) {
                masks[k] = new int[candidates.primitive.length];
            }
            System.arraycopy(rays.ox, from, packet.ox, 0, W);
            System.arraycopy(rays.oy, from, packet.oy, 0, W);
            System.arraycopy(rays.oz, from, packet.oz, 0, W);
            System.arraycopy(rays.dx, from, packet.dx, 0, W);
            System.arraycopy(rays.dy, from, packet.dy, 0, W);
            System.arraycopy(rays.dz, from, packet.dz, 0, W);
            LaneTracer.setLimits(activeMask(rays.count - from), rays.limit(), packet);
            boxTest.setRays(packet);
            boxTest.setLimits(packet.limit);
            boxTest.hits(candidates.boxes, 0, candidates.count, masks[k]);
        }
    }

    /** Returns the bits of the first {@code count} lanes, at most all. */
    private static int activeMask(int count) {
        return -1 >>> -Math.min(count, W);
    }

    /** Writes the rays that enter the box of candidate {@code c} to {@link #entering}; returns their number. */
    private int collectEntering(int rayCount, int c) {
        int count = 0;
        for (int from = 0; from < rayCount; from += W) {
            int mask = masks[from / W][c] & activeMask(rayCount - from);
            for (int part = 0; mask != 0 && part < W; part += INTS.length()) {
                VectorMask<Integer> lanes = VectorMask.fromLong(INTS, mask >>> part);
                LANES.add(from + part).compress(lanes).intoArray(entering, count);
                count += lanes.trueCount();
            }
        }
        return count;
    }

    private void test(ShadowRayBatch rays, int s, int count, ShadowRayHits hits) {
        if (primitives.hasCutout(s) || primitives.isEyeOnSurface(s)) {
            for (int n = 0; n < count; n++) {
                hitFinder.findHits(s, rays, entering[n], hits);
            }
        } else if (primitives.mesh(s) != null) {
            testMesh(rays, s, count, hits);
        } else {
            testSolid(rays, s, count, hits);
        }
    }

    private void testMesh(ShadowRayBatch rays, int s, int count, ShadowRayHits hits) {
        stream.begin(requireNonNull(primitives.mesh(s)), primitives.data, primitives.dataStart[s]);
        for (int n = 0; n < count; n += W) {
            load(rays, n, count);
            stream.addPacket(packet, activeMask(count - n), packet.limit);
        }
        stream.findAllHits();
        for (int i = 0; i < stream.hitCount(); i++) {
            hits.selectRay(entering[stream.hitRay(i)]);
            hits.add(s, stream.hitTriangle(i), stream.hitDistance(i), rays.limit(), null);
        }
    }

    private void testSolid(ShadowRayBatch rays, int s, int count, ShadowRayHits hits) {
        for (int n = 0; n < count; n += W) {
            load(rays, n, count);
            solidGeometry.distances(primitives.kind(s), primitives.data, primitives.dataStart[s], packet, distance, 0, W);
            for (int i = 0; i < W && n + i < count; i++) {
                if (distance[i] < SolidGeometry.MISS) {
                    hits.selectRay(entering[n + i]);
                    primitives.addHits(s, packet.ox[i], packet.oy[i], packet.oz[i], packet.dx[i], packet.dy[i], packet.dz[i], distance[i],
                            rays.limit(), hits);
                }
            }
        }
    }

    /** Loads the rays {@code entering[n …]}, the last one also into lanes beyond the end. */
    private void load(ShadowRayBatch rays, int n, int count) {
        for (int i = 0; i < W; i++) {
            int k = entering[Math.min(n + i, count - 1)];
            packet.ox[i] = rays.ox[k];
            packet.oy[i] = rays.oy[k];
            packet.oz[i] = rays.oz[k];
            packet.dx[i] = rays.dx[k];
            packet.dy[i] = rays.dy[k];
            packet.dz[i] = rays.dz[k];
        }
        LaneTracer.setLimits(activeMask(count - n), rays.limit(), packet);
    }
}

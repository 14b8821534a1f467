package lightning.render.engine.lanes;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2I;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.DoubleLanes.SPECIES;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.primitive.CutoutTest;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidGeometryLanes;
import lightning.render.trace.solid.SurfaceContact;
import org.jspecify.annotations.Nullable;

/**
 * Intersection of one primitive with a packet, and evaluation of the hits: lane version of {@link PrimitiveTable#distance}.
 *
 * <p>Solids are tested for whole vectors of lanes that contain a bit of the mask. Lanes that the primitive's box rejected get
 * the same result as from the box: a miss, or a hit beyond a nearer one. Meshes are tested only for the lanes of the mask
 * ({@link MeshGroupTracer}).
 *
 * <p>Cutouts of a solid are tested only if the full solid is nearer than the ray's hit so far, since the remaining surface is
 * no nearer.
 */
final class PrimitiveLanes {
    private static final VectorSpecies<Integer> INTS =
            VectorSpecies.of(int.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));

    private final PrimitiveTable primitives;
    /** Distances to the current primitive. */
    private final double[] distances = new double[RayPacket.WIDTH];
    private final SolidGeometryLanes solidGeometry = new SolidGeometryLanes();
    /** Null if there are no cutouts. */
    private final @Nullable CutoutTest cutoutTest;
    private final double[] unlimited = new double[RayPacket.WIDTH];
    final MeshGroupTracer mesh;
    /** Group of one packet. */
    private final RayPacket[] singlePacket = new RayPacket[1];

    PrimitiveLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        mesh = new MeshGroupTracer(primitives);
        cutoutTest = primitives.hasCutouts() ? new CutoutTest(primitives) : null;
        Arrays.fill(unlimited, SolidGeometry.MISS);
    }

    /** Returns the first lane of the vectors that contain a bit of the mask. */
    static int firstLane(int mask) {
        return (mask & -1 >>> -DoubleLanes.COUNT) != 0 ? 0 : DoubleLanes.COUNT;
    }

    static int endLane(int mask) {
        return mask >>> DoubleLanes.COUNT != 0 ? RayPacket.WIDTH : DoubleLanes.COUNT;
    }

    /**
     * Writes the distances of the lanes {@code from … to − 1}.
     *
     * @param mask lanes to test for cutouts
     * @param limits maximum distance of each ray; the full solid is never farther than its remaining surface
     */
    private void computeDistances(RayPacket p, int s, int mask, double[] limits, int from, int to) {
        solidGeometry.distances(primitives.kind(s), primitives.data, primitives.dataStart[s], p, distances, from, to);
        if (primitives.isEyeOnSurface(s)) {
            for (int i = from; i < to; i++) {
                distances[i] = primitives.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
            }
        } else if (cutoutTest != null && primitives.hasCutout(s)) {
            for (int left = mask; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                if (distances[i] <= limits[i] && distances[i] < SolidGeometry.MISS) {
                    distances[i] = primitives.cutoutDistance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], distances[i],
                            limits[i], cutoutTest);
                }
            }
        }
    }

    /** Computes the distances of shadow rays to a light on the primitive. */
    private void distancesToLight(RayPacket p, int s, int index, int from, int to) {
        for (int i = from; i < to; i++) {
            if (p.target.touches(index, p.ox[i], p.oy[i], p.oz[i])) {
                distances[i] = primitives.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], SurfaceContact.END);
            }
        }
    }

    /** Sets all lanes to misses. */
    void resetHits(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            broadcast(SPECIES, SolidGeometry.MISS).intoArray(p.t, h);
            broadcast(SPECIES, -1).intoArray(p.nearestPrimitive, h);
        }
    }

    /**
     * Stores primitive {@code s} as the hit of lanes of a non-zero mask for which it is nearer than their hits so far; returns
     * true if there are any.
     */
    boolean updateNearest(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            singlePacket[0] = p;
            return mesh.updateNearest(singlePacket, mask, s) != 0;
        }
        int from = firstLane(mask);
        int to = endLane(mask);
        computeDistances(p, s, mask, p.t, from, to);
        boolean hasNearer = false;
        for (int h = from; h < to; h += DoubleLanes.COUNT) {
            DoubleVector t = fromArray(SPECIES, distances, h);
            DoubleVector best = fromArray(SPECIES, p.t, h);
            DoubleVector primitive = fromArray(SPECIES, p.nearestPrimitive, h);
            VectorMask<Double> nearer = t.compare(LT, best).or(t.compare(EQ, best).and(primitive.compare(GT, s)));
            best.blend(t, nearer).intoArray(p.t, h);
            primitive.blend(s, nearer).intoArray(p.nearestPrimitive, h);
            hasNearer |= nearer.anyTrue();
        }
        return hasNearer;
    }

    /** Writes the hits to the packet's {@code primitive}. */
    void writePrimitives(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector v = fromArray(SPECIES, p.nearestPrimitive, h);
            ((IntVector) v.convertShape(D2I, INTS, 0)).intoArray(p.primitive, h);
        }
    }

    /** Returns the lanes of a non-zero mask that hit primitive {@code s} at a distance below their {@code limit}. */
    int findBlocked(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            singlePacket[0] = p;
            return (int) mesh.findBlocked(singlePacket, mask, s);
        }
        int index = p.target.indexOf(s);
        int from = firstLane(mask);
        int to = endLane(mask);
        computeDistances(p, s, mask, p.limit, from, to);
        if (index >= 0) {
            distancesToLight(p, s, index, from, to);
        }
        int blocked = 0;
        for (int h = from; h < to; h += DoubleLanes.COUNT) {
            DoubleVector limit = fromArray(SPECIES, p.limit, h);
            VectorMask<Double> below = fromArray(SPECIES, distances, h).compare(LT, limit);
            blocked |= (int) below.toLong() << h;
        }
        return blocked & mask;
    }

    /** Writes {@code t} and {@code part} of the lanes of {@code mask} whose primitive is {@code s}; returns these lanes. */
    int writeDistances(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            return mesh.writeDistances(p, s, mask);
        }
        int from = firstLane(mask);
        int to = endLane(mask);
        computeDistances(p, s, mask, unlimited, from, to);
        int matching = 0;
        for (int i = from; i < to; i++) {
            if ((mask >>> i & 1) != 0 && p.primitive[i] == s) {
                p.t[i] = distances[i];
                matching |= 1 << i;
            }
        }
        return matching;
    }
}

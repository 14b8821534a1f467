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

/**
 * One primitive against a packet: {@link PrimitiveTable#distance} in lanes, and what is done with the answer.
 *
 * <p>Solids are asked for whole vectors of lanes, those in which the mask has bits. Lanes that the primitive's box has
 * rejected get the same answer as from the box: a miss, or a hit behind a nearer one. Meshes are asked for the lanes of the mask
 * alone ({@link MeshGroupTracer}).
 *
 * <p>Where a solid has holes a ray is asked for them if the whole solid is nearer than what the ray has: what is there of it is no nearer.
 */
final class PrimitiveLanes {
    private static final VectorSpecies<Integer> INTS =
            VectorSpecies.of(int.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));

    private final PrimitiveTable primitives;
    /** The distances to the primitive in question. */
    private final double[] distances = new double[RayPacket.WIDTH];
    private final SolidGeometryLanes solidGeometry = new SolidGeometryLanes();
    /** Null where nothing has holes. */
    private final CutoutTest cutoutTest;
    private final double[] unlimited = new double[RayPacket.WIDTH];
    final MeshGroupTracer mesh;
    /** A group of one packet. */
    private final RayPacket[] singlePacket = new RayPacket[1];

    PrimitiveLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        mesh = new MeshGroupTracer(primitives);
        cutoutTest = primitives.hasCutouts() ? new CutoutTest(primitives) : null;
        Arrays.fill(unlimited, SolidGeometry.MISS);
    }

    /** The first lane of the vectors in which the mask has bits. */
    static int firstLane(int mask) {
        return (mask & -1 >>> -DoubleLanes.COUNT) != 0 ? 0 : DoubleLanes.COUNT;
    }

    static int endLane(int mask) {
        return mask >>> DoubleLanes.COUNT != 0 ? RayPacket.WIDTH : DoubleLanes.COUNT;
    }

    /**
     * Writes the distances of the lanes {@code from … to − 1}.
     *
     * @param mask   the lanes that are asked for holes
     * @param limits how far each is: what is whole is no farther off than what is there
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

    /** The distances of the ways to a light that lies on the primitive. */
    private void distancesToLight(RayPacket p, int s, int index, int from, int to) {
        for (int i = from; i < to; i++) {
            if (p.target.touches(index, p.ox[i], p.oy[i], p.oz[i])) {
                distances[i] = primitives.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], SurfaceContact.END);
            }
        }
    }

    /** Puts misses into all lanes. */
    void resetHits(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            broadcast(SPECIES, SolidGeometry.MISS).intoArray(p.t, h);
            broadcast(SPECIES, -1).intoArray(p.nearestPrimitive, h);
        }
    }

    /** Puts primitive {@code s} into the lanes of a mask, which is not 0, where it is nearer than what they have; whether there is one. */
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

    /** Writes what has been found to the packet's {@code primitive}. */
    void writePrimitives(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector v = fromArray(SPECIES, p.nearestPrimitive, h);
            ((IntVector) v.convertShape(D2I, INTS, 0)).intoArray(p.primitive, h);
        }
    }

    /** One bit for each lane of a mask, which is not 0, that meets primitive {@code s} at a distance below its {@code limit}. */
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

    /** Writes {@code t} and {@code part} of those lanes of {@code mask} whose primitive is {@code s}; returns which they are. */
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

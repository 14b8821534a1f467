package lightning.render.engine.lanes;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2I;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.Lanes.SPECIES;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.primitive.Holes;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.KindLanes;
import lightning.render.trace.solid.Lanes;
import lightning.render.trace.solid.Touch;

/**
 * One primitive against a packet: {@link PrimitiveTable#distance} in lanes, and what is done with the answer.
 *
 * <p>Solids are asked for whole vectors of lanes, those in which the mask has bits. Lanes that the primitive's box has
 * rejected get the same answer as from the box: a miss, or a hit behind a nearer one. Meshes are asked for the lanes of the mask
 * alone ({@link MeshGroup}).
 *
 * <p>Where a solid has holes a ray is asked for them if the whole solid is nearer than what the ray has: what is there of it is no nearer.
 */
final class SolidLanes {
    private static final VectorSpecies<Integer> INTS =
            VectorSpecies.of(int.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));

    private final PrimitiveTable primitives;
    /** The distances to the primitive in question. */
    private final double[] own = new double[RayPacket.WIDTH];
    private final KindLanes lanes = new KindLanes();
    /** Null where nothing has holes. */
    private final Holes holes;
    private final double[] unlimited = new double[RayPacket.WIDTH];
    final MeshGroup mesh;
    /** A group of one packet. */
    private final RayPacket[] alone = new RayPacket[1];

    SolidLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        mesh = new MeshGroup(primitives);
        holes = primitives.haveHoles() ? new Holes(primitives) : null;
        Arrays.fill(unlimited, Form.MISS);
    }

    /** The first lane of the vectors in which the mask has bits. */
    static int first(int mask) {
        return (mask & -1 >>> -Lanes.COUNT) != 0 ? 0 : Lanes.COUNT;
    }

    static int end(int mask) {
        return mask >>> Lanes.COUNT != 0 ? RayPacket.WIDTH : Lanes.COUNT;
    }

    /**
     * Writes the distances of the lanes {@code from … to − 1}.
     *
     * @param mask   the lanes that are asked for holes
     * @param limits how far each is: what is whole is no farther off than what is there
     */
    private void distances(RayPacket p, int s, int mask, double[] limits, int from, int to) {
        lanes.distances(primitives.kind(s), primitives.data, primitives.at[s], p, own, from, to);
        if (primitives.isUnderEye(s)) {
            for (int i = from; i < to; i++) {
                own[i] = primitives.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
            }
        } else if (holes != null && primitives.hasHoles(s)) {
            for (int left = mask; left != 0; left &= left - 1) {
                int i = Integer.numberOfTrailingZeros(left);
                if (own[i] <= limits[i] && own[i] < Form.MISS) {
                    own[i] = primitives.there(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], own[i], limits[i], holes);
                }
            }
        }
    }

    /** The distances of the ways to a light that lies on the primitive. */
    private void distancesToLight(RayPacket p, int s, int index, int from, int to) {
        for (int i = from; i < to; i++) {
            if (p.end.touches(index, p.ox[i], p.oy[i], p.oz[i])) {
                own[i] = primitives.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], Touch.END);
            }
        }
    }

    /** Puts misses into all lanes. */
    void begin(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
            broadcast(SPECIES, Form.MISS).intoArray(p.t, h);
            broadcast(SPECIES, -1).intoArray(p.found, h);
        }
    }

    /** Puts primitive {@code s} into the lanes of a mask, which is not 0, where it is nearer than what they have; whether there is one. */
    boolean nearer(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            alone[0] = p;
            return mesh.nearer(alone, mask, s) != 0;
        }
        int from = first(mask);
        int to = end(mask);
        distances(p, s, mask, p.t, from, to);
        boolean any = false;
        for (int h = from; h < to; h += Lanes.COUNT) {
            DoubleVector t = fromArray(SPECIES, own, h);
            DoubleVector best = fromArray(SPECIES, p.t, h);
            DoubleVector primitive = fromArray(SPECIES, p.found, h);
            VectorMask<Double> nearer = t.compare(LT, best).or(t.compare(EQ, best).and(primitive.compare(GT, s)));
            best.blend(t, nearer).intoArray(p.t, h);
            primitive.blend(s, nearer).intoArray(p.found, h);
            any |= nearer.anyTrue();
        }
        return any;
    }

    /** Writes what has been found to the packet's {@code primitive}. */
    void write(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
            DoubleVector v = fromArray(SPECIES, p.found, h);
            ((IntVector) v.convertShape(D2I, INTS, 0)).intoArray(p.primitive, h);
        }
    }

    /** One bit for each lane of a mask, which is not 0, that meets primitive {@code s} at a distance below its {@code limit}. */
    int below(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            alone[0] = p;
            return (int) mesh.below(alone, mask, s);
        }
        int index = p.end.indexOf(s);
        int from = first(mask);
        int to = end(mask);
        distances(p, s, mask, p.limit, from, to);
        if (index >= 0) {
            distancesToLight(p, s, index, from, to);
        }
        int met = 0;
        for (int h = from; h < to; h += Lanes.COUNT) {
            DoubleVector limit = fromArray(SPECIES, p.limit, h);
            VectorMask<Double> below = fromArray(SPECIES, own, h).compare(LT, limit);
            met |= (int) below.toLong() << h;
        }
        return met & mask;
    }

    /** Writes {@code t} and {@code part} of those lanes of {@code mask} whose primitive is {@code s}; returns which they are. */
    int distances(RayPacket p, int s, int mask) {
        if (primitives.mesh(s) != null) {
            return mesh.distances(p, s, mask);
        }
        int from = first(mask);
        int to = end(mask);
        distances(p, s, mask, unlimited, from, to);
        int done = 0;
        for (int i = from; i < to; i++) {
            if ((mask >>> i & 1) != 0 && p.primitive[i] == s) {
                p.t[i] = own[i];
                done |= 1 << i;
            }
        }
        return done;
    }
}

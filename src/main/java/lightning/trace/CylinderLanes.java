package lightning.trace;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** The side of {@link Solids#cylinder} in lanes, operation by operation. */
final class CylinderLanes {
    private CylinderLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the endless cylinder. */
    static void side(OwnRays r, SlabLanes slab, int from, int to) {
        for (int h = from; h < to; h += OwnRays.LANES) {
            DoubleVector miss = DoubleVector.broadcast(OwnRays.SPECIES, Solids.MISS);
            DoubleVector ox = DoubleVector.fromArray(OwnRays.SPECIES, r.ox, h);
            DoubleVector oz = DoubleVector.fromArray(OwnRays.SPECIES, r.oz, h);
            DoubleVector dx = DoubleVector.fromArray(OwnRays.SPECIES, r.dx, h);
            DoubleVector dy = DoubleVector.fromArray(OwnRays.SPECIES, r.dy, h);
            DoubleVector dz = DoubleVector.fromArray(OwnRays.SPECIES, r.dz, h);
            DoubleVector a = dx.mul(dx).add(dz.mul(dz));
            DoubleVector b = ox.mul(dx).add(oz.mul(dz)).neg();
            DoubleVector c = ox.mul(ox).add(oz.mul(oz)).sub(1);
            DoubleVector w = ox.mul(dz).sub(oz.mul(dx));
            DoubleVector root = a.sub(w.mul(w)).sqrt();
            DoubleVector q = b.sub(root).blend(b.add(root), b.compare(GE, 0));
            DoubleVector t0 = c.div(q);
            DoubleVector t1 = q.div(a);
            VectorMask<Double> parallel = a.compare(LE, dy.mul(dy).mul(Solids.PARALLEL));
            DoubleVector far = miss.neg().blend(miss, c.compare(LE, 0));
            VectorMask<Double> less = t0.compare(LT, t1);
            t1.blend(t0, less).blend(far.neg(), parallel).intoArray(slab.in, h);
            t0.blend(t1, less).blend(far, parallel).intoArray(slab.out, h);
        }
    }
}

package lightning.trace;

import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** The side of {@link Solids#cone} in lanes, operation by operation. */
final class ConeLanes {
    private ConeLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the side. */
    static void side(OwnRays r, SlabLanes slab, int from, int to) {
        for (int h = from; h < to; h += OwnRays.LANES) {
            DoubleVector miss = DoubleVector.broadcast(OwnRays.SPECIES, Solids.MISS);
            DoubleVector ox = DoubleVector.fromArray(OwnRays.SPECIES, r.ox, h);
            DoubleVector oz = DoubleVector.fromArray(OwnRays.SPECIES, r.oz, h);
            DoubleVector dx = DoubleVector.fromArray(OwnRays.SPECIES, r.dx, h);
            DoubleVector dz = DoubleVector.fromArray(OwnRays.SPECIES, r.dz, h);
            DoubleVector y = DoubleVector.broadcast(OwnRays.SPECIES, 1).sub(DoubleVector.fromArray(OwnRays.SPECIES, r.oy, h));
            DoubleVector dy = DoubleVector.fromArray(OwnRays.SPECIES, r.dy, h).neg();
            DoubleVector a = dx.mul(dx).add(dz.mul(dz)).sub(dy.mul(dy));
            DoubleVector b = y.mul(dy).sub(ox.mul(dx).add(oz.mul(dz)));
            DoubleVector c = ox.mul(ox).add(oz.mul(oz)).sub(y.mul(y));
            DoubleVector u = ox.mul(dy).sub(y.mul(dx));
            DoubleVector v = oz.mul(dy).sub(y.mul(dz));
            DoubleVector w = ox.mul(dz).sub(oz.mul(dx));
            DoubleVector root = u.mul(u).add(v.mul(v)).sub(w.mul(w)).sqrt();
            VectorMask<Double> ahead = b.compare(GE, 0);
            DoubleVector q = b.sub(root).blend(b.add(root), ahead);
            DoubleVector t0 = c.div(q);
            DoubleVector t1 = q.div(a);
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector low = t1.blend(t0, less);
            DoubleVector high = t0.blend(t1, less);
            VectorMask<Double> steep = a.compare(LT, 0);
            VectorMask<Double> open = steep.or(a.compare(EQ, 0));
            VectorMask<Double> down = dy.compare(GT, 0);
            VectorMask<Double> forwards = ahead.andNot(steep).or(steep.and(down));
            DoubleVector bound = t0.blend(low.blend(high, down), steep);
            DoubleVector in = low.blend(miss.neg().blend(bound, forwards), open);
            DoubleVector out = high.blend(bound.blend(miss, forwards), open);
            VectorMask<Double> none = root.compare(GE, 0).not().or(open.andNot(bound.compare(EQ, bound)));
            in.blend(miss, none).intoArray(slab.in, h);
            out.blend(miss.neg(), none).intoArray(slab.out, h);
        }
    }
}

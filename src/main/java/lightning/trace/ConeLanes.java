package lightning.trace;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.trace.Lanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** The side of {@link Solids#cone} in lanes, operation by operation. */
final class ConeLanes {
    private ConeLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the side. */
    static void side(double[] m, int i, RayPacket p, SlabLanes slab, int from, int to) {
        for (int h = from; h < to; h += Lanes.COUNT) {
            DoubleVector x = fromArray(SPECIES, p.ox, h);
            DoubleVector y = fromArray(SPECIES, p.oy, h);
            DoubleVector z = fromArray(SPECIES, p.oz, h);
            DoubleVector ox = x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).add(m[i + 3]);
            DoubleVector oy = x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).add(m[i + 7]);
            DoubleVector oz = x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).add(m[i + 11]);
            x = fromArray(SPECIES, p.dx, h);
            y = fromArray(SPECIES, p.dy, h);
            z = fromArray(SPECIES, p.dz, h);
            DoubleVector dx = x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2]));
            DoubleVector dy = x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6]));
            DoubleVector dz = x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10]));
            DoubleVector miss = broadcast(SPECIES, Solids.MISS);
            oy.intoArray(slab.oy, h);
            dy.intoArray(slab.dy, h);
            DoubleVector top = broadcast(SPECIES, 1).sub(oy);
            DoubleVector dh = dy.neg();
            DoubleVector side = dx.mul(dx).add(dz.mul(dz));
            DoubleVector up = dh.mul(dh);
            DoubleVector shift = ox.mul(dx).add(oz.mul(dz)).add(top.mul(dh)).neg().div(side.add(up));
            x = ox.add(shift.mul(dx));
            DoubleVector height = top.add(shift.mul(dh));
            z = oz.add(shift.mul(dz));
            DoubleVector a = side.sub(up);
            DoubleVector b = height.mul(dh).sub(x.mul(dx).add(z.mul(dz)));
            DoubleVector c = x.mul(x).add(z.mul(z)).sub(height.mul(height));
            DoubleVector u = x.mul(dh).sub(height.mul(dx));
            DoubleVector v = z.mul(dh).sub(height.mul(dz));
            DoubleVector w = x.mul(dz).sub(z.mul(dx));
            DoubleVector root = u.mul(u).add(v.mul(v)).sub(w.mul(w)).sqrt();
            VectorMask<Double> ahead = b.compare(GE, 0);
            DoubleVector q = b.sub(root).blend(b.add(root), ahead);
            DoubleVector t1 = shift.add(q.div(a));
            DoubleVector t0 = shift.add(c.div(q)).blend(t1, q.compare(EQ, 0));
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector low = t1.blend(t0, less);
            DoubleVector high = t0.blend(t1, less);
            VectorMask<Double> steep = a.compare(LT, 0);
            VectorMask<Double> open = steep.or(a.compare(EQ, 0));
            VectorMask<Double> down = dh.compare(GT, 0);
            VectorMask<Double> forwards = ahead.andNot(steep).or(steep.and(down));
            DoubleVector bound = t0.blend(low.blend(high, down), steep);
            DoubleVector in = low.blend(miss.neg().blend(bound, forwards), open);
            DoubleVector out = high.blend(bound.blend(miss, forwards), open);
            VectorMask<Double> none = c.mul(a).abs().compare(GT, q.mul(2).mul(q));
            in.blend(miss, none).intoArray(slab.sideIn, h);
            out.blend(miss.neg(), none).intoArray(slab.sideOut, h);
        }
    }
}

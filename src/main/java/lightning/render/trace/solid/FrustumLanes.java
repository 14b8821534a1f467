package lightning.render.trace.solid;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.Lanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** {@link Frustum} in lanes, operation by operation. */
final class FrustumLanes {
    private FrustumLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the side. */
    static void side(double[] m, int i, Rays p, SlabLanes slab, int from, int to) {
        double lean = 1 - m[i + Frustum.TOP];
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
            DoubleVector miss = broadcast(SPECIES, Form.MISS);
            oy.intoArray(slab.oy, h);
            dy.intoArray(slab.dy, h);
            DoubleVector top = broadcast(SPECIES, 1).sub(oy.mul(lean));
            DoubleVector dh = dy.mul(lean).neg();
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

    /** Writes directions that lead out of the surface at the own points {@code h … h + COUNT − 1}. */
    static void outward(double[] m, int i, PointLanes p, int h) {
        double top = m[i + Frustum.TOP];
        double lean = 1 - top;
        DoubleVector one = broadcast(SPECIES, 1);
        DoubleVector ox = fromArray(SPECIES, p.ownX, h);
        DoubleVector oy = fromArray(SPECIES, p.ownY, h);
        DoubleVector oz = fromArray(SPECIES, p.ownZ, h);
        DoubleVector radius = one.sub(oy.mul(lean));
        DoubleVector up = radius.mul(lean);
        if (m[i + Frustum.CAPS] == 0) {
            ox.intoArray(p.outX, h);
            up.intoArray(p.outY, h);
            oz.intoArray(p.outZ, h);
            return;
        }
        DoubleVector zero = broadcast(SPECIES, 0);
        DoubleVector disc = oy.abs();
        DoubleVector through = one.neg();
        if (top > 0) {
            DoubleVector above = one.sub(oy).abs();
            disc = disc.blend(above, above.compare(LE, disc));
            through = through.blend(one, oy.compare(GT, 0.5));
        }
        VectorMask<Double> side = ox.mul(ox).add(oz.mul(oz)).sqrt().sub(radius).abs().compare(LE, disc.mul(Frustum.steepness(top)));
        zero.blend(ox, side).intoArray(p.outX, h);
        through.blend(up, side).intoArray(p.outY, h);
        zero.blend(oz, side).intoArray(p.outZ, h);
    }
}

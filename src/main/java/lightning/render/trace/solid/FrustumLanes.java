package lightning.render.trace.solid;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.DoubleLanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** Lane version of {@link Frustum}, operation by operation. */
final class FrustumLanes {
    private FrustumLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the side. */
    static void writeSideIntervals(double[] m, int i, LaneRays p, IntervalHitLanes slab, int from, int to) {
        double taper = 1 - m[i + Frustum.TOP_RADIUS];
        for (int h = from; h < to; h += DoubleLanes.COUNT) {
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
            DoubleVector miss = broadcast(SPECIES, SolidGeometry.MISS);
            oy.intoArray(slab.oy, h);
            dy.intoArray(slab.dy, h);
            DoubleVector top = broadcast(SPECIES, 1).sub(oy.mul(taper));
            DoubleVector dh = dy.mul(taper).neg();
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
            VectorMask<Double> positiveB = b.compare(GE, 0);
            DoubleVector q = b.sub(root).blend(b.add(root), positiveB);
            DoubleVector t1 = shift.add(q.div(a));
            DoubleVector t0 = shift.add(c.div(q)).blend(t1, q.compare(EQ, 0));
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector low = t1.blend(t0, less);
            DoubleVector high = t0.blend(t1, less);
            VectorMask<Double> steep = a.compare(LT, 0);
            VectorMask<Double> unbounded = steep.or(a.compare(EQ, 0));
            VectorMask<Double> down = dh.compare(GT, 0);
            VectorMask<Double> forward = positiveB.andNot(steep).or(steep.and(down));
            DoubleVector bound = t0.blend(low.blend(high, down), steep);
            DoubleVector in = low.blend(miss.neg().blend(bound, forward), unbounded);
            DoubleVector out = high.blend(bound.blend(miss, forward), unbounded);
            VectorMask<Double> missed = c.mul(a).abs().compare(GT, q.mul(2).mul(q));
            in.blend(miss, missed).intoArray(slab.sideIn, h);
            out.blend(miss.neg(), missed).intoArray(slab.sideOut, h);
        }
    }

    /** Writes outward directions of the surface at the local points {@code h … h + COUNT − 1}. */
    static void outwardNormals(double[] m, int i, PointLanes p, int h) {
        double top = m[i + Frustum.TOP_RADIUS];
        double taper = 1 - top;
        DoubleVector one = broadcast(SPECIES, 1);
        DoubleVector ox = fromArray(SPECIES, p.localX, h);
        DoubleVector oy = fromArray(SPECIES, p.localY, h);
        DoubleVector oz = fromArray(SPECIES, p.localZ, h);
        DoubleVector radius = one.sub(oy.mul(taper));
        DoubleVector up = radius.mul(taper);
        if (m[i + Frustum.CAPS] == 0) {
            ox.intoArray(p.outwardX, h);
            up.intoArray(p.outwardY, h);
            oz.intoArray(p.outwardZ, h);
            return;
        }
        DoubleVector zero = broadcast(SPECIES, 0);
        DoubleVector disc = oy.abs();
        DoubleVector capNormal = one.neg();
        if (top > 0) {
            DoubleVector above = one.sub(oy).abs();
            disc = disc.blend(above, above.compare(LE, disc));
            capNormal = capNormal.blend(one, oy.compare(GT, 0.5));
        }
        VectorMask<Double> side = ox.mul(ox).add(oz.mul(oz)).sqrt().sub(radius).abs().compare(LE, disc.mul(Frustum.steepness(top)));
        zero.blend(ox, side).intoArray(p.outwardX, h);
        capNormal.blend(up, side).intoArray(p.outwardY, h);
        zero.blend(oz, side).intoArray(p.outwardZ, h);
    }
}

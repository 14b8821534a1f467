package lightning.trace;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** {@link Solids#sphere} in lanes, operation by operation. */
final class SphereLanes {
    private SphereLanes() {}

    /** Writes the distances of the lanes {@code from … to − 1} to {@code r.t}. */
    static void distances(OwnRays r, int from, int to) {
        for (int h = from; h < to; h += OwnRays.LANES) {
            DoubleVector ox = DoubleVector.fromArray(OwnRays.SPECIES, r.ox, h);
            DoubleVector oy = DoubleVector.fromArray(OwnRays.SPECIES, r.oy, h);
            DoubleVector oz = DoubleVector.fromArray(OwnRays.SPECIES, r.oz, h);
            DoubleVector dx = DoubleVector.fromArray(OwnRays.SPECIES, r.dx, h);
            DoubleVector dy = DoubleVector.fromArray(OwnRays.SPECIES, r.dy, h);
            DoubleVector dz = DoubleVector.fromArray(OwnRays.SPECIES, r.dz, h);
            DoubleVector a = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz));
            DoubleVector b = ox.mul(dx).add(oy.mul(dy)).add(oz.mul(dz)).neg();
            DoubleVector c = ox.mul(ox).add(oy.mul(oy)).add(oz.mul(oz)).sub(1);
            DoubleVector u = oy.mul(dz).sub(oz.mul(dy));
            DoubleVector v = oz.mul(dx).sub(ox.mul(dz));
            DoubleVector w = ox.mul(dy).sub(oy.mul(dx));
            DoubleVector root = a.sub(u.mul(u).add(v.mul(v)).add(w.mul(w))).sqrt();
            VectorMask<Double> ahead = b.compare(GE, 0);
            DoubleVector q = b.sub(root).blend(b.add(root), ahead);
            VectorMask<Double> leaves = c.compare(LE, 0).and(ahead);
            DoubleVector t = c.blend(q, leaves).div(q.blend(a, leaves));
            VectorMask<Double> hit = t.compare(GT, 0).and(t.compare(LT, Solids.MISS));
            DoubleVector.broadcast(OwnRays.SPECIES, Solids.MISS).blend(t, hit).intoArray(r.t, h);
        }
    }
}

package lightning.trace;

import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** {@link Solids#withinSlab} in lanes: the caps of cone and cylinder, cut out of the intervals of their sides. */
final class SlabLanes {
    /** The intervals in which the rays are within the side. */
    final double[] in = new double[RayPacket.WIDTH];
    final double[] out = new double[RayPacket.WIDTH];

    /** Writes the distances of the lanes {@code from … to − 1} to {@code r.t}. */
    void distances(OwnRays r, int from, int to) {
        for (int h = from; h < to; h += OwnRays.LANES) {
            DoubleVector miss = DoubleVector.broadcast(OwnRays.SPECIES, Solids.MISS);
            DoubleVector one = DoubleVector.broadcast(OwnRays.SPECIES, 1);
            DoubleVector oy = DoubleVector.fromArray(OwnRays.SPECIES, r.oy, h);
            DoubleVector inverse = one.div(DoubleVector.fromArray(OwnRays.SPECIES, r.dy, h));
            DoubleVector t0 = oy.neg().mul(inverse);
            DoubleVector t1 = one.sub(oy).mul(inverse);
            VectorMask<Double> level = inverse.abs().compare(EQ, Solids.MISS);
            VectorMask<Double> between = oy.compare(GE, 0).and(oy.compare(LE, 1));
            DoubleVector far = miss.neg().blend(miss, between);
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector slabIn = t1.blend(t0, less).blend(far.neg(), level);
            DoubleVector slabOut = t0.blend(t1, less).blend(far, level);
            DoubleVector sideIn = DoubleVector.fromArray(OwnRays.SPECIES, in, h);
            DoubleVector sideOut = DoubleVector.fromArray(OwnRays.SPECIES, out, h);
            DoubleVector first = sideIn.blend(slabIn, sideIn.compare(LT, slabIn));
            DoubleVector last = sideOut.blend(slabOut, slabOut.compare(LT, sideOut));
            DoubleVector t = last.blend(first, first.compare(GT, 0));
            VectorMask<Double> hit = first.compare(LE, last).and(last.compare(GT, 0)).and(t.compare(LT, Solids.MISS));
            miss.blend(t, hit).intoArray(r.t, h);
        }
    }
}

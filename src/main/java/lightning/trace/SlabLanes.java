package lightning.trace;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.trace.Lanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** {@link Solids#withinSlab} in lanes: the caps of cone and cylinder, cut out of the intervals of their sides. */
final class SlabLanes {
    /** Heights of the origins and of the directions in the shape's space. */
    final double[] oy = new double[RayPacket.WIDTH];
    final double[] dy = new double[RayPacket.WIDTH];
    /** The intervals in which the rays are within the side. */
    final double[] sideIn = new double[RayPacket.WIDTH];
    final double[] sideOut = new double[RayPacket.WIDTH];

    /** Writes the distances of the lanes {@code from … to − 1} to {@code out}. */
    void distances(double[] out, int from, int to) {
        for (int h = from; h < to; h += Lanes.COUNT) {
            DoubleVector miss = broadcast(SPECIES, Solids.MISS);
            DoubleVector one = broadcast(SPECIES, 1);
            DoubleVector y = fromArray(SPECIES, oy, h);
            DoubleVector inverse = one.div(fromArray(SPECIES, dy, h));
            DoubleVector t0 = y.neg().mul(inverse);
            DoubleVector t1 = one.sub(y).mul(inverse);
            VectorMask<Double> level = inverse.abs().compare(EQ, Solids.MISS);
            VectorMask<Double> between = y.compare(GE, 0).and(y.compare(LE, 1));
            DoubleVector far = miss.neg().blend(miss, between);
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector slabIn = t1.blend(t0, less).blend(far.neg(), level);
            DoubleVector slabOut = t0.blend(t1, less).blend(far, level);
            DoubleVector in = fromArray(SPECIES, sideIn, h);
            DoubleVector end = fromArray(SPECIES, sideOut, h);
            DoubleVector first = in.blend(slabIn, in.compare(LT, slabIn));
            DoubleVector last = end.blend(slabOut, slabOut.compare(LT, end));
            DoubleVector t = last.blend(first, first.compare(GT, 0));
            VectorMask<Double> hit = first.compare(LE, last).and(last.compare(GT, 0)).and(t.compare(LT, Solids.MISS));
            miss.blend(t, hit).intoArray(out, h);
        }
    }
}

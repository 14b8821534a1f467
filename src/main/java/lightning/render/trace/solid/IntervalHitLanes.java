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

/** Lane version of {@link IntervalHit}, operation by operation. */
final class IntervalHitLanes {
    /** Local y of the origins and of the directions. */
    final double[] oy = new double[LaneRays.WIDTH];
    final double[] dy = new double[LaneRays.WIDTH];
    /** Intervals of the rays inside the side. */
    final double[] sideIn = new double[LaneRays.WIDTH];
    final double[] sideOut = new double[LaneRays.WIDTH];

    /**
     * Writes the distances of {@link IntervalHit#hitWithCaps}, or of {@link IntervalHit#hitWithoutCaps}, for the lanes
     * {@code from … to − 1} to {@code out}.
     */
    void hit(boolean hasCaps, double[] out, int from, int to) {
        for (int h = from; h < to; h += DoubleLanes.COUNT) {
            DoubleVector miss = broadcast(SPECIES, SolidGeometry.MISS);
            DoubleVector one = broadcast(SPECIES, 1);
            DoubleVector y = fromArray(SPECIES, oy, h);
            DoubleVector inverse = one.div(fromArray(SPECIES, dy, h));
            DoubleVector t0 = y.neg().mul(inverse);
            DoubleVector t1 = one.sub(y).mul(inverse);
            VectorMask<Double> level = inverse.abs().compare(EQ, SolidGeometry.MISS);
            VectorMask<Double> insideSlab = y.compare(GE, 0).and(y.compare(LE, 1));
            DoubleVector far = miss.neg().blend(miss, insideSlab);
            VectorMask<Double> less = t0.compare(LT, t1);
            DoubleVector slabIn = t1.blend(t0, less).blend(far.neg(), level);
            DoubleVector slabOut = t0.blend(t1, less).blend(far, level);
            DoubleVector in = fromArray(SPECIES, sideIn, h);
            DoubleVector end = fromArray(SPECIES, sideOut, h);
            if (hasCaps) {
                DoubleVector first = in.blend(slabIn, in.compare(LT, slabIn));
                DoubleVector last = end.blend(slabOut, slabOut.compare(LT, end));
                DoubleVector t = last.blend(first, first.compare(GT, 0));
                VectorMask<Double> hit = first.compare(LE, last).and(last.compare(GT, 0)).and(t.compare(LT, SolidGeometry.MISS));
                miss.blend(t, hit).intoArray(out, h);
            } else {
                VectorMask<Double> enters = in.compare(GE, slabIn).and(in.compare(LE, slabOut)).and(in.compare(GT, 0));
                VectorMask<Double> leaves = end.compare(GE, slabIn).and(end.compare(LE, slabOut)).and(end.compare(GT, 0));
                VectorMask<Double> hit = in.compare(LE, end).and(enters.or(leaves));
                miss.blend(end.blend(in, enters), hit).intoArray(out, h);
            }
        }
    }
}

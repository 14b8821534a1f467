package lightning.trace;

import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** {@link Solids#plane} in lanes, operation by operation. */
final class PlaneLanes {
    private PlaneLanes() {}

    /** Writes the distances of the lanes {@code from … to − 1} to {@code r.t}. */
    static void distances(OwnRays r, int from, int to) {
        for (int h = from; h < to; h += OwnRays.LANES) {
            DoubleVector ox = DoubleVector.fromArray(OwnRays.SPECIES, r.ox, h);
            DoubleVector oy = DoubleVector.fromArray(OwnRays.SPECIES, r.oy, h);
            DoubleVector oz = DoubleVector.fromArray(OwnRays.SPECIES, r.oz, h);
            DoubleVector dx = DoubleVector.fromArray(OwnRays.SPECIES, r.dx, h);
            DoubleVector dy = DoubleVector.fromArray(OwnRays.SPECIES, r.dy, h);
            DoubleVector dz = DoubleVector.fromArray(OwnRays.SPECIES, r.dz, h);
            DoubleVector t = oy.neg().div(dy);
            DoubleVector x = ox.add(t.mul(dx));
            DoubleVector z = oz.add(t.mul(dz));
            VectorMask<Double> hit = t.compare(GT, 0).and(t.compare(LT, Solids.MISS))
                    .and(x.abs().compare(LE, 0.5)).and(z.abs().compare(LE, 0.5));
            DoubleVector.broadcast(OwnRays.SPECIES, Solids.MISS).blend(t, hit).intoArray(r.t, h);
        }
    }
}

package lightning.render.trace.solid;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.DoubleLanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** Lane version of {@link Plane}, operation by operation. */
final class PlaneLanes {
    private PlaneLanes() {}

    /** Writes the distances of the lanes {@code from … to − 1} to {@code out}. */
    static void distances(double[] m, int i, LaneRays p, double[] out, int from, int to) {
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
            DoubleVector t = oy.neg().div(dy);
            x = ox.add(t.mul(dx));
            z = oz.add(t.mul(dz));
            VectorMask<Double> hit = t.compare(GT, 0).and(t.compare(LT, SolidGeometry.MISS))
                    .and(x.abs().compare(LE, 0.5)).and(z.abs().compare(LE, 0.5));
            broadcast(SPECIES, SolidGeometry.MISS).blend(t, hit).intoArray(out, h);
        }
    }

    /** Writes outward directions of the surface at the local points {@code h … h + COUNT − 1}. */
    static void outwardNormals(PointLanes p, int h) {
        broadcast(SPECIES, 0).intoArray(p.outwardX, h);
        broadcast(SPECIES, 1).intoArray(p.outwardY, h);
        broadcast(SPECIES, 0).intoArray(p.outwardZ, h);
    }
}

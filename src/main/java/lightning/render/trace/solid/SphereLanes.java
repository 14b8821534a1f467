package lightning.render.trace.solid;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static lightning.render.trace.solid.DoubleLanes.SPECIES;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;

/** Lane version of {@link Sphere}, operation by operation. */
final class SphereLanes {
    private SphereLanes() {}

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
            DoubleVector a = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz));
            DoubleVector b = ox.mul(dx).add(oy.mul(dy)).add(oz.mul(dz)).neg();
            DoubleVector c = ox.mul(ox).add(oy.mul(oy)).add(oz.mul(oz)).sub(1);
            DoubleVector u = oy.mul(dz).sub(oz.mul(dy));
            DoubleVector v = oz.mul(dx).sub(ox.mul(dz));
            DoubleVector w = ox.mul(dy).sub(oy.mul(dx));
            DoubleVector root = a.sub(u.mul(u).add(v.mul(v)).add(w.mul(w))).sqrt();
            VectorMask<Double> positiveB = b.compare(GE, 0);
            DoubleVector q = b.sub(root).blend(b.add(root), positiveB);
            VectorMask<Double> leaves = c.compare(LE, 0).and(positiveB);
            DoubleVector t = c.blend(q, leaves).div(q.blend(a, leaves));
            VectorMask<Double> hit = t.compare(GT, 0).and(t.compare(LT, SolidGeometry.MISS))
                    .and(c.mul(a).abs().compare(LE, q.mul(2).mul(q)));
            broadcast(SPECIES, SolidGeometry.MISS).blend(t, hit).intoArray(out, h);
        }
    }

    /** Writes outward directions of the surface at the local points {@code h … h + COUNT − 1}. */
    static void outwardNormals(PointLanes p, int h) {
        fromArray(SPECIES, p.localX, h).intoArray(p.outwardX, h);
        fromArray(SPECIES, p.localY, h).intoArray(p.outwardY, h);
        fromArray(SPECIES, p.localZ, h).intoArray(p.outwardZ, h);
    }
}

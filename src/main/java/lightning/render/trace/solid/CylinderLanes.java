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

/** Lane version of {@link Cylinder}, operation by operation. */
final class CylinderLanes {
    private CylinderLanes() {}

    /** Writes the intervals of the lanes {@code from … to − 1} inside the infinite cylinder. */
    static void writeSideIntervals(double[] m, int i, LaneRays p, IntervalHitLanes slab, int from, int to) {
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
            oy.intoArray(slab.oy, h);
            dy.intoArray(slab.dy, h);
            DoubleVector miss = broadcast(SPECIES, SolidGeometry.MISS);
            DoubleVector a = dx.mul(dx).add(dz.mul(dz));
            DoubleVector b = ox.mul(dx).add(oz.mul(dz)).neg();
            DoubleVector c = ox.mul(ox).add(oz.mul(oz)).sub(1);
            DoubleVector w = ox.mul(dz).sub(oz.mul(dx));
            DoubleVector root = a.sub(w.mul(w)).sqrt();
            DoubleVector q = b.sub(root).blend(b.add(root), b.compare(GE, 0));
            DoubleVector t0 = c.div(q);
            DoubleVector t1 = q.div(a);
            VectorMask<Double> parallel = a.compare(LE, dy.mul(dy).mul(Cylinder.PARALLEL));
            DoubleVector far = miss.neg().blend(miss, c.compare(LE, 0));
            VectorMask<Double> less = t0.compare(LT, t1);
            VectorMask<Double> touches = c.mul(a).abs().compare(GT, q.mul(2).mul(q));
            t1.blend(t0, less).blend(miss, touches).blend(far.neg(), parallel).intoArray(slab.sideIn, h);
            t0.blend(t1, less).blend(far, parallel).intoArray(slab.sideOut, h);
        }
    }

    /** Writes outward directions of the surface at the local points {@code h … h + COUNT − 1}. */
    static void outwardNormals(double[] m, int i, PointLanes p, int h) {
        DoubleVector zero = broadcast(SPECIES, 0);
        DoubleVector ox = fromArray(SPECIES, p.localX, h);
        DoubleVector oz = fromArray(SPECIES, p.localZ, h);
        if (m[i + Frustum.CAPS] == 0) {
            ox.intoArray(p.outwardX, h);
            zero.intoArray(p.outwardY, h);
            oz.intoArray(p.outwardZ, h);
            return;
        }
        DoubleVector one = broadcast(SPECIES, 1);
        DoubleVector oy = fromArray(SPECIES, p.localY, h);
        DoubleVector below = oy.abs();
        DoubleVector above = one.sub(oy).abs();
        DoubleVector disc = below.blend(above, above.compare(LE, below));
        VectorMask<Double> side = ox.mul(ox).add(oz.mul(oz)).sqrt().sub(1).abs().compare(LE, disc);
        zero.blend(ox, side).intoArray(p.outwardX, h);
        one.neg().blend(one, oy.compare(GT, 0.5)).blend(zero, side).intoArray(p.outwardY, h);
        zero.blend(oz, side).intoArray(p.outwardZ, h);
    }
}

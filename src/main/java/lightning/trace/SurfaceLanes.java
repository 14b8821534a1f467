package lightning.trace;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;

/**
 * {@link Surface#at} in lanes, operation by operation: the lanes of a packet are taken shape by shape,
 * of which it meets one or two as a rule.
 */
final class SurfaceLanes {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    private static final VectorShape HALF_SHAPE = VectorShape.forBitSize(SPECIES.vectorBitSize() / 2);
    private static final VectorSpecies<Float> FLOATS = VectorSpecies.of(float.class, HALF_SHAPE);
    private static final VectorSpecies<Integer> INTS = VectorSpecies.of(int.class, HALF_SHAPE);
    private static final DoubleVector ZERO = DoubleVector.zero(SPECIES);
    private static final DoubleVector ONE = broadcast(SPECIES, 1);

    private final ShapeTable shapes;
    private final double[] x = new double[RayPacket.WIDTH];
    private final double[] y = new double[RayPacket.WIDTH];
    private final double[] z = new double[RayPacket.WIDTH];
    private final double[] ownX = new double[RayPacket.WIDTH];
    private final double[] ownY = new double[RayPacket.WIDTH];
    private final double[] ownZ = new double[RayPacket.WIDTH];
    /** Outward directions in the shape's space. */
    private final double[] ax = new double[RayPacket.WIDTH];
    private final double[] ay = new double[RayPacket.WIDTH];
    private final double[] az = new double[RayPacket.WIDTH];

    SurfaceLanes(ShapeTable shapes) {
        this.shapes = shapes;
    }

    /** Computes the surfaces of those of the first {@code live} lanes that hit a shape. */
    void at(RayPacket p, int live, SurfacePacket out) {
        points(p);
        int left = 0;
        for (int i = 0; i < live; i++) {
            left |= (p.shape[i] >>> 31 ^ 1) << i;
        }
        while (left != 0) {
            int s = p.shape[Integer.numberOfTrailingZeros(left)];
            for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
                VectorMask<Integer> same = IntVector.fromArray(INTS, p.shape, h).compare(EQ, s);
                int mask = (int) same.toLong();
                if (mask != 0) {
                    left &= ~(mask << h);
                    ownPoints(s, h);
                    switch (shapes.kind[s]) {
                        case ShapeTable.SPHERE -> outOfSphere(h);
                        case ShapeTable.CONE -> outOfCone(h);
                        case ShapeTable.CYLINDER -> outOfCylinder(h);
                        default -> outOfPlane(h);
                    }
                    store(p, s, h, mask, out);
                }
            }
        }
    }

    private void points(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += Lanes.COUNT) {
            DoubleVector t = fromArray(SPECIES, p.t, h);
            fromArray(SPECIES, p.ox, h).add(t.mul(fromArray(SPECIES, p.dx, h))).intoArray(x, h);
            fromArray(SPECIES, p.oy, h).add(t.mul(fromArray(SPECIES, p.dy, h))).intoArray(y, h);
            fromArray(SPECIES, p.oz, h).add(t.mul(fromArray(SPECIES, p.dz, h))).intoArray(z, h);
        }
    }

    private void ownPoints(int s, int h) {
        double[] m = shapes.inverse;
        int i = 12 * s;
        DoubleVector px = fromArray(SPECIES, x, h);
        DoubleVector py = fromArray(SPECIES, y, h);
        DoubleVector pz = fromArray(SPECIES, z, h);
        px.mul(m[i]).add(py.mul(m[i + 1])).add(pz.mul(m[i + 2])).add(m[i + 3]).intoArray(ownX, h);
        px.mul(m[i + 4]).add(py.mul(m[i + 5])).add(pz.mul(m[i + 6])).add(m[i + 7]).intoArray(ownY, h);
        px.mul(m[i + 8]).add(py.mul(m[i + 9])).add(pz.mul(m[i + 10])).add(m[i + 11]).intoArray(ownZ, h);
    }

    private void outOfSphere(int h) {
        fromArray(SPECIES, ownX, h).intoArray(ax, h);
        fromArray(SPECIES, ownY, h).intoArray(ay, h);
        fromArray(SPECIES, ownZ, h).intoArray(az, h);
    }

    private void outOfPlane(int h) {
        ZERO.intoArray(ax, h);
        ONE.intoArray(ay, h);
        ZERO.intoArray(az, h);
    }

    private void outOfCone(int h) {
        DoubleVector ox = fromArray(SPECIES, ownX, h);
        DoubleVector oy = fromArray(SPECIES, ownY, h);
        DoubleVector oz = fromArray(SPECIES, ownZ, h);
        DoubleVector height = ONE.sub(oy);
        VectorMask<Double> side = ox.mul(ox).add(oz.mul(oz)).sqrt().sub(height).abs().compare(LE, oy.abs());
        ZERO.blend(ox, side).intoArray(ax, h);
        broadcast(SPECIES, -1).blend(height, side).intoArray(ay, h);
        ZERO.blend(oz, side).intoArray(az, h);
    }

    private void outOfCylinder(int h) {
        DoubleVector ox = fromArray(SPECIES, ownX, h);
        DoubleVector oy = fromArray(SPECIES, ownY, h);
        DoubleVector oz = fromArray(SPECIES, ownZ, h);
        DoubleVector below = oy.abs();
        DoubleVector above = ONE.sub(oy).abs();
        DoubleVector cap = above.blend(below, below.compare(LT, above));
        VectorMask<Double> side = ox.mul(ox).add(oz.mul(oz)).sqrt().sub(1).abs().compare(LE, cap);
        ZERO.blend(ox, side).intoArray(ax, h);
        broadcast(SPECIES, -1).blend(ONE, oy.compare(GT, 0.5)).blend(ZERO, side).intoArray(ay, h);
        ZERO.blend(oz, side).intoArray(az, h);
    }

    private void store(RayPacket p, int s, int h, int lanes, SurfacePacket out) {
        double[] m = shapes.inverse;
        int i = 12 * s;
        DoubleVector vx = fromArray(SPECIES, ax, h);
        DoubleVector vy = fromArray(SPECIES, ay, h);
        DoubleVector vz = fromArray(SPECIES, az, h);
        DoubleVector bx = vx.mul(m[i]).add(vy.mul(m[i + 4])).add(vz.mul(m[i + 8]));
        DoubleVector by = vx.mul(m[i + 1]).add(vy.mul(m[i + 5])).add(vz.mul(m[i + 9]));
        DoubleVector bz = vx.mul(m[i + 2]).add(vy.mul(m[i + 6])).add(vz.mul(m[i + 10]));
        DoubleVector square = bx.mul(bx).add(by.mul(by)).add(bz.mul(bz));
        VectorMask<Double> lost = square.compare(GT, 0).not();
        if (lost.anyTrue()) {
            bx = bx.blend(fromArray(SPECIES, p.dx, h).neg(), lost);
            by = by.blend(fromArray(SPECIES, p.dy, h).neg(), lost);
            bz = bz.blend(fromArray(SPECIES, p.dz, h).neg(), lost);
            square = bx.mul(bx).add(by.mul(by)).add(bz.mul(bz));
        }
        DoubleVector length = square.sqrt();
        VectorMask<Double> away = bx.mul(fromArray(SPECIES, p.dx, h))
                .add(by.mul(fromArray(SPECIES, p.dy, h)))
                .add(bz.mul(fromArray(SPECIES, p.dz, h)))
                .compare(GT, 0);
        DoubleVector unit = ONE.div(length.blend(length.neg(), away));
        bx = bx.mul(unit);
        by = by.mul(unit);
        bz = bz.mul(unit);
        DoubleVector px = fromArray(SPECIES, x, h);
        DoubleVector py = fromArray(SPECIES, y, h);
        DoubleVector pz = fromArray(SPECIES, z, h);
        DoubleVector origin =
                fromArray(SPECIES, p.ox, h).abs().add(fromArray(SPECIES, p.oy, h).abs()).add(fromArray(SPECIES, p.oz, h).abs());
        DoubleVector off = px.mul(bx).abs().add(py.mul(by).abs()).add(pz.mul(bz).abs()).mul(Surface.OFFSET)
                .add(origin.mul(Surface.ERROR).add(shapes.error[s]));
        VectorMask<Double> mask = VectorMask.fromLong(SPECIES, lanes);
        VectorMask<Float> floats = VectorMask.fromLong(FLOATS, lanes);
        fromArray(SPECIES, ownX, h).intoArray(out.ownX, h, mask);
        fromArray(SPECIES, ownY, h).intoArray(out.ownY, h, mask);
        fromArray(SPECIES, ownZ, h).intoArray(out.ownZ, h, mask);
        ((FloatVector) px.add(bx.mul(off)).convertShape(D2F, FLOATS, 0)).intoArray(out.px, h, floats);
        ((FloatVector) py.add(by.mul(off)).convertShape(D2F, FLOATS, 0)).intoArray(out.py, h, floats);
        ((FloatVector) pz.add(bz.mul(off)).convertShape(D2F, FLOATS, 0)).intoArray(out.pz, h, floats);
        ((FloatVector) bx.convertShape(D2F, FLOATS, 0)).intoArray(out.nx, h, floats);
        ((FloatVector) by.convertShape(D2F, FLOATS, 0)).intoArray(out.ny, h, floats);
        ((FloatVector) bz.convertShape(D2F, FLOATS, 0)).intoArray(out.nz, h, floats);
    }
}

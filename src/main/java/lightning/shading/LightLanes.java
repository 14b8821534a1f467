package lightning.shading;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.scene.Attenuation;
import lightning.trace.HitRows;
import lightning.trace.RayPacket;

/**
 * {@link LightingEquation} in lanes, over all rows of a tile: the same operations in the same order.
 * Holds scratch columns: one for each thread.
 */
final class LightLanes {
    static final VectorSpecies<Double> D = DoubleVector.SPECIES_PREFERRED;
    /** As many floats as there are double lanes. */
    private static final VectorSpecies<Float> F =
            VectorSpecies.of(float.class, VectorShape.forBitSize(D.vectorBitSize() / 2));
    static final int LANES = D.length();
    private static final VectorSpecies<Float> PACKET = FloatVector.SPECIES_PREFERRED;
    static final int ROWS = 1024;

    /** The unit vector from each row to the light. */
    private final double[] lx = new double[ROWS];
    private final double[] ly = new double[ROWS];
    private final double[] lz = new double[ROWS];
    private final double[] distance = new double[ROWS];
    /** The cosine from the cone's axis. */
    final double[] axisCosine = new double[ROWS];
    private final double[] power = new double[ROWS];

    /** As {@link LightingEquation#at}, for all rows. */
    void aim(HitRows rows, Lamp lamp) {
        double x = lamp.source().x();
        double y = lamp.source().y();
        double z = lamp.source().z();
        if (lamp.type().hasPosition()) {
            aimAtPoint(rows, x, y, z);
        } else {
            java.util.Arrays.fill(lx, 0, HitRows.padded(rows.count), x);
            java.util.Arrays.fill(ly, 0, HitRows.padded(rows.count), y);
            java.util.Arrays.fill(lz, 0, HitRows.padded(rows.count), z);
        }
    }

    private void aimAtPoint(HitRows rows, double x, double y, double z) {
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector vx = DoubleVector.broadcast(D, x).sub(load(rows.px, i));
            DoubleVector vy = DoubleVector.broadcast(D, y).sub(load(rows.py, i));
            DoubleVector vz = DoubleVector.broadcast(D, z).sub(load(rows.pz, i));
            DoubleVector d = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(VectorOperators.SQRT);
            VectorMask<Double> here = d.compare(VectorOperators.LT, LightingEquation.NO_DISTANCE);
            DoubleVector inverse = DoubleVector.broadcast(D, 1).div(d);
            d.intoArray(distance, i);
            vx.mul(inverse).blend(load(rows.nx, i), here).intoArray(lx, i);
            vy.mul(inverse).blend(load(rows.ny, i), here).intoArray(ly, i);
            vz.mul(inverse).blend(load(rows.nz, i), here).intoArray(lz, i);
        }
    }

    /** As {@link LightingEquation#cosine}, for all rows. */
    void cosines(HitRows rows, float[] to) {
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = load(rows.nx, i).mul(DoubleVector.fromArray(D, lx, i))
                    .add(load(rows.ny, i).mul(DoubleVector.fromArray(D, ly, i)))
                    .add(load(rows.nz, i).mul(DoubleVector.fromArray(D, lz, i)));
            store(c, to, i);
        }
    }

    /** The cosine from the cone's axis, −1…1, into {@link #axisCosine}. */
    void axisCosines(HitRows rows, Lamp lamp) {
        double ax = lamp.axis().x();
        double ay = lamp.axis().y();
        double az = lamp.axis().z();
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = DoubleVector.fromArray(D, lx, i).mul(ax)
                    .add(DoubleVector.fromArray(D, ly, i).mul(ay))
                    .add(DoubleVector.fromArray(D, lz, i).mul(az)).neg();
            DoubleVector low = c.blend(-1, c.compare(VectorOperators.LT, -1));
            low.blend(1, c.compare(VectorOperators.GT, 1)).intoArray(axisCosine, i);
        }
    }

    /** Which rows of packet {@code b} have a cosine above 0, one bit each. */
    int facing(float[] cosine, int b) {
        return (int) FloatVector.fromArray(PACKET, cosine, b * RayPacket.WIDTH).compare(VectorOperators.GT, 0).toLong();
    }

    /** Which rows of packet {@code b} are in the cone, as {@link LightingEquation#insideCone}, one bit each. */
    int inside(int b, double cosAngle) {
        int bits = 0;
        for (int i = 0; i < RayPacket.WIDTH; i += LANES) {
            DoubleVector c = DoubleVector.fromArray(D, axisCosine, b * RayPacket.WIDTH + i);
            bits |= (int) c.compare(VectorOperators.GE, cosAngle).toLong() << i;
        }
        return bits;
    }

    /** As {@link LightingEquation#falloff}, for all rows of a point or spot light. */
    void falloffs(HitRows rows, Lamp lamp, float[] to) {
        if (lamp.type().hasCone()) {
            spots(rows, lamp.light().dropoff());
        }
        Attenuation a = lamp.light().attenuation();
        boolean cone = lamp.type().hasCone();
        for (int i = 0; i < rows.count; i += LANES) {
            store(factor(a, cone, i), to, i);
        }
    }

    /** The falloff before it is rounded to float. */
    void factors(HitRows rows, Lamp lamp, double[] to) {
        if (lamp.type().hasCone()) {
            spots(rows, lamp.light().dropoff());
        }
        Attenuation a = lamp.light().attenuation();
        boolean cone = lamp.type().hasCone();
        for (int i = 0; i < rows.count; i += LANES) {
            factor(a, cone, i).intoArray(to, i);
        }
    }

    private DoubleVector factor(Attenuation a, boolean cone, int i) {
        DoubleVector d = DoubleVector.fromArray(D, distance, i);
        DoubleVector sum = d.mul(a.linear()).add(a.constant()).add(d.mul(d).mul(a.quadratic()));
        DoubleVector factor = DoubleVector.broadcast(D, 1).div(sum);
        DoubleVector atten = DoubleVector.broadcast(D, 1).blend(factor, factor.compare(VectorOperators.LT, 1));
        return cone ? atten.mul(DoubleVector.fromArray(D, power, i)) : atten;
    }

    private void spots(HitRows rows, double dropoff) {
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = DoubleVector.fromArray(D, axisCosine, i);
            DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0)).intoArray(power, i);
        }
        PowerLanes.of(power, 0, rows.count, dropoff);
    }

    /**
     * As {@link LightingEquation#specular}, for rows {@code from … to}: {@code from} is a multiple of the
     * lanes, {@code to} is overrun to whole lanes.
     */
    void speculars(HitRows rows, int from, int to, double shininess, float[] column) {
        int end = Math.min(to, HitRows.padded(rows.count));
        for (int i = from; i < end; i += LANES) {
            mirrorCosine(rows, i);
        }
        PowerLanes.of(power, from, end, shininess);
        for (int i = from; i < end; i += LANES) {
            store(DoubleVector.fromArray(D, power, i), column, i);
        }
    }

    private void mirrorCosine(HitRows rows, int i) {
        DoubleVector nx = load(rows.nx, i);
        DoubleVector ny = load(rows.ny, i);
        DoubleVector nz = load(rows.nz, i);
        DoubleVector x = DoubleVector.fromArray(D, lx, i);
        DoubleVector y = DoubleVector.fromArray(D, ly, i);
        DoubleVector z = DoubleVector.fromArray(D, lz, i);
        DoubleVector twice = nx.mul(x).add(ny.mul(y)).add(nz.mul(z)).mul(2);
        DoubleVector rx = x.sub(twice.mul(nx));
        DoubleVector ry = y.sub(twice.mul(ny));
        DoubleVector rz = z.sub(twice.mul(nz));
        DoubleVector vx = load(rows.vx, i);
        DoubleVector vy = load(rows.vy, i);
        DoubleVector vz = load(rows.vz, i);
        DoubleVector dot = vx.mul(rx).add(vy.mul(ry)).add(vz.mul(rz));
        DoubleVector lengths = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz))
                .mul(rx.mul(rx).add(ry.mul(ry)).add(rz.mul(rz)));
        DoubleVector c = dot.div(lengths.lanewise(VectorOperators.SQRT));
        DoubleVector positive = DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0));
        positive.blend(1, positive.compare(VectorOperators.GT, 1)).intoArray(power, i);
    }

    static DoubleVector load(float[] column, int i) {
        return (DoubleVector) FloatVector.fromArray(F, column, i).castShape(D, 0);
    }

    private static void store(DoubleVector v, float[] column, int i) {
        ((FloatVector) v.castShape(F, 0)).intoArray(column, i);
    }
}

package lightning.render.engine.lanes;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.shading.InteriorTint;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import lightning.scene.material.Transmission;

/**
 * Lane version of {@link Refraction#fresnelReflectance} and {@link InteriorTint#transmittance} over the rows of a transparent
 * material: the same operations in the same order, hence the same bits.
 */
final class ClearTermLanes {
    private static final VectorSpecies<Double> D = ColumnLanes.D;
    private static final VectorSpecies<Float> F = ColumnLanes.F;

    private ClearTermLanes() {}

    /** Writes the Fresnel reflectance of rows {@code from … to − 1}; other rows of the same vectors may receive any number. */
    static void writeReflectances(HitRows rows, int from, int to, Transmission clarity, float[] share) {
        double outside = 1 / clarity.ior();
        double inside = clarity.thin() ? outside : clarity.ior();
        for (int i = from & -D.length(); i < to; i += D.length()) {
            ((FloatVector) reflectance(rows, i, outside, inside, clarity.thin()).castShape(F, 0)).intoArray(share, i);
        }
    }

    private static DoubleVector reflectance(HitRows rows, int i, double outside, double inside, boolean thin) {
        assert rows.insideDistance != null;
        VectorMask<Double> isInside = ColumnLanes.load(rows.insideDistance, i).compare(VectorOperators.GE, 0);
        DoubleVector eta = DoubleVector.broadcast(D, outside).blend(inside, isInside);
        DoubleVector c = ColumnLanes.load(rows.nx, i).mul(ColumnLanes.load(rows.vx, i))
                .add(ColumnLanes.load(rows.ny, i).mul(ColumnLanes.load(rows.vy, i)))
                .add(ColumnLanes.load(rows.nz, i).mul(ColumnLanes.load(rows.vz, i))).lanewise(VectorOperators.ABS);
        return reflectance(c, eta, thin);
    }

    /** Returns the reflectance for absolute cosines and indices of refraction in front of the surface over those behind it. */
    static DoubleVector reflectance(DoubleVector cosine, DoubleVector eta, boolean thin) {
        DoubleVector c = DoubleVector.broadcast(D, 1).blend(cosine, cosine.compare(VectorOperators.LT, 1));
        DoubleVector k = DoubleVector.broadcast(D, 1).sub(eta.mul(eta).mul(DoubleVector.broadcast(D, 1).sub(c.mul(c))));
        DoubleVector root = k.lanewise(VectorOperators.SQRT);
        DoubleVector along = eta.mul(c);
        DoubleVector s = along.sub(root).div(along.add(root));
        DoubleVector etaRoot = eta.mul(root);
        DoubleVector p = c.sub(etaRoot).div(c.add(etaRoot));
        DoubleVector f = s.mul(s).add(p.mul(p)).div(2);
        f = thin ? f.mul(2).div(f.add(1)) : f;
        return DoubleVector.broadcast(D, 1).blend(f, k.compare(VectorOperators.GT, 0)).blend(0, eta.compare(VectorOperators.EQ, 1));
    }

    /** Writes the transmittance in one channel of the paths of rows {@code from … to − 1}; see {@link #writeReflectances}. */
    static void writeTransmittances(HitRows rows, int from, int to, InteriorTint interior, int channel, float[] tint) {
        double log2 = interior.log2(channel);
        if (log2 == 0) {
            Arrays.fill(tint, from, to, 1);
        } else if (log2 == Double.NEGATIVE_INFINITY) {
            for (int i = from; i < to; i++) {
                assert rows.insideDistance != null;
                tint[i] = interior.transmittance(channel, rows.insideDistance[i]);
            }
        } else {
            for (int i = from & -D.length(); i < to; i += D.length()) {
                transmittance(rows, i, log2, interior.distance()).intoArray(tint, i);
            }
        }
    }

    private static FloatVector transmittance(HitRows rows, int i, double log2, double distance) {
        assert rows.insideDistance != null;
        DoubleVector path = ColumnLanes.load(rows.insideDistance, i);
        DoubleVector power = PowerLanes.exponential(path.div(distance).mul(log2));
        return (FloatVector) DoubleVector.broadcast(D, 1).blend(power, path.compare(VectorOperators.GE, 0)).castShape(F, 0);
    }
}

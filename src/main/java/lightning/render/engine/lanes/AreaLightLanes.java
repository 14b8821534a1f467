package lightning.render.engine.lanes;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.SQRT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.math.Vec3;
import lightning.render.shading.LightSource;
import lightning.render.shading.RowBits;
import lightning.render.trace.HitRows;

/**
 * What holds for all samples of a light that is larger than a point: which rows face none of them, and which have a highlight of
 * none. From its center C and its extent alone, so once for each row in place of once for each sample.
 *
 * <p>Every place P of a sample is within E of C, where E is the extent grown by 2⁻⁴⁰ of itself and of C's coordinates: P is a sum that
 * was rounded once. With v = C − p, p being the row's point (for a directional light the zero point, P and C being directions of a length
 * that is 1 but for roundings), |v| − E ≤ |P − p| ≤ |v| + E, and w·(P − p) ≤ w·v + |w|·E for any vector w. Each sum below is of a few products, so that it
 * is computed to within 2⁻⁴⁸ of the sum of their sizes; the unit vector to a sample, and its products with others of about unit length, to
 * within 2⁻⁴⁶. Coordinates are at most 10¹² ({@link lightning.scene.SceneLimits}), so that nothing overflows; where |v| is less than 2⁻⁴⁰⁰ squares may be lost, and nothing is certain.
 */
final class AreaLightLanes {
    private static final VectorSpecies<Double> D = DoubleVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> F = VectorSpecies.of(float.class, VectorShape.forBitSize(D.vectorBitSize() / 2));
    private static final double MIN_DISTANCE = 0x1p-400;
    /** Normals and directions that were rounded to float have a square this close to 1. */
    private static final double UNIT_TOLERANCE = 0x1p-20;

    private final double x;
    private final double y;
    private final double z;
    private final double extent;
    /** What is taken off the center of a row's point: 1, or 0 for a direction. */
    private final double positionFactor;

    /** @param source one that is larger than a point */
    AreaLightLanes(LightSource source) {
        Vec3 center = source.position();
        x = center.x();
        y = center.y();
        z = center.z();
        double extent = source.samples().extent();
        this.extent = extent + 0x1p-40 * (extent + Math.abs(x) + Math.abs(y) + Math.abs(z));
        positionFactor = source.type().hasPosition() ? 1 : 0;
    }

    /**
     * Puts all rows into a set but those that certainly face no sample: N·v + |N|·E is less than −2⁻⁴⁰·|N|·(|v| + E), so that N·(P − p) is, and
     * its cosine at most −2⁻⁴⁰·|N|, which no rounding makes positive. No sample is at the row's point then, where a light stands
     * straight above.
     */
    void findPossiblyFacing(HitRows rows, int[] candidates) {
        for (int b = 0, row = 0; row < rows.count; b++, row += RowBits.WIDTH) {
            int facingAway = 0;
            for (int i = 0; i < RowBits.WIDTH; i += D.length()) {
                facingAway |= rowsFacingAway(rows, row + i) << i;
            }
            candidates[b] = ~facingAway & RowBits.validBits(b, rows.count);
        }
    }

    private int rowsFacingAway(HitRows rows, int i) {
        DoubleVector nx = load(rows.nx, i);
        DoubleVector ny = load(rows.ny, i);
        DoubleVector nz = load(rows.nz, i);
        DoubleVector vx = broadcast(D, x).sub(load(rows.px, i).mul(positionFactor));
        DoubleVector vy = broadcast(D, y).sub(load(rows.py, i).mul(positionFactor));
        DoubleVector vz = broadcast(D, z).sub(load(rows.pz, i).mul(positionFactor));
        DoubleVector v = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(SQRT);
        DoubleVector n = nx.mul(nx).add(ny.mul(ny)).add(nz.mul(nz)).lanewise(SQRT);
        DoubleVector max = nx.mul(vx).add(ny.mul(vy)).add(nz.mul(vz)).add(n.mul(extent));
        DoubleVector threshold = n.mul(v.add(extent)).mul(-0x1p-40);
        return (int) max.compare(LT, threshold).and(v.compare(GT, MIN_DISTANCE)).toLong();
    }

    /**
     * Adds rows {@code from … to − 1} to a set, but those whose highlight of any sample is certainly 0 as a float.
     *
     * <p>With W = V − 2(N·V)N the cosine of a highlight is c = W·L/(|V|·|R|), L being the unit vector to the sample and R its image. For N and V that are of length 1 to
     * within 2⁻²⁰, |W| is at most 1 + 2⁻¹⁶ and |V|·|R| at least 1 − 2⁻¹⁷. A row is certain where M = W·v + (1 + 2⁻¹⁶)·E is at most
     * (faint − 2⁻¹⁵)·(|v| − E), {@code zeroPowerCosine} is at least 2⁻¹⁴ and |v| − E more than 2⁻²⁰·|v|: then W·L, which is at most M/(|v| − E) where M is
     * above 0, is at most faint − 2⁻¹⁵ + 2⁻²⁶, roundings of M and of the difference included, and c at most that over 1 − 2⁻¹⁷, which is less than
     * faint − 2⁻¹⁶. Rounding c takes 2⁻⁴⁶ more at most.
     *
     * @param zeroPowerCosine a cosine up to which the highlight is 0, see {@link LightLanes#zeroPowerCosine(double)}
     */
    void addPossibleHighlights(HitRows rows, int from, int to, double zeroPowerCosine, int[] candidates) {
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int withoutHighlight = 0;
            for (int i = 0; zeroPowerCosine >= 0x1p-14 && i < RowBits.WIDTH; i += D.length()) {
                int row = b * RowBits.WIDTH + i;
                withoutHighlight |= (rowsWithoutHighlight(rows, row, zeroPowerCosine - 0x1p-15) & isUnit(rows.nx, rows.ny, rows.nz, row)
                        & isUnit(rows.vx, rows.vy, rows.vz, row)) << i;
            }
            candidates[b] |= ~withoutHighlight & RowBits.rangeBits(b, from, to);
        }
    }

    private int rowsWithoutHighlight(HitRows rows, int i, double cosine) {
        DoubleVector nx = load(rows.nx, i);
        DoubleVector ny = load(rows.ny, i);
        DoubleVector nz = load(rows.nz, i);
        DoubleVector vx = broadcast(D, x).sub(load(rows.px, i).mul(positionFactor));
        DoubleVector vy = broadcast(D, y).sub(load(rows.py, i).mul(positionFactor));
        DoubleVector vz = broadcast(D, z).sub(load(rows.pz, i).mul(positionFactor));
        DoubleVector v = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(SQRT);
        DoubleVector minDistance = v.sub(extent);
        VectorMask<Double> isDistant = minDistance.compare(GT, v.mul(0x1p-20).add(MIN_DISTANCE));
        DoubleVector nv = nx.mul(vx).add(ny.mul(vy)).add(nz.mul(vz));
        DoubleVector dx = load(rows.vx, i);
        DoubleVector dy = load(rows.vy, i);
        DoubleVector dz = load(rows.vz, i);
        DoubleVector nd = nx.mul(dx).add(ny.mul(dy)).add(nz.mul(dz));
        DoubleVector dv = dx.mul(vx).add(dy.mul(vy)).add(dz.mul(vz));
        DoubleVector max = dv.sub(nd.mul(nv).mul(2)).add((1 + 0x1p-16) * extent);
        return (int) max.compare(LE, minDistance.mul(cosine)).and(isDistant).toLong();
    }

    /** Which rows of a vector have unit vectors. */
    private static int isUnit(float[] x, float[] y, float[] z, int i) {
        DoubleVector vx = load(x, i);
        DoubleVector vy = load(y, i);
        DoubleVector vz = load(z, i);
        return (int) vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).sub(1).abs().compare(LT, UNIT_TOLERANCE).toLong();
    }

    private static DoubleVector load(float[] column, int i) {
        return (DoubleVector) FloatVector.fromArray(F, column, i).castShape(D, 0);
    }
}

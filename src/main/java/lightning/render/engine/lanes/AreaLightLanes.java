package lightning.render.engine.lanes;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.SQRT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.math.Vec3;
import lightning.render.shading.LightSource;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.HitRows;

/**
 * Conservative culling for area lights: finds rows that face no sample, and rows without a highlight from any sample. Uses only
 * the light's center C and its extent, so it runs once per row instead of once per sample.
 *
 * <p>Every sample position P is within E of C, where E is the extent, enlarged by 2⁻⁴⁰ of itself and of C's coordinates; P is a
 * sum that was rounded once. Let v = C − p, where p is the row's point. (For a directional light p is 0, and P and C are
 * directions of length 1 up to rounding.) Then |v| − E ≤ |P − p| ≤ |v| + E, and w·(P − p) ≤ w·v + |w|·E for any vector w.
 *
 * <p>Each sum below has few products, so its error is within 2⁻⁴⁸ of the sum of their absolute values. The error of the unit
 * vector to a sample, and of its products with other vectors of about unit length, is within 2⁻⁴⁶. Coordinates are at most 10¹²
 * ({@link lightning.scene.value.SceneLimits}), so nothing overflows. If |v| is less than 2⁻⁴⁰⁰, squares may underflow, and nothing is
 * culled.
 */
final class AreaLightLanes {
    private static final VectorSpecies<Double> D = ColumnLanes.D;
    private static final VectorSpecies<Float> F = ColumnLanes.F;
    private static final double MIN_DISTANCE = 0x1p-400;
    /** Normals and directions rounded to float have a squared length this close to 1. */
    private static final double UNIT_TOLERANCE = 0x1p-20;

    private final double x;
    private final double y;
    private final double z;
    private final double extent;
    /** Factor of the row's point, which is subtracted from the center: 1, or 0 for a direction. */
    private final double positionFactor;

    /** @param source area light */
    AreaLightLanes(LightSource source) {
        Vec3 center = source.position();
        x = center.x();
        y = center.y();
        z = center.z();
        double extent = source.extent();
        this.extent = extent + 0x1p-40 * (extent + Math.abs(x) + Math.abs(y) + Math.abs(z));
        positionFactor = source.type().hasPosition() ? 1 : 0;
    }

    /**
     * Adds all rows to a set except those that certainly face no sample. For these, N·v + |N|·E is less than −2⁻⁴⁰·|N|·(|v| +
     * E). Then N·(P − p) is too, and the cosine is at most −2⁻⁴⁰·|N|, which no rounding makes positive. No sample is then at
     * the row's point, where a light would count as directly above.
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
        DoubleVector nx = ColumnLanes.load(rows.nx, i);
        DoubleVector ny = ColumnLanes.load(rows.ny, i);
        DoubleVector nz = ColumnLanes.load(rows.nz, i);
        DoubleVector vx = broadcast(D, x).sub(ColumnLanes.load(rows.px, i).mul(positionFactor));
        DoubleVector vy = broadcast(D, y).sub(ColumnLanes.load(rows.py, i).mul(positionFactor));
        DoubleVector vz = broadcast(D, z).sub(ColumnLanes.load(rows.pz, i).mul(positionFactor));
        DoubleVector v = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(SQRT);
        DoubleVector n = nx.mul(nx).add(ny.mul(ny)).add(nz.mul(nz)).lanewise(SQRT);
        DoubleVector max = nx.mul(vx).add(ny.mul(vy)).add(nz.mul(vz)).add(n.mul(extent));
        DoubleVector threshold = n.mul(v.add(extent)).mul(-0x1p-40);
        return (int) max.compare(LT, threshold).and(v.compare(GT, MIN_DISTANCE)).toLong();
    }

    /**
     * Adds rows {@code from … to − 1} to a set, except those whose highlight from any sample is certainly 0 as a float.
     *
     * <p>With W = V − 2(N·V)N, the cosine of a highlight is c = W·L/(|V|·|R|), where L is the unit vector to the sample and R
     * its reflection. For N and V of length 1 within 2⁻²⁰, |W| is at most 1 + 2⁻¹⁶ and |V|·|R| at least 1 − 2⁻¹⁷.
     *
     * <p>Let z be {@code zeroPowerCosine}. A row is skipped if M = W·v + (1 + 2⁻¹⁶)·E is at most (z − 2⁻¹⁵)·(|v| − E), z is at
     * least 2⁻¹⁴, and |v| − E is more than 2⁻²⁰·|v|. For M above 0, W·L is at most M/(|v| − E), and so at most z − 2⁻¹⁵ + 2⁻²⁶ with
     * rounding of M and of the difference. Then c is at most that over 1 − 2⁻¹⁷, which is less than z − 2⁻¹⁶. Rounding adds at
     * most 2⁻⁴⁶ to c.
     *
     * @param zeroPowerCosine cosine up to which the highlight is 0, see {@link LightLanes#zeroPowerCosine(double)}
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
        DoubleVector nx = ColumnLanes.load(rows.nx, i);
        DoubleVector ny = ColumnLanes.load(rows.ny, i);
        DoubleVector nz = ColumnLanes.load(rows.nz, i);
        DoubleVector vx = broadcast(D, x).sub(ColumnLanes.load(rows.px, i).mul(positionFactor));
        DoubleVector vy = broadcast(D, y).sub(ColumnLanes.load(rows.py, i).mul(positionFactor));
        DoubleVector vz = broadcast(D, z).sub(ColumnLanes.load(rows.pz, i).mul(positionFactor));
        DoubleVector v = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(SQRT);
        DoubleVector minDistance = v.sub(extent);
        VectorMask<Double> isDistant = minDistance.compare(GT, v.mul(0x1p-20).add(MIN_DISTANCE));
        DoubleVector nv = nx.mul(vx).add(ny.mul(vy)).add(nz.mul(vz));
        DoubleVector dx = ColumnLanes.load(rows.vx, i);
        DoubleVector dy = ColumnLanes.load(rows.vy, i);
        DoubleVector dz = ColumnLanes.load(rows.vz, i);
        DoubleVector nd = nx.mul(dx).add(ny.mul(dy)).add(nz.mul(dz));
        DoubleVector dv = dx.mul(vx).add(dy.mul(vy)).add(dz.mul(vz));
        DoubleVector max = dv.sub(nd.mul(nv).mul(2)).add((1 + 0x1p-16) * extent);
        return (int) max.compare(LE, minDistance.mul(cosine)).and(isDistant).toLong();
    }

    /** Returns the rows of a vector that have unit vectors. */
    private static int isUnit(float[] x, float[] y, float[] z, int i) {
        DoubleVector vx = ColumnLanes.load(x, i);
        DoubleVector vy = ColumnLanes.load(y, i);
        DoubleVector vz = ColumnLanes.load(z, i);
        return (int) vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).sub(1).abs().compare(LT, UNIT_TOLERANCE).toLong();
    }
}

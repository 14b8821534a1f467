package lightning.render.engine.lanes;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.shading.AnisotropicHighlight;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.TermKernel;
import lightning.render.shading.layer.RowBits;
import lightning.render.shading.layer.SheenTerms;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.scene.value.Attenuation;
import org.jspecify.annotations.Nullable;

/**
 * Lane version of {@link LightingEquation} over all rows of a tile: the same operations in the same order. Holds scratch
 * columns: use one per thread.
 *
 * <p>No method here takes the vector at the end of a loop. Methods of the vector API are always inlined into loops, others only
 * up to a limit of compiler nodes, and a vector passed to a call that is not inlined is boxed (docs/performance.md).
 */
final class LightLanes implements TermKernel {
    private static final VectorSpecies<Double> D = ColumnLanes.D;
    private static final VectorSpecies<Float> F = ColumnLanes.F;
    static final int LANES = D.length();
    private static final VectorSpecies<Float> WIDE = FloatVector.SPECIES_PREFERRED;

    /** Unit vector from each row to the light. */
    private final double[] lx = new double[MAX_ROWS];
    private final double[] ly = new double[MAX_ROWS];
    private final double[] lz = new double[MAX_ROWS];
    /** Distance of each row from a light with a position, or from its sample; 1 for samples of a directional light. */
    private final double[] distance = new double[MAX_ROWS];
    private double highlightWidening;
    /** α² of the rows of a word, widened by the light of one sample. */
    private final double[] squaredWidth = new double[RowBits.WIDTH];
    /** α⊥² of the rows of a word with an anisotropic material, whose α∥² are in {@link #squaredWidth}; both widened. */
    private final double[] squaredAcross = new double[RowBits.WIDTH];
    /** Cosine from the cone's axis, −1…1. */
    private final double[] axisCosine = new double[MAX_ROWS];
    private final double[] power = new double[MAX_ROWS];
    private final double[] factor = new double[MAX_ROWS];
    /** Rows of each vector that face the light, one bit each. */
    private final int[] facingBits = new int[MAX_ROWS / LANES];
    private final float[] specularTerms = new float[MAX_ROWS];
    private final float[] grazingTerms = new float[MAX_ROWS];
    /** Value of {@link #zeroPowerCosine(double)} for {@link #zeroPowerShininess}. */
    private double zeroPowerCosine = -1;
    private double zeroPowerShininess;
    /** Words whose rows are stored in {@link #power}. */
    private final int[] rowWords = new int[MAX_ROWS / RowBits.WIDTH];

    @Override
    public void aim(HitRows rows, LightSource source) {
        highlightWidening = source.highlightWidening();
        double x = source.position().x();
        double y = source.position().y();
        double z = source.position().z();
        if (source.type().hasPosition()) {
            aimAtPoint(rows, x, y, z);
        } else {
            java.util.Arrays.fill(lx, 0, HitRows.paddedLength(rows.count), x);
            java.util.Arrays.fill(ly, 0, HitRows.paddedLength(rows.count), y);
            java.util.Arrays.fill(lz, 0, HitRows.paddedLength(rows.count), z);
        }
    }

    @Override
    public void aim(HitRows rows, LightSource source, int s, RowShadowRays patterns, int[] rowSet, float[] cosine, int[] facing) {
        highlightWidening = source.highlightWidening();
        AreaSamples area = source.samples(rows);
        RowBits.forEachRun(rowSet, rows.count, source.type().hasPosition()
                ? (from, to) -> aimAtPoints(rows, from, to, area, s, patterns, cosine)
                : (from, to) -> aimAtDirections(rows, from, to, area, s, patterns, cosine));
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            int bits = 0;
            for (int i = 0; i < RowBits.WIDTH; i += LANES) {
                bits |= facingBits[(b * RowBits.WIDTH + i) / LANES] << i;
            }
            facing[b] = bits & rowSet[b];
        }
    }

    /**
     * Computes unit vectors from rows {@code from … to − 1}, each to a point of its own. A plain loop: the compiler hoists its
     * bounds checks.
     */
    private void aimAtPoints(HitRows rows, int from, int to, AreaSamples area, int s, RowShadowRays patterns, float[] cosine) {
        for (int i = from; i < to; i += LANES) {
            DoubleVector vx = samplePosition(area, area.x, s, patterns, i).sub(ColumnLanes.load(rows.px, i));
            DoubleVector vy = samplePosition(area, area.y, s, patterns, i).sub(ColumnLanes.load(rows.py, i));
            DoubleVector vz = samplePosition(area, area.z, s, patterns, i).sub(ColumnLanes.load(rows.pz, i));
            DoubleVector d = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(VectorOperators.SQRT);
            VectorMask<Double> atLight = d.compare(VectorOperators.LT, LightingEquation.MIN_DISTANCE);
            DoubleVector inverse = DoubleVector.broadcast(D, 1).div(d);
            d.intoArray(distance, i);
            DoubleVector nx = ColumnLanes.load(rows.nx, i);
            DoubleVector ny = ColumnLanes.load(rows.ny, i);
            DoubleVector nz = ColumnLanes.load(rows.nz, i);
            DoubleVector x = vx.mul(inverse).blend(nx, atLight);
            DoubleVector y = vy.mul(inverse).blend(ny, atLight);
            DoubleVector z = vz.mul(inverse).blend(nz, atLight);
            x.intoArray(lx, i);
            y.intoArray(ly, i);
            z.intoArray(lz, i);
            FloatVector c = (FloatVector) nx.mul(x).add(ny.mul(y)).add(nz.mul(z)).castShape(F, 0);
            c.intoArray(cosine, i);
            facingBits[i / LANES] = (int) c.compare(VectorOperators.GT, 0).toLong();
        }
    }

    private void aimAtDirections(HitRows rows, int from, int to, AreaSamples area, int s, RowShadowRays patterns, float[] cosine) {
        for (int i = from; i < to; i += LANES) {
            DoubleVector x = samplePosition(area, area.x, s, patterns, i);
            DoubleVector y = samplePosition(area, area.y, s, patterns, i);
            DoubleVector z = samplePosition(area, area.z, s, patterns, i);
            x.intoArray(lx, i);
            y.intoArray(ly, i);
            z.intoArray(lz, i);
            one().intoArray(distance, i);
            FloatVector c = (FloatVector) ColumnLanes.load(rows.nx, i).mul(x).add(ColumnLanes.load(rows.ny, i).mul(y))
                    .add(ColumnLanes.load(rows.nz, i).mul(z)).castShape(F, 0);
            c.intoArray(cosine, i);
            facingBits[i / LANES] = (int) c.compare(VectorOperators.GT, 0).toLong();
        }
    }

    @Override
    public void aimShadowRays(HitRows rows, LightSource source, int s, int[] rowSet, RowShadowRays shadowRays) {
        AreaSamples area = source.samples(rows);
        RowBits.forEachRun(rowSet, rows.count, (from, to) -> {
            for (int i = from; i < to; i += LANES) {
                samplePosition(area, area.x, s, shadowRays, i).intoArray(shadowRays.x, i);
                samplePosition(area, area.y, s, shadowRays, i).intoArray(shadowRays.y, i);
                samplePosition(area, area.z, s, shadowRays, i).intoArray(shadowRays.z, i);
            }
        });
    }

    /**
     * Returns one coordinate of the sample positions of a vector of rows. If all positions of a sample fit into two vectors,
     * lanes select among these.
     */
    private static DoubleVector samplePosition(AreaSamples area, double[] positions, int s, RowShadowRays patterns, int i) {
        int at = area.index(s, 0);
        if (2 * LANES == area.patterns) {
            return DoubleVector.fromArray(D, patterns.patternLanes, i).selectFrom(DoubleVector.fromArray(D, positions, at),
                    DoubleVector.fromArray(D, positions, at + LANES));
        }
        return DoubleVector.fromArray(D, positions, at, patterns.pattern, i);
    }

    @Override
    public void addPossiblyFacing(HitRows rows, LightSource source, int[] candidates) {
        new AreaLightLanes(source).findPossiblyFacing(rows, candidates);
    }

    @Override
    public void addPossibleHighlights(HitRows rows, int from, int to, LightSource source, double shininess, int[] candidates) {
        new AreaLightLanes(source).addPossibleHighlights(rows, from, to, cachedZeroPowerCosine(shininess), candidates);
    }

    @Override
    public void computeDistances(HitRows rows, LightSource source) {
        double x = source.position().x();
        double y = source.position().y();
        double z = source.position().z();
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector vx = DoubleVector.broadcast(D, x).sub(ColumnLanes.load(rows.px, i));
            DoubleVector vy = DoubleVector.broadcast(D, y).sub(ColumnLanes.load(rows.py, i));
            DoubleVector vz = DoubleVector.broadcast(D, z).sub(ColumnLanes.load(rows.pz, i));
            vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(VectorOperators.SQRT).intoArray(distance, i);
        }
    }

    private void aimAtPoint(HitRows rows, double x, double y, double z) {
        for (int i = 0; i < rows.count; i += LANES) {
            aimAtPoint(rows, i, DoubleVector.broadcast(D, x), DoubleVector.broadcast(D, y), DoubleVector.broadcast(D, z));
        }
    }

    private void aimAtPoint(HitRows rows, int i, DoubleVector x, DoubleVector y, DoubleVector z) {
        DoubleVector vx = x.sub(ColumnLanes.load(rows.px, i));
        DoubleVector vy = y.sub(ColumnLanes.load(rows.py, i));
        DoubleVector vz = z.sub(ColumnLanes.load(rows.pz, i));
        DoubleVector d = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).lanewise(VectorOperators.SQRT);
        DoubleVector inverse = DoubleVector.broadcast(D, 1).div(d);
        d.intoArray(distance, i);
        vx.mul(inverse).intoArray(lx, i);
        vy.mul(inverse).intoArray(ly, i);
        vz.mul(inverse).intoArray(lz, i);
        if (d.compare(VectorOperators.LT, LightingEquation.MIN_DISTANCE).anyTrue()) {
            aimAlongNormals(rows, i);
        }
    }

    /** Handles rows at the light's position separately: they are so few that other rows do not pay for reading normals. */
    private void aimAlongNormals(HitRows rows, int from) {
        for (int i = from; i < from + LANES; i++) {
            if (distance[i] < LightingEquation.MIN_DISTANCE) {
                lx[i] = rows.nx[i];
                ly[i] = rows.ny[i];
                lz[i] = rows.nz[i];
            }
        }
    }

    @Override
    public void cosines(HitRows rows, float[] to) {
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = ColumnLanes.load(rows.nx, i).mul(DoubleVector.fromArray(D, lx, i))
                    .add(ColumnLanes.load(rows.ny, i).mul(DoubleVector.fromArray(D, ly, i)))
                    .add(ColumnLanes.load(rows.nz, i).mul(DoubleVector.fromArray(D, lz, i)));
            ((FloatVector) c.castShape(F, 0)).intoArray(to, i);
        }
    }

    @Override
    public void computeConeCosines(HitRows rows, LightSource source) {
        double ax = source.axis().x();
        double ay = source.axis().y();
        double az = source.axis().z();
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = DoubleVector.fromArray(D, lx, i).mul(ax)
                    .add(DoubleVector.fromArray(D, ly, i).mul(ay))
                    .add(DoubleVector.fromArray(D, lz, i).mul(az)).neg();
            DoubleVector low = c.blend(-1, c.compare(VectorOperators.LT, -1));
            low.blend(1, c.compare(VectorOperators.GT, 1)).intoArray(axisCosine, i);
        }
    }

    @Override
    public void selectFacing(float[] cosine, int rows, int[] facing) {
        for (int b = 0, row = 0; row < rows; b++, row += RowBits.WIDTH) {
            int bits = 0;
            for (int i = 0; i < RowBits.WIDTH; i += WIDE.length()) {
                bits |= (int) FloatVector.fromArray(WIDE, cosine, row + i).compare(VectorOperators.GT, 0).toLong() << i;
            }
            facing[b] = bits & RowBits.validBits(b, rows);
        }
    }

    @Override
    public void selectInside(int[] candidates, int rows, double cosAngle, int[] inside) {
        for (int b = 0, row = 0; row < rows; b++, row += RowBits.WIDTH) {
            int bits = 0;
            for (int i = 0; candidates[b] != 0 && i < RowBits.WIDTH; i += LANES) {
                DoubleVector c = DoubleVector.fromArray(D, axisCosine, row + i);
                bits |= (int) c.compare(VectorOperators.GE, cosAngle).toLong() << i;
            }
            inside[b] = bits & candidates[b];
        }
    }

    @Override
    public void select(float[] values, int[] rowSet, int rows, float[] to) {
        for (int b = 0, row = 0; row < rows; b++, row += RowBits.WIDTH) {
            for (int i = 0; i < RowBits.WIDTH; i += WIDE.length()) {
                FloatVector v = FloatVector.fromArray(WIDE, values, row + i);
                FloatVector.zero(WIDE).blend(v, VectorMask.fromLong(WIDE, rowSet[b] >>> i)).intoArray(to, row + i);
            }
        }
    }

    @Override
    public void falloffs(HitRows rows, LightSource source, float[] to) {
        unroundedFalloffs(rows, source, factor);
        toFloats(factor, rows.count, to);
    }

    @Override
    public void accumulate(float[] term, float @Nullable [] falloff, int[] rowSet, int rows, double[] sum) {
        RowBits.forEachRun(rowSet, rows, falloff == null
                ? (from, to) -> accumulate(term, rowSet, from, to, sum)
                : (from, to) -> accumulate(term, falloff, rowSet, from, to, sum));
    }

    private static void accumulate(float[] term, int[] rowSet, int from, int to, double[] sum) {
        for (int i = from; i < to; i += LANES) {
            DoubleVector previous = DoubleVector.fromArray(D, sum, i);
            previous.blend(previous.add(ColumnLanes.load(term, i)), maskAt(rowSet, i)).intoArray(sum, i);
        }
    }

    private static void accumulate(float[] term, float[] falloff, int[] rowSet, int from, int to, double[] sum) {
        for (int i = from; i < to; i += LANES) {
            DoubleVector previous = DoubleVector.fromArray(D, sum, i);
            previous.blend(previous.add(ColumnLanes.load(term, i).mul(ColumnLanes.load(falloff, i))), maskAt(rowSet, i)).intoArray(sum, i);
        }
    }

    private static VectorMask<Double> maskAt(int[] rowSet, int row) {
        return VectorMask.fromLong(D, rowSet[row / RowBits.WIDTH] >>> row % RowBits.WIDTH);
    }

    /** Uses separate loops: a vector that is one of two, or is returned by a method, would be boxed here. */
    @Override
    public void unroundedFalloffs(HitRows rows, LightSource source, double[] to) {
        if (!source.type().hasPosition()) {
            Arrays.fill(to, 0, rows.count, 1);
            return;
        }
        writeAttenuations(source.light().distanceTerms(), source.light().maxFalloff(), rows.count, to);
        if (source.hasCone()) {
            writeSpotFactors(rows, source.dropoff());
            multiplyBy(to, power, rows.count);
        }
    }

    private static void multiplyBy(double[] factors, double[] other, int rows) {
        for (int i = 0; i < rows; i += LANES) {
            DoubleVector.fromArray(D, factors, i).mul(DoubleVector.fromArray(D, other, i)).intoArray(factors, i);
        }
    }

    private void writeAttenuations(Attenuation a, double max, int rows, double[] to) {
        double constant = a.constant();
        double linear = a.linear();
        double quadratic = a.quadratic();
        for (int i = 0; i < rows; i += LANES) {
            DoubleVector d = DoubleVector.fromArray(D, distance, i);
            DoubleVector sum = d.mul(linear).add(constant).add(d.mul(d).mul(quadratic));
            DoubleVector part = DoubleVector.broadcast(D, 1).div(sum);
            DoubleVector.broadcast(D, max).blend(part, part.compare(VectorOperators.LT, max)).intoArray(to, i);
        }
    }

    private void writeSpotFactors(HitRows rows, double dropoff) {
        for (int i = 0; i < rows.count; i += LANES) {
            DoubleVector c = DoubleVector.fromArray(D, axisCosine, i);
            DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0)).intoArray(power, i);
        }
        PowerLanes.of(power, 0, rows.count, dropoff);
    }

    /**
     * Computes powers only for words that contain a row of the set whose power is not certainly 0; these are compacted in
     * {@link #power}.
     */
    @Override
    public void speculars(HitRows rows, int from, int to, int[] rowSet, double shininess, float[] column) {
        double zeroCosine = cachedZeroPowerCosine(shininess);
        int words = 0;
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int bits = rowSet[b] & RowBits.rangeBits(b, from, to);
            if (bits == 0) {
                continue;
            }
            if (writeMirrorCosines(rows, b * RowBits.WIDTH, words * RowBits.WIDTH, zeroCosine)) {
                rowWords[words++] = b;
            } else {
                clearRows(b, bits, column);
            }
        }
        PowerLanes.of(power, 0, words * RowBits.WIDTH, shininess);
        toFloats(power, words * RowBits.WIDTH, specularTerms);
        for (int w = 0; w < words; w++) {
            mergeRows(rowWords[w], rowSet[rowWords[w]] & RowBits.rangeBits(rowWords[w], from, to), specularTerms, w * RowBits.WIDTH,
                    column);
        }
    }

    private double cachedZeroPowerCosine(double shininess) {
        if (shininess != zeroPowerShininess) {
            zeroPowerShininess = shininess;
            zeroPowerCosine = zeroPowerCosine(shininess);
        }
        return zeroPowerCosine;
    }

    /**
     * Returns a cosine from 0 to 1 up to which its power is 0 as a float; −1 if 0 has another power.
     *
     * <p>The power of c is 2 to p = shininess·log₂c, and a float is 0 up to 2⁻¹⁵⁰. Here p is −152, except for the error of the
     * root of 2, which is less than 2⁻⁵¹ relative. With a shininess up to {@link lightning.scene.value.SceneLimits#MAX_SHININESS},
     * 10⁶, that changes p by less than 2⁻²⁹. The error of {@link PowerLanes} is a few roundings of p, a few 2⁻⁵² of 152, and of
     * the result.
     */
    static double zeroPowerCosine(double shininess) {
        return shininess == 0 ? -1 : StrictMath.pow(2, -152 / shininess);
    }

    /** Writes the cosines of a word's rows to {@link #power}; returns true if any is above {@code zeroCosine}. */
    private boolean writeMirrorCosines(HitRows rows, int row, int at, double zeroCosine) {
        boolean isAbove = false;
        for (int i = 0; i < RowBits.WIDTH; i += LANES) {
            isAbove |= writeMirrorCosine(rows, row + i, at + i, zeroCosine);
        }
        return isAbove;
    }

    /** Separate from other loops: in one method with them, vectors would be boxed. */
    private static void toFloats(double[] from, int rows, float[] to) {
        for (int i = 0; i < rows; i += LANES) {
            ((FloatVector) DoubleVector.fromArray(D, from, i).castShape(F, 0)).intoArray(to, i);
        }
    }

    private static void clearRows(int b, int bits, float[] column) {
        for (int i = 0; i < RowBits.WIDTH; i += WIDE.length()) {
            int row = b * RowBits.WIDTH + i;
            FloatVector.fromArray(WIDE, column, row).blend(0, VectorMask.fromLong(WIDE, bits >>> i)).intoArray(column, row);
        }
    }

    private static void mergeRows(int b, int bits, float[] values, int from, float[] column) {
        for (int i = 0; i < RowBits.WIDTH; i += WIDE.length()) {
            int row = b * RowBits.WIDTH + i;
            FloatVector previous = FloatVector.fromArray(WIDE, column, row);
            previous.blend(FloatVector.fromArray(WIDE, values, from + i), VectorMask.fromLong(WIDE, bits >>> i)).intoArray(column, row);
        }
    }

    /** Writes the cosines of a vector's rows to {@link #power}; returns true if any is above {@code zeroCosine}. */
    private boolean writeMirrorCosine(HitRows rows, int i, int at, double zeroCosine) {
        DoubleVector nx = ColumnLanes.load(rows.nx, i);
        DoubleVector ny = ColumnLanes.load(rows.ny, i);
        DoubleVector nz = ColumnLanes.load(rows.nz, i);
        DoubleVector x = DoubleVector.fromArray(D, lx, i);
        DoubleVector y = DoubleVector.fromArray(D, ly, i);
        DoubleVector z = DoubleVector.fromArray(D, lz, i);
        DoubleVector twice = nx.mul(x).add(ny.mul(y)).add(nz.mul(z)).mul(2);
        DoubleVector rx = x.sub(twice.mul(nx));
        DoubleVector ry = y.sub(twice.mul(ny));
        DoubleVector rz = z.sub(twice.mul(nz));
        DoubleVector vx = ColumnLanes.load(rows.vx, i);
        DoubleVector vy = ColumnLanes.load(rows.vy, i);
        DoubleVector vz = ColumnLanes.load(rows.vz, i);
        DoubleVector dot = vx.mul(rx).add(vy.mul(ry)).add(vz.mul(rz));
        DoubleVector lengths = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz))
                .mul(rx.mul(rx).add(ry.mul(ry)).add(rz.mul(rz)));
        DoubleVector c = dot.div(lengths.lanewise(VectorOperators.SQRT));
        DoubleVector positive = DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0));
        positive.blend(1, positive.compare(VectorOperators.GT, 1)).intoArray(power, at);
        return positive.compare(VectorOperators.GT, zeroCosine).anyTrue();
    }

    @Override
    public void metallicDiffuses(HitRows rows, int from, int to, int[] rowSet, float[] column) {
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int bits = rowSet[b] & RowBits.rangeBits(b, from, to);
            if (bits != 0) {
                int row = b * RowBits.WIDTH;
                for (int i = row; i < row + RowBits.WIDTH; i += LANES) {
                    writeMetallicDiffuse(rows, i);
                }
                mergeRows(b, bits, specularTerms, row, column);
            }
        }
    }

    private void writeMetallicDiffuse(HitRows rows, int i) {
        DoubleVector nl = lightCosine(rows, i);
        DoubleVector below = nl.mul(one().sub(pow5(one().sub(nl))));
        DoubleVector term = below.mul(one().sub(pow5(one().sub(viewCosine(rows, i)))));
        ((FloatVector) term.castShape(F, 0)).intoArray(specularTerms, i);
    }

    @Override
    public void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double alpha, float[] gloss, float[] grazing) {
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int bits = rowSet[b] & RowBits.rangeBits(b, from, to);
            if (bits != 0) {
                java.util.Arrays.fill(squaredWidth, alpha * alpha);
                writeMetallicSpeculars(rows, b, bits, gloss, grazing);
            }
        }
    }

    @Override
    public void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double[] alpha, float[] gloss, float[] grazing) {
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int bits = rowSet[b] & RowBits.rangeBits(b, from, to);
            if (bits != 0) {
                for (int i = 0; i < RowBits.WIDTH; i += LANES) {
                    DoubleVector width = DoubleVector.fromArray(D, alpha, b * RowBits.WIDTH + i);
                    width.mul(width).intoArray(squaredWidth, i);
                }
                writeMetallicSpeculars(rows, b, bits, gloss, grazing);
            }
        }
    }

    @Override
    public void sheens(HitRows rows, int from, int to, int[] rowSet, double[] roughness, float[] column) {
        SheenTerms.write(rows, from, to, rowSet, roughness, lx, ly, lz, column);
    }

    /** Writes the terms of some rows of a word, whose {@link #squaredWidth} are set before they are widened. */
    private void writeMetallicSpeculars(HitRows rows, int b, int bits, float[] gloss, float[] grazing) {
        int row = b * RowBits.WIDTH;
        if (highlightWidening != 0) {
            widenSquares(row, squaredWidth);
        }
        writeFacetTerms(rows, row);
        mergeRows(b, bits, specularTerms, row, gloss);
        mergeRows(b, bits, grazingTerms, row, grazing);
    }

    @Override
    public void anisotropicSpeculars(HitRows rows, int from, int to, int[] rowSet, AnisotropicHighlight highlight, double[] alpha,
            float[] gloss, float[] grazing) {
        for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
            int bits = rowSet[b] & RowBits.rangeBits(b, from, to);
            if (bits != 0) {
                int row = b * RowBits.WIDTH;
                for (int i = 0; i < RowBits.WIDTH; i++) {
                    squaredWidth[i] = highlight.squareAlong(alpha[row + i]);
                    squaredAcross[i] = highlight.squareAcross(alpha[row + i]);
                }
                if (highlightWidening != 0) {
                    widenSquares(row, squaredWidth);
                    widenSquares(row, squaredAcross);
                }
                for (int i = row; i < row + RowBits.WIDTH; i += LANES) {
                    writeAnisotropicTerm(rows, i, i - row, highlight.cos(), highlight.sin());
                    splitBySchlick(rows, i);
                }
                mergeRows(b, bits, specularTerms, row, gloss);
                mergeRows(b, bits, grazingTerms, row, grazing);
            }
        }
    }

    /** Writes N·L·D·V to {@link #power}: {@link AnisotropicHighlight#term}. */
    private void writeAnisotropicTerm(HitRows rows, int i, int inWord, double cos, double sin) {
        DoubleVector nx = ColumnLanes.load(rows.nx, i);
        DoubleVector ny = ColumnLanes.load(rows.ny, i);
        DoubleVector nz = ColumnLanes.load(rows.nz, i);
        DoubleVector tx = ColumnLanes.load(requireNonNull(rows.tangentX), i);
        DoubleVector ty = ColumnLanes.load(requireNonNull(rows.tangentY), i);
        DoubleVector tz = ColumnLanes.load(requireNonNull(rows.tangentZ), i);
        DoubleVector bx = ny.mul(tz).sub(nz.mul(ty));
        DoubleVector by = nz.mul(tx).sub(nx.mul(tz));
        DoubleVector bz = nx.mul(ty).sub(ny.mul(tx));
        DoubleVector xx = tx.mul(cos).add(bx.mul(sin));
        DoubleVector xy = ty.mul(cos).add(by.mul(sin));
        DoubleVector xz = tz.mul(cos).add(bz.mul(sin));
        DoubleVector yx = bx.mul(cos).sub(tx.mul(sin));
        DoubleVector yy = by.mul(cos).sub(ty.mul(sin));
        DoubleVector yz = bz.mul(cos).sub(tz.mul(sin));
        DoubleVector x = DoubleVector.fromArray(D, lx, i);
        DoubleVector y = DoubleVector.fromArray(D, ly, i);
        DoubleVector z = DoubleVector.fromArray(D, lz, i);
        DoubleVector nl = nx.mul(x).add(ny.mul(y)).add(nz.mul(z));
        DoubleVector xl = xx.mul(x).add(xy.mul(y)).add(xz.mul(z));
        DoubleVector yl = yx.mul(x).add(yy.mul(y)).add(yz.mul(z));
        DoubleVector vx = ColumnLanes.load(rows.vx, i);
        DoubleVector vy = ColumnLanes.load(rows.vy, i);
        DoubleVector vz = ColumnLanes.load(rows.vz, i);
        DoubleVector nv = nx.mul(vx).add(ny.mul(vy)).add(nz.mul(vz)).neg();
        DoubleVector xv = xx.mul(vx).add(xy.mul(vy)).add(xz.mul(vz)).neg();
        DoubleVector yv = yx.mul(vx).add(yy.mul(vy)).add(yz.mul(vz)).neg();
        DoubleVector nh = nl.add(nv);
        DoubleVector xh = xl.add(xv);
        DoubleVector yh = yl.add(yv);
        DoubleVector a = DoubleVector.fromArray(D, squaredWidth, inWord);
        DoubleVector b = DoubleVector.fromArray(D, squaredAcross, inWord);
        DoubleVector xs = xh.mul(xh);
        DoubleVector ys = yh.mul(yh);
        DoubleVector ns = nh.mul(nh);
        DoubleVector c = clampToUnit(xs.add(ys).add(ns).div(xs.div(a).add(ys.div(b)).add(ns)));
        DoubleVector facing = DoubleVector.zero(D).blend(nv, nv.compare(VectorOperators.GT, 0));
        DoubleVector gl = nl.add(a.mul(xl.mul(xl)).add(b.mul(yl.mul(yl))).add(nl.mul(nl)).lanewise(VectorOperators.SQRT));
        DoubleVector gv = facing.add(a.mul(xv.mul(xv)).add(b.mul(yv.mul(yv))).add(facing.mul(facing)).lanewise(VectorOperators.SQRT));
        nl.mul(c.mul(c)).div(a.mul(b).lanewise(VectorOperators.SQRT).mul(gl.mul(gv))).intoArray(power, i);
    }

    /** Widens the squares of the widths of a word's rows. */
    private void widenSquares(int row, double[] squares) {
        for (int i = 0; i < RowBits.WIDTH; i += LANES) {
            DoubleVector d = DoubleVector.fromArray(D, distance, row + i);
            DoubleVector widened =
                    DoubleVector.broadcast(D, highlightWidening).div(d.mul(d)).add(DoubleVector.fromArray(D, squares, i));
            one().blend(widened, widened.compare(VectorOperators.LT, 1)).intoArray(squares, i);
        }
    }

    /** Writes both terms of a word's rows to {@link #specularTerms} and {@link #grazingTerms}. */
    private void writeFacetTerms(HitRows rows, int row) {
        for (int i = row; i < row + RowBits.WIDTH; i += LANES) {
            writeMicrofacetTerm(rows, i, i - row);
            splitBySchlick(rows, i);
        }
    }

    /** Writes N·L·D·V to {@link #power}. */
    private void writeMicrofacetTerm(HitRows rows, int i, int inWord) {
        DoubleVector nx = ColumnLanes.load(rows.nx, i);
        DoubleVector ny = ColumnLanes.load(rows.ny, i);
        DoubleVector nz = ColumnLanes.load(rows.nz, i);
        DoubleVector hx = DoubleVector.fromArray(D, lx, i).sub(ColumnLanes.load(rows.vx, i));
        DoubleVector hy = DoubleVector.fromArray(D, ly, i).sub(ColumnLanes.load(rows.vy, i));
        DoubleVector hz = DoubleVector.fromArray(D, lz, i).sub(ColumnLanes.load(rows.vz, i));
        DoubleVector nh = nx.mul(hx).add(ny.mul(hy)).add(nz.mul(hz));
        DoubleVector lengths = nx.mul(nx).add(ny.mul(ny)).add(nz.mul(nz)).mul(hx.mul(hx).add(hy.mul(hy)).add(hz.mul(hz)));
        DoubleVector c = clampToUnit(nh.mul(nh).div(lengths));
        DoubleVector nl = lightCosine(rows, i);
        DoubleVector a = DoubleVector.fromArray(D, squaredWidth, inWord);
        DoubleVector t = c.mul(a.sub(1)).add(1);
        DoubleVector visibility = smithTerm(nl, a).mul(smithTerm(viewCosine(rows, i), a));
        nl.mul(a).div(t.mul(t).mul(visibility)).intoArray(power, i);
    }

    private static DoubleVector smithTerm(DoubleVector cosine, DoubleVector a) {
        return cosine.add(cosine.mul(cosine).mul(one().sub(a)).add(a).lanewise(VectorOperators.SQRT));
    }

    /** Splits the values in {@link #power} by (1 − V·H)⁵. */
    private void splitBySchlick(HitRows rows, int i) {
        DoubleVector vx = ColumnLanes.load(rows.vx, i);
        DoubleVector vy = ColumnLanes.load(rows.vy, i);
        DoubleVector vz = ColumnLanes.load(rows.vz, i);
        DoubleVector hx = DoubleVector.fromArray(D, lx, i).sub(vx);
        DoubleVector hy = DoubleVector.fromArray(D, ly, i).sub(vy);
        DoubleVector hz = DoubleVector.fromArray(D, lz, i).sub(vz);
        DoubleVector vh = vx.mul(hx).add(vy.mul(hy)).add(vz.mul(hz)).neg();
        DoubleVector lengths = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz)).mul(hx.mul(hx).add(hy.mul(hy)).add(hz.mul(hz)));
        DoubleVector s = pow5(one().sub(clampToUnit(vh.div(lengths.lanewise(VectorOperators.SQRT)))));
        DoubleVector facets = DoubleVector.fromArray(D, power, i);
        ((FloatVector) facets.mul(one().sub(s)).castShape(F, 0)).intoArray(specularTerms, i);
        ((FloatVector) facets.mul(s).castShape(F, 0)).intoArray(grazingTerms, i);
    }

    /** Returns the value clamped to 0…1; 0 for NaN. */
    private static DoubleVector clampToUnit(DoubleVector c) {
        DoubleVector positive = DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0));
        return positive.blend(1, positive.compare(VectorOperators.GT, 1));
    }

    private DoubleVector lightCosine(HitRows rows, int i) {
        return ColumnLanes.load(rows.nx, i).mul(DoubleVector.fromArray(D, lx, i))
                .add(ColumnLanes.load(rows.ny, i).mul(DoubleVector.fromArray(D, ly, i)))
                .add(ColumnLanes.load(rows.nz, i).mul(DoubleVector.fromArray(D, lz, i)));
    }

    private static DoubleVector viewCosine(HitRows rows, int i) {
        DoubleVector c = ColumnLanes.load(rows.nx, i).mul(ColumnLanes.load(rows.vx, i))
                .add(ColumnLanes.load(rows.ny, i).mul(ColumnLanes.load(rows.vy, i)))
                .add(ColumnLanes.load(rows.nz, i).mul(ColumnLanes.load(rows.vz, i))).neg();
        return DoubleVector.zero(D).blend(c, c.compare(VectorOperators.GT, 0));
    }

    private static DoubleVector pow5(DoubleVector x) {
        DoubleVector square = x.mul(x);
        return square.mul(square).mul(x);
    }

    private static DoubleVector one() {
        return DoubleVector.broadcast(D, 1);
    }
}

package lightning.render.engine.scalar;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.math.PowerFunction;
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

/** Scalar implementation of {@link TermKernel}, row by row. */
final class ScalarTerms implements TermKernel {
    /** Unit vector from each row to the light. */
    private final double[] lx = new double[MAX_ROWS];
    private final double[] ly = new double[MAX_ROWS];
    private final double[] lz = new double[MAX_ROWS];
    /** Distance of each row from a light with a position, or from its sample; 1 for samples of a directional light. */
    private final double[] distance = new double[MAX_ROWS];
    private double highlightWidening;
    /** Cosine from the cone's axis, −1…1. */
    private final double[] axisCosine = new double[MAX_ROWS];

    @Override
    public void aim(HitRows rows, LightSource source) {
        highlightWidening = source.highlightWidening();
        double x = source.position().x();
        double y = source.position().y();
        double z = source.position().z();
        if (!source.type().hasPosition()) {
            Arrays.fill(lx, 0, rows.count, x);
            Arrays.fill(ly, 0, rows.count, y);
            Arrays.fill(lz, 0, rows.count, z);
            return;
        }
        for (int i = 0; i < rows.count; i++) {
            aimAtPoint(rows, i, x, y, z);
        }
    }

    @Override
    public void aim(HitRows rows, LightSource source, int s, RowShadowRays patterns, int[] rowSet, float[] cosine, int[] facing) {
        highlightWidening = source.highlightWidening();
        AreaSamples area = source.samples(rows);
        for (int i = 0; i < rows.count; i++) {
            int k = area.index(s, patterns.pattern[i]);
            if (source.type().hasPosition()) {
                aimAtPoint(rows, i, area.x[k], area.y[k], area.z[k]);
            } else {
                lx[i] = area.x[k];
                ly[i] = area.y[k];
                lz[i] = area.z[k];
                distance[i] = 1;
            }
        }
        cosines(rows, cosine);
        selectFacing(cosine, rows.count, facing);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            facing[b] &= rowSet[b];
        }
    }

    @Override
    public void aimShadowRays(HitRows rows, LightSource source, int s, int[] rowSet, RowShadowRays shadowRays) {
        AreaSamples area = source.samples(rows);
        for (int i = 0; i < rows.count; i++) {
            int k = area.index(s, shadowRays.pattern[i]);
            shadowRays.x[i] = area.x[k];
            shadowRays.y[i] = area.y[k];
            shadowRays.z[i] = area.z[k];
        }
    }

    @Override
    public void addPossiblyFacing(HitRows rows, LightSource source, int[] candidates) {
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            candidates[b] = RowBits.validBits(b, rows.count);
        }
    }

    @Override
    public void addPossibleHighlights(HitRows rows, int from, int to, LightSource source, double shininess, int[] candidates) {
        RowBits.add(candidates, from, to);
    }

    private void aimAtPoint(HitRows rows, int i, double x, double y, double z) {
        double vx = x - rows.px[i];
        double vy = y - rows.py[i];
        double vz = z - rows.pz[i];
        double d = Math.sqrt(vx * vx + vy * vy + vz * vz);
        boolean atLight = d < LightingEquation.MIN_DISTANCE;
        double inverse = 1 / d;
        distance[i] = d;
        lx[i] = atLight ? rows.nx[i] : vx * inverse;
        ly[i] = atLight ? rows.ny[i] : vy * inverse;
        lz[i] = atLight ? rows.nz[i] : vz * inverse;
    }

    @Override
    public void computeDistances(HitRows rows, LightSource source) {
        for (int i = 0; i < rows.count; i++) {
            double vx = source.position().x() - rows.px[i];
            double vy = source.position().y() - rows.py[i];
            double vz = source.position().z() - rows.pz[i];
            distance[i] = Math.sqrt(vx * vx + vy * vy + vz * vz);
        }
    }

    @Override
    public void computeConeCosines(HitRows rows, LightSource source) {
        for (int i = 0; i < rows.count; i++) {
            double c = -(lx[i] * source.axis().x() + ly[i] * source.axis().y() + lz[i] * source.axis().z());
            axisCosine[i] = c < -1 ? -1 : c > 1 ? 1 : c;
        }
    }

    @Override
    public void cosines(HitRows rows, float[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) (rows.nx[i] * lx[i] + rows.ny[i] * ly[i] + rows.nz[i] * lz[i]);
        }
    }

    @Override
    public void selectFacing(float[] cosine, int rows, int[] facing) {
        Arrays.fill(facing, 0, RowBits.words(rows), 0);
        for (int i = 0; i < rows; i++) {
            if (cosine[i] > 0) {
                RowBits.add(facing, i);
            }
        }
    }

    @Override
    public void selectInside(int[] candidates, int rows, double cosAngle, int[] inside) {
        Arrays.fill(inside, 0, RowBits.words(rows), 0);
        for (int i = 0; i < rows; i++) {
            if (RowBits.contains(candidates, i) && axisCosine[i] >= cosAngle) {
                RowBits.add(inside, i);
            }
        }
    }

    @Override
    public void select(float[] values, int[] rowSet, int rows, float[] to) {
        for (int i = 0; i < rows; i++) {
            to[i] = RowBits.contains(rowSet, i) ? values[i] : 0;
        }
    }

    @Override
    public void speculars(HitRows rows, int from, int to, int[] rowSet, double shininess, float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                column[i] = (float) PowerFunction.pow(mirrorCosine(rows, i), shininess);
            }
        }
    }

    /** Returns max(V·R, 0) with R = 2N(N·−L) + L, both normalized. */
    private double mirrorCosine(HitRows rows, int i) {
        double nx = rows.nx[i];
        double ny = rows.ny[i];
        double nz = rows.nz[i];
        double vx = rows.vx[i];
        double vy = rows.vy[i];
        double vz = rows.vz[i];
        double twice = 2 * (nx * lx[i] + ny * ly[i] + nz * lz[i]);
        double rx = lx[i] - twice * nx;
        double ry = ly[i] - twice * ny;
        double rz = lz[i] - twice * nz;
        double dot = vx * rx + vy * ry + vz * rz;
        if (!(dot > 0)) {
            return 0;
        }
        double c = dot / Math.sqrt((vx * vx + vy * vy + vz * vz) * (rx * rx + ry * ry + rz * rz));
        return c > 0 ? c > 1 ? 1 : c : 0;
    }

    @Override
    public void metallicDiffuses(HitRows rows, int from, int to, int[] rowSet, float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                double nl = lightCosine(rows, i);
                column[i] = (float) (nl * (1 - pow5(1 - nl)) * (1 - pow5(1 - viewCosine(rows, i))));
            }
        }
    }

    @Override
    public void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double alpha, float[] gloss, float[] grazing) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                writeMetallicSpecular(rows, i, alpha, gloss, grazing);
            }
        }
    }

    @Override
    public void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double[] alpha, float[] gloss, float[] grazing) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                writeMetallicSpecular(rows, i, alpha[i], gloss, grazing);
            }
        }
    }

    @Override
    public void anisotropicSpeculars(HitRows rows, int from, int to, int[] rowSet, AnisotropicHighlight highlight, double[] alpha,
            float[] gloss, float[] grazing) {
        float[] tx = requireNonNull(rows.tangentX);
        float[] ty = requireNonNull(rows.tangentY);
        float[] tz = requireNonNull(rows.tangentZ);
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                writeSplit(rows, i,
                        highlight.term(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], tx[i], ty[i], tz[i], lx[i],
                                ly[i], lz[i], widened(i, highlight.squareAlong(alpha[i])), widened(i, highlight.squareAcross(alpha[i]))),
                        gloss, grazing);
            }
        }
    }

    private void writeMetallicSpecular(HitRows rows, int i, double alpha, float[] gloss, float[] grazing) {
        writeSplit(rows, i, microfacetTerm(rows, i, alpha), gloss, grazing);
    }

    /** Splits N·L·D·V by (1 − V·H)⁵. */
    private void writeSplit(HitRows rows, int i, double facets, float[] gloss, float[] grazing) {
        double schlick = schlick(rows, i);
        gloss[i] = (float) (facets * (1 - schlick));
        grazing[i] = (float) (facets * schlick);
    }

    @Override
    public void sheens(HitRows rows, int from, int to, int[] rowSet, double[] roughness, float[] column) {
        SheenTerms.write(rows, from, to, rowSet, roughness, lx, ly, lz, column);
    }

    /** Returns N·L. */
    private double lightCosine(HitRows rows, int i) {
        return rows.nx[i] * lx[i] + rows.ny[i] * ly[i] + rows.nz[i] * lz[i];
    }

    /** Returns max(N·V, 0). */
    private static double viewCosine(HitRows rows, int i) {
        double c = -((double) rows.nx[i] * rows.vx[i] + (double) rows.ny[i] * rows.vy[i] + (double) rows.nz[i] * rows.vz[i]);
        return c > 0 ? c : 0;
    }

    private static double pow5(double x) {
        double square = x * x;
        return square * square * x;
    }

    /** Returns α², widened by the light of one sample. */
    private double widenedSquare(int i, double alpha) {
        return widened(i, alpha * alpha);
    }

    private double widened(int i, double square) {
        if (highlightWidening == 0) {
            return square;
        }
        double widened = square + highlightWidening / (distance[i] * distance[i]);
        return widened < 1 ? widened : 1;
    }

    /** Returns N·L·D·V. */
    private double microfacetTerm(HitRows rows, int i, double alpha) {
        double nx = rows.nx[i];
        double ny = rows.ny[i];
        double nz = rows.nz[i];
        double hx = lx[i] - rows.vx[i];
        double hy = ly[i] - rows.vy[i];
        double hz = lz[i] - rows.vz[i];
        double nh = nx * hx + ny * hy + nz * hz;
        double c = nh * nh / ((nx * nx + ny * ny + nz * nz) * (hx * hx + hy * hy + hz * hz));
        c = c > 0 ? c > 1 ? 1 : c : 0;
        double nl = lightCosine(rows, i);
        double nv = viewCosine(rows, i);
        double a = widenedSquare(i, alpha);
        double t = c * (a - 1) + 1;
        double gl = nl + Math.sqrt(a + (1 - a) * (nl * nl));
        double gv = nv + Math.sqrt(a + (1 - a) * (nv * nv));
        return nl * a / (t * t * (gl * gv));
    }

    /** Returns (1 − V·H)⁵. */
    private double schlick(HitRows rows, int i) {
        double vx = rows.vx[i];
        double vy = rows.vy[i];
        double vz = rows.vz[i];
        double hx = lx[i] - vx;
        double hy = ly[i] - vy;
        double hz = lz[i] - vz;
        double vh = -(vx * hx + vy * hy + vz * hz);
        double c = vh / Math.sqrt((vx * vx + vy * vy + vz * vz) * (hx * hx + hy * hy + hz * hz));
        return pow5(1 - (c > 0 ? c > 1 ? 1 : c : 0));
    }

    @Override
    public void falloffs(HitRows rows, LightSource source, float[] to) {
        Attenuation a = source.light().distanceTerms();
        double max = source.light().maxFalloff();
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) factor(source, a, max, i);
        }
    }

    @Override
    public void accumulate(float[] term, float @Nullable [] falloff, int[] rowSet, int rows, double[] sum) {
        for (int i = 0; i < rows; i++) {
            if (RowBits.contains(rowSet, i)) {
                sum[i] += falloff == null ? term[i] : (double) term[i] * falloff[i];
            }
        }
    }

    @Override
    public void unroundedFalloffs(HitRows rows, LightSource source, double[] to) {
        if (!source.type().hasPosition()) {
            Arrays.fill(to, 0, rows.count, 1);
            return;
        }
        Attenuation a = source.light().distanceTerms();
        double max = source.light().maxFalloff();
        for (int i = 0; i < rows.count; i++) {
            to[i] = factor(source, a, max, i);
        }
    }

    /** @param max the light's largest falloff */
    private double factor(LightSource source, Attenuation a, double max, int i) {
        double d = distance[i];
        double factor = 1 / (a.constant() + a.linear() * d + a.quadratic() * (d * d));
        factor = factor < max ? factor : max;
        return source.hasCone() ? factor * PowerFunction.pow(axisCosine[i] > 0 ? axisCosine[i] : 0, source.dropoff()) : factor;
    }
}

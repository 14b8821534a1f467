package lightning.render.engine.scalar;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.AnisotropicHighlight;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.TermKernel;
import lightning.render.shading.layer.RowBits;
import lightning.render.shading.layer.SheenTerms;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import org.jspecify.annotations.Nullable;

/** Scalar implementation of {@link TermKernel}, row by row. */
final class ScalarTerms implements TermKernel {
    /** Unit vector from each row to the light. */
    private final double[] lx = new double[MAX_ROWS];
    private final double[] ly = new double[MAX_ROWS];
    private final double[] lz = new double[MAX_ROWS];
    /** Distance of each row from a light with a position, or from its sample; 1 for others. */
    private final double[] distance = new double[MAX_ROWS];
    /** Cosine from the cone's axis, −1…1. */
    private final double[] axisCosine = new double[MAX_ROWS];
    private @Nullable LightingEquation equation;

    @Override
    public void aim(HitRows rows, LightSource source) {
        LightingEquation light = start(source);
        for (int i = 0; i < rows.count; i++) {
            light.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
            store(light, i);
        }
    }

    @Override
    public void aim(HitRows rows, LightSource source, int s, RowShadowRays patterns, int[] rowSet, float[] cosine, int[] facing) {
        LightingEquation light = start(source);
        AreaSamples area = source.samples(rows);
        for (int i = 0; i < rows.count; i++) {
            int k = area.index(s, patterns.pattern[i]);
            light.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i], area.x[k], area.y[k], area.z[k]);
            store(light, i);
        }
        cosines(rows, cosine);
        selectFacing(cosine, rows.count, facing);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            facing[b] &= rowSet[b];
        }
    }

    private LightingEquation start(LightSource source) {
        LightingEquation light = new LightingEquation(source);
        equation = light;
        return light;
    }

    private void store(LightingEquation light, int i) {
        lx[i] = light.x();
        ly[i] = light.y();
        lz[i] = light.z();
        distance[i] = light.distance();
    }

    /** Returns the equation of the light that was aimed at, at a row. */
    private LightingEquation at(int i) {
        LightingEquation light = requireNonNull(equation);
        light.aim(lx[i], ly[i], lz[i], distance[i]);
        return light;
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

    @Override
    public void computeDistances(HitRows rows, LightSource source) {
        aim(rows, source);
    }

    @Override
    public void computeConeCosines(HitRows rows, LightSource source) {
        for (int i = 0; i < rows.count; i++) {
            axisCosine[i] = at(i).axisCosine(source);
        }
    }

    @Override
    public void cosines(HitRows rows, float[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) at(i).lightCosine(rows.nx[i], rows.ny[i], rows.nz[i]);
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
                column[i] = at(i).specular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], shininess);
            }
        }
    }

    @Override
    public void metallicDiffuses(HitRows rows, int from, int to, int[] rowSet, float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                column[i] = at(i).metallicDiffuse(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i]);
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

    private void writeMetallicSpecular(HitRows rows, int i, double alpha, float[] gloss, float[] grazing) {
        writeSplit(rows, i, at(i).facets(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], alpha), gloss, grazing);
    }

    /** Splits N·L·D·V by (1 − V·H)⁵. */
    private void writeSplit(HitRows rows, int i, double facets, float[] gloss, float[] grazing) {
        double schlick = at(i).schlick(rows.vx[i], rows.vy[i], rows.vz[i]);
        gloss[i] = (float) (facets * (1 - schlick));
        grazing[i] = (float) (facets * schlick);
    }

    @Override
    public void anisotropicSpeculars(HitRows rows, int from, int to, int[] rowSet, AnisotropicHighlight highlight, double[] alpha,
            float[] gloss, float[] grazing) {
        float[] tx = requireNonNull(rows.tangentX);
        float[] ty = requireNonNull(rows.tangentY);
        float[] tz = requireNonNull(rows.tangentZ);
        float[] tangent = new float[3];
        for (int i = from; i < to; i++) {
            if (RowBits.contains(rowSet, i)) {
                tangent[0] = tx[i];
                tangent[1] = ty[i];
                tangent[2] = tz[i];
                writeSplit(rows, i, at(i).anisotropicFacets(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i],
                        tangent, highlight, alpha[i]), gloss, grazing);
            }
        }
    }

    @Override
    public void sheens(HitRows rows, int from, int to, int[] rowSet, double[] roughness, float[] column) {
        SheenTerms.write(rows, from, to, rowSet, roughness, lx, ly, lz, column);
    }

    @Override
    public void falloffs(HitRows rows, LightSource source, float[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) falloff(source, i);
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
        for (int i = 0; i < rows.count; i++) {
            to[i] = falloff(source, i);
        }
    }

    private double falloff(LightSource source, int i) {
        return !source.type().hasPosition() ? 1 : LightingEquation.falloff(source, distance[i], axisCosine[i]);
    }
}

package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;

/** Sums of an area light's terms over its visible samples. Holds scratch memory: use one instance per thread. */
final class AreaTermSums {
    private final TermKernel terms;
    private final TermColumnWriter columnWriter;
    private final int[] metallicRows = RowBits.allocate();
    /** Rows that may have a specular term for any sample. */
    private final int[] mayHaveHighlight = RowBits.allocate();
    private final int[] highlightRows = RowBits.allocate();
    private final float[] falloff = new float[TermKernel.MAX_ROWS];
    private final float[] specular = new float[TermKernel.MAX_ROWS];
    private final float[] grazing = new float[TermKernel.MAX_ROWS];
    private final double[] factors = new double[TermKernel.MAX_ROWS];
    private final double[] diffuseSum = new double[TermKernel.MAX_ROWS];
    private final double[] specularSum = new double[TermKernel.MAX_ROWS];
    private final double[] grazingSum = new double[TermKernel.MAX_ROWS];
    /** True if any row's material has specular terms or is metallic; computed once per tile and light. */
    private boolean hasSpecular;
    private boolean hasMetallic;

    AreaTermSums(TermKernel terms, TermColumnWriter writer) {
        this.terms = terms;
        columnWriter = writer;
    }

    /** Starts with sums of 0. */
    void begin(HitRows rows, LightSource source) {
        hasSpecular = columnWriter.hasSpecular(rows);
        hasMetallic = columnWriter.hasMetallic(rows);
        Arrays.fill(diffuseSum, 0);
        Arrays.fill(specularSum, 0);
        if (hasMetallic) {
            Arrays.fill(grazingSum, 0);
        }
        Arrays.fill(mayHaveHighlight, 0);
        if (hasSpecular) {
            columnWriter.addPossibleHighlights(rows, source, mayHaveHighlight);
        }
    }

    /**
     * Adds the terms of sample {@code s}, which the terms were aimed at, for a set of rows.
     *
     * @param cosine cosines of the rows; overwritten
     * @param rays   pattern of each row
     */
    void add(HitRows rows, LightSource source, int s, int[] rowSet, float[] cosine, RowShadowRays rays) {
        float[] falloffOrNull = source.hasFalloff() ? falloff : null;
        if (source.hasFalloff()) {
            writeFalloffs(rows, source, s, rays);
        }
        columnWriter.writeMetallicDiffuse(rows, rowSet, cosine);
        terms.accumulate(cosine, falloffOrNull, rowSet, rows.count, diffuseSum);
        if (hasSpecular) {
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                highlightRows[b] = rowSet[b] & mayHaveHighlight[b];
            }
            columnWriter.writeSpeculars(rows, highlightRows, specular, grazing);
            terms.accumulate(specular, falloffOrNull, highlightRows, rows.count, specularSum);
        }
        if (hasMetallic) {
            addGrazing(rows, falloffOrNull, rowSet);
        }
    }

    private void addGrazing(HitRows rows, float[] falloffOrNull, int[] rowSet) {
        System.arraycopy(rowSet, 0, metallicRows, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runCount; r++) {
            if (!columnWriter.isMetallic(rows.runMaterial[r])) {
                RowBits.remove(metallicRows, rows.runStart(r), rows.runEnd[r]);
            }
        }
        terms.accumulate(grazing, falloffOrNull, metallicRows, rows.count, grazingSum);
    }

    private void writeFalloffs(HitRows rows, LightSource source, int s, RowShadowRays rays) {
        if (!AngularMask.isActive(source)) {
            terms.falloffs(rows, source, falloff);
            return;
        }
        AreaSamples samples = source.samples(rows);
        AngularMask[] doors = new AngularMask[samples.patterns];
        Arrays.setAll(doors, t -> AngularMask.of(source.at(samples.position(t, s))));
        terms.unroundedFalloffs(rows, source, factors);
        for (int i = 0; i < rows.count; i++) {
            falloff[i] = (float) (factors[i] * doors[rays.pattern[i]].factor(rows.px[i], rows.py[i], rows.pz[i]));
        }
    }

    /**
     * Returns the layer of the mean terms.
     *
     * @param lit number of lit rows
     */
    LightRows layer(HitRows rows, LightSource source, byte[] state, short[][] visibleSamples, int lit, ColumnAllocator columns) {
        if (lit == 0) {
            return LightRows.unlit(state, visibleSamples);
        }
        int samples = source.samples(rows).samples();
        return new LightRows(state, meanColumn(diffuseSum, samples, rows, columns),
                hasSpecular ? meanColumn(specularSum, samples, rows, columns) : null,
                hasMetallic ? meanColumn(grazingSum, samples, rows, columns) : null, null, visibleSamples, lit);
    }

    private static float[] meanColumn(double[] sum, int samples, HitRows rows, ColumnAllocator columns) {
        float[] mean = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            mean[i] = LightingEquation.mean(sum[i], samples);
        }
        return mean;
    }
}

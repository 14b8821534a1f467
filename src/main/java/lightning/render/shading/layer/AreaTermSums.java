package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.AngularMask;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.FaceHighlight;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import org.jspecify.annotations.Nullable;

/** Sums of an area light's terms over its visible samples. Holds scratch memory: use one instance per thread. */
final class AreaTermSums {
    private final TermKernel terms;
    private final TermColumnWriter columnWriter;
    /** Allocated on first use. */
    private @Nullable HighlightFactors highlightFactors;
    /** Whether rows show the light's face in their highlights. */
    private boolean showsFace;
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
    /** Sums for a light with an image: terms times color, and the specular terms; allocated on first use. */
    private double @Nullable [][] diffuseColor;
    private double @Nullable [][] specularColor;
    private double @Nullable [] specularWeight;
    /** True if any row's material has specular terms or is metallic; computed once per tile and light. */
    private boolean hasSpecular;
    private boolean hasMetallic;

    AreaTermSums(TermKernel terms, TermColumnWriter writer) {
        this.terms = terms;
        columnWriter = writer;
    }

    /**
     * Starts with sums of 0.
     *
     * @param rays pattern of each row
     */
    void begin(HitRows rows, LightSource source, RowShadowRays rays) {
        hasSpecular = columnWriter.hasSpecular(rows);
        hasMetallic = columnWriter.hasMetallic(rows);
        Arrays.fill(diffuseSum, 0);
        Arrays.fill(specularSum, 0);
        if (hasMetallic) {
            Arrays.fill(grazingSum, 0);
        }
        if (source.samples(rows).color != null) {
            beginColors(rows.count);
        }
        showsFace = hasSpecular && FaceHighlight.hasFace(source) && columnWriter.showsFaces(rows);
        if (showsFace) {
            highlightFactors = highlightFactors == null ? new HighlightFactors(TermKernel.MAX_ROWS) : highlightFactors;
            highlightFactors.begin(rows, source, rays);
        }
        Arrays.fill(mayHaveHighlight, 0);
        if (hasSpecular) {
            columnWriter.addPossibleHighlights(rows, source, mayHaveHighlight);
        }
    }

    private void beginColors(int rows) {
        if (diffuseColor == null || specularColor == null || specularWeight == null) {
            diffuseColor = new double[3][TermKernel.MAX_ROWS];
            specularColor = new double[3][TermKernel.MAX_ROWS];
            specularWeight = new double[TermKernel.MAX_ROWS];
        }
        for (int c = 0; c < 3; c++) {
            Arrays.fill(diffuseColor[c], 0, rows, 0);
            Arrays.fill(specularColor[c], 0, rows, 0);
        }
        Arrays.fill(specularWeight, 0, rows, 0);
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
            HighlightFactors ofFace = showsFace ? requireNonNull(highlightFactors) : null;
            if (ofFace != null) {
                ofFace.setSample(s);
            }
            columnWriter.writeSpeculars(rows, highlightRows, specular, grazing, ofFace);
            terms.accumulate(specular, falloffOrNull, highlightRows, rows.count, specularSum);
        }
        if (hasMetallic) {
            addGrazing(rows, falloffOrNull, rowSet);
        }
        if (source.samples(rows).color != null) {
            addColors(rows, source.samples(rows), s, rowSet, cosine, rays);
        }
    }

    /** Adds the terms times the color of sample {@code s}; the falloffs, and the terms of rows with highlights, are those of the sample. */
    private void addColors(HitRows rows, AreaSamples samples, int s, int[] rowSet, float[] cosine, RowShadowRays rays) {
        assert samples.color != null && diffuseColor != null && specularColor != null && specularWeight != null;
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            for (int left = rowSet[b]; left != 0; left &= left - 1) {
                int i = b * RowBits.WIDTH + Integer.numberOfTrailingZeros(left);
                int at = samples.index(s, rays.pattern[i]);
                double diffuse = (double) cosine[i] * falloff[i];
                double shine = hasSpecular && RowBits.contains(highlightRows, i) ? (double) specular[i] * falloff[i] : 0;
                shine += hasMetallic && RowBits.contains(metallicRows, i) ? (double) grazing[i] * falloff[i] : 0;
                specularWeight[i] += shine;
                for (int c = 0; c < 3; c++) {
                    diffuseColor[c][i] += diffuse * samples.color[c][at];
                    specularColor[c][i] += shine * samples.color[c][at];
                }
            }
        }
    }

    private void addGrazing(HitRows rows, float @Nullable [] falloffOrNull, int[] rowSet) {
        System.arraycopy(rowSet, 0, metallicRows, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runCount; r++) {
            if (!columnWriter.hasFacets(rows.runMaterial[r])) {
                RowBits.remove(metallicRows, rows.runStart(r), rows.runEnd[r]);
            }
        }
        terms.accumulate(grazing, falloffOrNull, metallicRows, rows.count, grazingSum);
    }

    private void writeFalloffs(HitRows rows, LightSource source, int s, RowShadowRays rays) {
        AngularMask mask = AngularMask.of(source);
        if (mask == null) {
            terms.falloffs(rows, source, falloff);
            return;
        }
        AreaSamples samples = source.samples(rows);
        terms.unroundedFalloffs(rows, source, factors);
        for (int i = 0; i < rows.count; i++) {
            int at = samples.index(s, rays.pattern[i]);
            falloff[i] = (float) (factors[i]
                    * mask.factor(rows.px[i], rows.py[i], rows.pz[i], samples, at));
        }
    }

    /**
     * Returns the layer of the mean terms.
     *
     * @param lit number of lit rows
     */
    LightRows layer(HitRows rows, LightSource source, byte[] state, short @Nullable [][] visibleSamples, int lit, ColumnAllocator columns) {
        if (lit == 0) {
            return LightRows.unlit(state, visibleSamples);
        }
        AreaSamples samples = source.samples(rows);
        LightRows layer = LightRows.lit(state, new LightRows.Terms(meanColumn(diffuseSum, state, samples, rows, columns),
                hasSpecular ? meanColumn(specularSum, state, samples, rows, columns) : null,
                hasMetallic ? meanColumn(grazingSum, state, samples, rows, columns) : null, null), lit)
                .withVisibleSamples(visibleSamples);
        return source.samples(rows).color == null || diffuseColor == null || specularColor == null || specularWeight == null ? layer
                : layer.withFaceColors(meanColors(diffuseColor, diffuseSum, rows, columns),
                        hasSpecular ? meanColors(specularColor, specularWeight, rows, columns) : null);
    }

    private static float[][] meanColors(double[][] sum, double[] weight, HitRows rows, ColumnAllocator columns) {
        float[][] mean = new float[3][];
        for (int c = 0; c < 3; c++) {
            mean[c] = columns.floats(rows.count);
            for (int i = 0; i < rows.count; i++) {
                mean[c][i] = LightingEquation.weightedMean(sum[c][i], weight[i]);
            }
        }
        return mean;
    }

    private static float[] meanColumn(double[] sum, byte[] state, AreaSamples samples, HitRows rows, ColumnAllocator columns) {
        float[] mean = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            mean[i] = LightingEquation.mean(sum[i], (state[i] & LightRows.REFINED) == 0 ? samples.samples() : samples.refinedSamples());
        }
        return mean;
    }
}

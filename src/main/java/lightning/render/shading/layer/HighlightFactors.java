package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.FaceHighlight;
import lightning.render.shading.LightSource;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import org.jspecify.annotations.Nullable;

/**
 * Factors of the highlights of an area light's samples by {@link FaceHighlight}, for the rows of a tile. Each set of samples that have the spacing of the first ones
 * has its own, which are computed when they are first needed. Holds scratch memory: use one instance per thread.
 */
final class HighlightFactors {
    private final FaceHighlight face = new FaceHighlight();
    private final float[][] surface;
    private final float[][] coat;
    private @Nullable HitRows rows;
    private @Nullable AreaSamples samples;
    private @Nullable RowShadowRays patterns;
    private int set;

    /** @param rows maximum number of rows of a tile */
    HighlightFactors(int rows) {
        surface = new float[AreaSamples.REFINEMENT][rows];
        coat = new float[AreaSamples.REFINEMENT][rows];
    }

    /**
     * Moves to the rows of a tile and an area light.
     *
     * @param itsPatterns pattern of each row
     */
    void begin(HitRows itsRows, LightSource source, RowShadowRays itsPatterns) {
        rows = itsRows;
        patterns = itsPatterns;
        samples = FaceHighlight.hasFace(source) ? source.samples(itsRows) : null;
        set = 0;
        if (samples != null) {
            face.aim(source);
            for (int k = 0; k < surface.length; k++) {
                Arrays.fill(surface[k], 0, itsRows.count, Float.NaN);
                Arrays.fill(coat[k], 0, itsRows.count, Float.NaN);
            }
        }
    }

    /** Moves to a sample of the light. */
    void setSample(int s) {
        set = samples == null ? 0 : s / samples.samples();
    }

    /** Returns whether any factor may differ from 1. */
    boolean areActive() {
        return samples != null;
    }

    /** Scales the terms of a row of a surface whose lobe has width α. */
    void scaleSurface(int row, double alpha, float[] specular, float[] grazing) {
        scale(surface[set], requireNonNull(rows), row, alpha, specular, grazing);
    }

    /**
     * Scales the terms of the coat of a row, as {@link #scaleSurface}.
     *
     * @param over the rows with the normals of their coats
     */
    void scaleCoat(HitRows over, int row, double alpha, float[] specular, float[] grazing) {
        scale(coat[set], over, row, alpha, specular, grazing);
    }

    private void scale(float[] factors, HitRows at, int i, double alpha, float[] specular, float[] grazing) {
        assert samples != null && patterns != null;
        if (Float.isNaN(factors[i])) {
            factors[i] =
                    face.factor(samples, patterns.pattern[i], set * samples.samples(), at.px[i], at.py[i], at.pz[i], at.nx[i], at.ny[i],
                            at.nz[i], at.vx[i], at.vy[i], at.vz[i], alpha);
        }
        specular[i] = FaceHighlight.scaled(specular[i], factors[i], alpha);
        grazing[i] = FaceHighlight.scaled(grazing[i], factors[i], alpha);
    }
}

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
    private @Nullable AreaSamples samples;
    private @Nullable RowShadowRays patterns;
    private int set;

    /** @param rows maximum number of rows of a tile */
    HighlightFactors(int rows) {
        surface = new float[AreaSamples.REFINEMENT][rows];
        coat = new float[AreaSamples.REFINEMENT][rows];
    }

    /**
     * Moves to the rows of a tile and an area light for which {@link FaceHighlight#hasFace} holds.
     *
     * @param itsPatterns pattern of each row
     */
    void begin(HitRows rows, LightSource source, RowShadowRays itsPatterns) {
        patterns = itsPatterns;
        samples = source.samples(rows);
        face.aim(source);
        for (int k = 0; k < surface.length; k++) {
            Arrays.fill(surface[k], 0, rows.count, Float.NaN);
            Arrays.fill(coat[k], 0, rows.count, Float.NaN);
        }
    }

    /** Moves to a sample of the light. */
    void setSample(int s) {
        set = s / requireNonNull(samples).samples();
    }

    /** Scales the terms of a row of a surface whose lobe has width α. */
    void scaleSurface(HitRows rows, int row, double alpha, float[] specular, float[] grazing) {
        scale(surface[set], rows, row, alpha, specular, grazing);
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

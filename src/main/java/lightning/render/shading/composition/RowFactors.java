package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.Bsdf;
import lightning.render.shading.LightWeight;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import org.jspecify.annotations.Nullable;

/**
 * Factors of the rows of a level, as {@link lightning.render.shading.SurfaceFactors}: columns of red, green and blue. They are the same for all
 * films. One instance per thread.
 */
final class RowFactors {
    private final SumKernel kernel;
    private final PrincipledWeights weights = new PrincipledWeights();
    private final PrincipledRow colors = new PrincipledRow();
    final float[][] diffuse = columns();
    final float[][] specular = columns();
    final float[][] grazing = columns();
    final float[][] mirrored = columns();
    final float[][] emitted = columns();
    /** Allocated on first use, as the next two. */
    private float @Nullable [][] refracted;
    private float @Nullable [][] first;
    private float @Nullable [][] second;
    /** Scratch columns for clear rows: Fresnel reflectance and interior tint; allocated on first use. */
    private float @Nullable [] share;
    private float @Nullable [][] tint;

    RowFactors(SumKernel kernel) {
        this.kernel = kernel;
    }

    private static float[][] columns() {
        return new float[3][TermKernel.MAX_ROWS];
    }

    /** Returns factors of refracted rays; set for clear rows only. */
    float[][] refracted() {
        return requireNonNull(refracted);
    }

    /** Returns factors of the first mean light of blurred reflections; set for rows of principled materials only, as {@link #second}. */
    float[][] first() {
        return requireNonNull(first);
    }

    float[][] second() {
        return requireNonNull(second);
    }

    /** Computes the factors of the rows of a run. */
    void set(HitRows rows, int run, ShadingMaterial material) {
        switch (material.bsdf()) {
            case Bsdf.Phong _,Bsdf.Metal _ -> setOpaque(rows, run, material);
            case Bsdf.Principled principled -> setPrincipled(rows, run, principled, material);
            case Bsdf.Clear clear -> setClear(rows, run, clear, material);
        }
    }

    private void setOpaque(HitRows rows, int run, ShadingMaterial material) {
        int start = rows.runStart(run);
        int end = rows.runEnd[run];
        for (int c = 0; c < 3; c++) {
            float kd = material.diffuse()[c];
            float left = 1 - material.reflective()[c];
            float f0 = material.texturedF0()[c];
            if (material.isTextured()) {
                writeTextured(requireNonNull(rows.texel(c)), start, end, kd, left, f0, material.specular()[c],
                        diffuse[c], specular[c]);
            } else {
                Arrays.fill(diffuse[c], start, end, kd * left);
                Arrays.fill(specular[c], start, end, f0 + material.specular()[c]);
            }
            Arrays.fill(grazing[c], start, end, 1);
            Arrays.fill(mirrored[c], start, end, material.reflective()[c]);
            Arrays.fill(emitted[c], start, end, left);
        }
    }

    private static void writeTextured(float[] texel, int start, int end, float kd, float left, float f0, float plain, float[] diffuse,
            float[] specular) {
        for (int i = start; i < end; i++) {
            diffuse[i] = kd * texel[i] * left;
            specular[i] = texel[i] * f0 + plain;
        }
    }

    private void setClear(HitRows rows, int run, Bsdf.Clear clear, ShadingMaterial material) {
        int start = rows.runStart(run);
        int end = rows.runEnd[run];
        refracted = refracted == null ? columns() : refracted;
        share = share == null ? new float[TermKernel.MAX_ROWS] : share;
        tint = tint == null ? columns() : tint;
        kernel.clearTerms(rows, start, end, clear.transmission(), clear.interior(), share, tint);
        for (int c = 0; c < 3; c++) {
            float kr = material.reflective()[c];
            float kt = LightWeight.channel(clear.transmission().color(), c);
            float kd = material.diffuse()[c];
            float ks = material.specular()[c];
            float f0 = material.texturedF0()[c];
            float[] texel = material.isTextured() ? requireNonNull(rows.texel(c)) : null;
            for (int i = start; i < end; i++) {
                float mirror = Refraction.mirrorShare(kr, share[i]);
                float passed = tint[c][i];
                float left = (1 - mirror) * clear.body();
                float color = texel == null ? 1 : texel[i];
                diffuse[c][i] = kd * color * left * passed;
                specular[c][i] = (color * f0 + ks) * passed;
                grazing[c][i] = passed;
                mirrored[c][i] = mirror * passed;
                refracted[c][i] = (1 - mirror) * kt * passed;
                emitted[c][i] = left * passed;
            }
        }
    }

    private void setPrincipled(HitRows rows, int run, Bsdf.Principled principled, ShadingMaterial material) {
        first = first == null ? columns() : first;
        second = second == null ? columns() : second;
        colors.start(principled, material, rows);
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            colors.moveTo(i);
            weights.moveTo(principled, colors.surface(), rows, i);
            for (int c = 0; c < 3; c++) {
                float shine = weights.shine(principled, colors.f0(c), colors.square(c));
                float graze = weights.graze(principled, c);
                diffuse[c][i] = weights.diffuse(colors.diffuse(c));
                specular[c][i] = shine;
                grazing[c][i] = graze;
                mirrored[c][i] = weights.mirror(principled, shine, graze);
                first[c][i] = weights.first(principled, shine, graze);
                second[c][i] = weights.second(principled, c, graze);
                emitted[c][i] = 1;
            }
        }
    }

    /** Returns the diffuse color of rows of a material, including its texture, regardless of lights. */
    void writeUnlit(HitRows rows, int run, ShadingMaterial material, float[][] to) {
        if (material.bsdf() instanceof Bsdf.Principled principled) {
            colors.start(principled, material, rows);
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                colors.moveTo(i);
                for (int c = 0; c < 3; c++) {
                    to[c][i] = colors.diffuse(c);
                }
            }
            return;
        }
        for (int c = 0; c < 3; c++) {
            float[] texel = requireNonNull(rows.texel(c));
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                to[c][i] = material.diffuse()[c] * texel[i];
            }
        }
    }
}

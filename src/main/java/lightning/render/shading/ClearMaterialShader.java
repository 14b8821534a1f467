package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.Refraction;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/** Evaluates the {@link LightingEquation} over the rows of a clear material. Holds scratch columns: use one instance per thread. */
public final class ClearMaterialShader {
    private final SumKernel kernel;
    private final ClearTerms scratch = ClearTerms.allocate();
    /** Stands for missing columns. */
    private final float[] zeros = new float[TermKernel.MAX_ROWS];

    public ClearMaterialShader(SumKernel kernel) {
        this.kernel = kernel;
    }

    /** Computes the terms of all clear rows of a level. */
    public ClearTerms terms(HitRows rows, ShadingMaterial[] materials) {
        return ClearTerms.of(rows, materials, kernel, scratch);
    }

    /** Returns whether the color of a clear material's rows depends on its {@link ClearTerms}; otherwise it is black. */
    public static boolean needsTerms(ShadingMaterial material, @Nullable BounceImages images) {
        return material.takesLight() || !requireNonNull(images).isBlack();
    }

    /**
     * Shades a run of rows, as {@link SumKernel#shade}, including refraction.
     *
     * @param emitted {@link EmittedLight#unmapped} of red, green and blue
     * @param cached  terms of the level's clear rows; computed if null
     */
    public void shade(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] diffuse, float @Nullable [][] specular,
            float @Nullable [][] grazing, @Nullable ClearTerms cached, @Nullable BounceImages images, float[][] to) {
        int start = rows.runStart(run);
        int end = rows.runEnd[run];
        if (!needsTerms(material, images)) {
            for (int c = 0; c < 3; c++) {
                Arrays.fill(to[c], start, end, 0);
            }
            return;
        }
        assert images != null && images.refracted() != null;
        ClearTerms terms = cached == null ? scratch : cached;
        if (cached == null) {
            kernel.clearTerms(rows, start, end, requireNonNull(material.clarity()), requireNonNull(material.interior()), scratch.share,
                    scratch.tint);
        }
        for (int c = 0; c < 3; c++) {
            ClearChannel channel = ClearChannel.of(material, c, emitted[c]);
            if (material.takesLight()) {
                kernel.clearSurface(start, end, channel, material.isTextured() ? requireNonNull(rows.texel(c)) : ClearTerms.WHITE,
                        diffuse[c],
                        specular == null ? zeros : specular[c], grazing == null ? zeros : grazing[c], terms.share, to[c]);
            }
            kernel.clearColor(start, end, channel, material.takesLight(), images.mirrored()[c], images.refracted()[c], terms.share,
                    terms.tint[c], to[c]);
        }
    }

    /**
     * Adds emitted light to a run of rows that were just shaded, by {@link SurfaceWeights#bodyWeight}.
     *
     * @param amount light before its image: red, green, blue
     * @param map    columns of its image
     * @param cached terms of the level's clear rows; those of {@link #shade} if null
     */
    public void addMapped(HitRows rows, int run, ShadingMaterial material, float[] amount, ColumnGroup map, @Nullable ClearTerms cached,
            float[][] to) {
        float body = material.bodyShare();
        // Without a body there may be no terms.
        ClearTerms terms = cached == null ? scratch : cached;
        for (int c = 0; body > 0 && c < 3; c++) {
            float[] texel = requireNonNull(rows.texel(map, c));
            float kr = material.reflective()[c];
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                float weight = (1 - Refraction.mirrorShare(kr, terms.share[i])) * body * terms.tint[c][i];
                to[c][i] = LightingEquation.addMapped(to[c][i], amount[c], texel[i], weight);
            }
        }
    }

    /** Returns the body share of a clear surface: 1 minus its largest transmission channel. */
    static float bodyShare(Transmission clarity) {
        return 1 - (float) clarity.color().max();
    }

    /** Returns a color's channels, rounded as the equation uses them. */
    static float[] channels(Rgb color) {
        return new float[] {channel(color, 0), channel(color, 1), channel(color, 2)};
    }

    /** Returns a color's channel, rounded as the equation uses it. */
    public static float channel(Rgb color, int channel) {
        return (float) switch (channel) {
            case 0 -> color.r();
            case 1 -> color.g();
            default -> color.b();
        };
    }
}

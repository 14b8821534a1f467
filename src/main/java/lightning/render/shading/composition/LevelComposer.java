package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import lightning.render.shading.BounceImages;
import lightning.render.shading.ClearMaterialShader;
import lightning.render.shading.ClearTerms;
import lightning.render.shading.EmittedLight;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MaterialTable;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Third stage for one tile and level: sums the lights' contributions and evaluates the equation over all rows. Holds scratch
 * columns: use one instance per thread.
 */
final class LevelComposer {
    private static final int ROWS = TermKernel.MAX_ROWS;
    private static final List<EmittedLight> MAPPED_KINDS =
            Arrays.stream(EmittedLight.values()).filter(kind -> kind.map().isPresent()).toList();

    private final boolean litTextures;
    private final SumKernel sumKernel;
    private final LightSum lightSum;
    private final ShadingMaterial[] shadingMaterials;
    /** Created on first use. */
    private @Nullable ClearMaterialShader clearShader;
    private final PrincipledShader principledShader = new PrincipledShader();
    private final float[][] colors = new float[3][ROWS];
    /** Stands for an omitted sum. */
    private final float[][] zeros = new float[3][ROWS];
    /** Allocated on first use. */
    private float @Nullable [][] indirectSum;
    private float @Nullable [][] reflectedColumns;
    /** Light that the present rows reflect of their surroundings; null for none. */
    private float @Nullable [][] reflected;
    private LightComponent component = LightComponent.ALL;
    private boolean showsGlow = true;
    /** Emitted light of the run that is being shaded: red, green, blue. */
    private final float[] emitted = new float[3];
    /** Emitted light that an image multiplies: red, green, blue. */
    private final float[] mapped = new float[3];

    LevelComposer(MaterialTable materials, SumKernel sums, ViewEffects view) {
        this.sumKernel = sums;
        lightSum = new LightSum(sums);
        shadingMaterials = new ShadingMaterial[materials.count()];
        Arrays.setAll(shadingMaterials, m -> ShadingMaterial.of(materials, m));
        litTextures = view.litTextures();
    }

    LightSum lightSum() {
        return lightSum;
    }

    /** Sets the light component that is composed from now on. */
    void setComponent(LightComponent v) {
        component = v;
    }

    /** Sets whether surfaces glow from now on. */
    void setShowsGlow(boolean v) {
        showsGlow = v;
    }

    /**
     * Writes the color of each row to its parent.
     *
     * @param lights   lights in scene order
     * @param layers   layer of each light; unread if the light is dark
     * @param branches cached partial sums
     * @param terms    cached terms of clear rows
     * @param indirect indirect light of the rows
     * @param images   colors of the rays that bounce from the rows; null if there are none
     * @param to       receives the linear colors: red, green, blue, {@code float[1024]} each
     */
    void compose(HitRows rows, WeightedLight[] lights, LightLayer[] layers, @Nullable BranchSums branches, @Nullable ClearTerms terms,
            World world, @Nullable IndirectRows indirect, @Nullable BounceImages images, float[][] to) {
        int from = firstLitRow(rows);
        SumColumns sum = branches == null ? lightSum.total(from, rows.count, rows.owner, lights, layers)
                : lightSum.total(from, rows.count, rows.owner, lights, layers, branches);
        float[][] diffuse = indirect == null ? sum.diffuse : addIndirect(indirect, sum.diffuse, from, rows.count);
        reflected = indirect == null ? null : reflected(indirect);
        float ambience = (float) world.ambience();
        // Rows of one material keep the order of their parents. If every position has a row, row i goes to position i.
        boolean inOrder = rows.runCount == 1 && rows.count == ROWS;
        for (int r = 0; r < rows.runCount; r++) {
            shade(rows, r, sum, diffuse, ambience, terms, images, inOrder ? to : colors);
            if (!inOrder) {
                scatter(rows.parent, rows.runStart(r), rows.runEnd[r], to);
            }
        }
    }

    /** Returns the lights' diffuse sum plus the indirect light. */
    private float[][] addIndirect(IndirectRows indirect, float[][] direct, int from, int to) {
        float[][] sum = indirectSum == null ? new float[3][ROWS] : indirectSum;
        indirectSum = sum;
        indirect.weights().interpolate(indirect.light(), sum);
        for (int c = 0; c < 3; c++) {
            for (int i = from; i < to; i++) {
                sum[c][i] += direct[c][i];
            }
        }
        return sum;
    }

    /** Returns what the rows reflect of their surroundings: six columns; null if nothing blurs its reflections. */
    private float @Nullable [][] reflected(IndirectRows indirect) {
        if (indirect.weights().reflected() == null) {
            return null;
        }
        float[][] columns = reflectedColumns == null ? new float[6][ROWS] : reflectedColumns;
        reflectedColumns = columns;
        indirect.weights().interpolateReflected(indirect.light(), columns);
        return columns;
    }

    private ClearMaterialShader clearShader() {
        clearShader = clearShader == null ? new ClearMaterialShader(sumKernel) : clearShader;
        return clearShader;
    }

    /** Returns the terms of a level's clear rows if its colors depend on them; otherwise null. */
    @Nullable
    ClearTerms clearTerms(HitRows rows, @Nullable BounceImages images) {
        for (int run = 0; run < rows.runCount && rows.runStart(run) < rows.clearCount; run++) {
            if (ClearMaterialShader.needsTerms(shadingMaterials[rows.runMaterial[run]], images)) {
                return clearShader().terms(rows, shadingMaterials);
            }
        }
        return null;
    }

    /** Returns whether terms of a level's clear rows fit the present materials. */
    boolean isCurrent(ClearTerms terms, HitRows rows) {
        return terms.isFor(rows, shadingMaterials);
    }

    /** Returns the first row whose color depends on light at its surface. */
    private int firstLitRow(HitRows rows) {
        int run = 0;
        while (run < rows.runCount && !shadingMaterials[rows.runMaterial[run]].takesLight()) {
            run++;
        }
        return run == rows.runCount ? rows.count : rows.runStart(run);
    }

    private void shade(HitRows rows, int run, SumColumns sum, float[][] allDiffuse, float ambience, @Nullable ClearTerms terms,
            @Nullable BounceImages images, float[][] to) {
        ShadingMaterial material = shadingMaterials[rows.runMaterial[run]];
        for (int c = 0; c < 3; c++) {
            emitted[c] = EmittedLight.unmapped(material.texels(), material.ambient()[c], ambience, showsGlow ? material.glow()[c] : 0);
        }
        if (material.hasImage() && !litTextures) {
            shadeUnlit(rows, run, material, to);
        } else {
            shadeLit(rows, run, material, sum, allDiffuse, terms, images, to);
        }
        for (EmittedLight kind : MAPPED_KINDS) {
            if (kind.isMapped(material.texels()) && (showsGlow || kind != EmittedLight.GLOW)) {
                for (int c = 0; c < 3; c++) {
                    mapped[c] = kind.amount(material.ambient()[c], ambience, material.glow()[c]);
                }
                addMapped(rows, run, material, kind.map().orElseThrow(), terms, to);
            }
        }
    }

    private void shadeLit(HitRows rows, int run, ShadingMaterial material, SumColumns sum, float[][] allDiffuse, @Nullable ClearTerms terms,
            @Nullable BounceImages images, float[][] to) {
        boolean shines = component != LightComponent.DIFFUSE;
        float[][] diffuse = component == LightComponent.SPECULAR ? zeros : allDiffuse;
        float[][] specular = shines && sum.hasSpecular && material.hasSpecular() ? sum.specular : null;
        float[][] grazing = shines && sum.hasGrazing && material.texturedF0() != null ? sum.grazing : null;
        if (material.clarity() != null) {
            clearShader().shade(rows, run, material, emitted, diffuse, specular, grazing, terms, images, to);
        } else if (material.principled() != null) {
            principledShader.shade(rows, run, material, emitted, diffuse, specular, grazing, shines ? reflected : null,
                    images == null ? null : images.mirrored(), to);
        } else {
            sumKernel.shade(rows, run, material, emitted, diffuse, specular, grazing, images == null ? null : images.mirrored(), to);
        }
    }

    /** Shades an unlit texture, which shows its own color regardless of the lights. */
    private void shadeUnlit(HitRows rows, int run, ShadingMaterial material, float[][] to) {
        if (material.principled() != null) {
            principledShader.shadeUnlit(rows, run, material, emitted, to);
            return;
        }
        for (int c = 0; c < 3; c++) {
            float[] texel = requireNonNull(rows.texel(c));
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                to[c][i] = emitted[c] + material.diffuse()[c] * texel[i];
            }
        }
    }

    /** Adds emitted light that an image multiplies to the colors of a run's rows. */
    private void addMapped(HitRows rows, int run, ShadingMaterial material, ColumnGroup map, @Nullable ClearTerms terms, float[][] to) {
        if (material.clarity() != null) {
            clearShader().addMapped(rows, run, material, mapped, map, terms, to);
            return;
        }
        for (int c = 0; c < 3; c++) {
            float[] texel = requireNonNull(rows.texel(map, c));
            float weight = 1 - material.reflective()[c];
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                to[c][i] = LightingEquation.addMapped(to[c][i], mapped[c], texel[i], weight);
            }
        }
    }

    /** Writes the colors of a run's rows to their parents, in blocks of consecutive parents. */
    private void scatter(short[] parent, int start, int end, float[][] to) {
        for (int i = start; i < end;) {
            int first = parent[i];
            int next = i + 1;
            while (next < end && parent[next] - first == next - i) {
                next++;
            }
            for (int c = 0; c < 3; c++) {
                System.arraycopy(colors[c], i, to[c], first, next - i);
            }
            i = next;
        }
    }
}

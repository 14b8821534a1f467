package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.shading.BounceImages;
import lightning.render.shading.Bsdf;
import lightning.render.shading.FilmEmission;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MaterialTable;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Third stage for one tile and level: evaluates the equation of {@link lightning.render.shading.SurfaceFactors} over all rows, for one film after
 * the other. Holds scratch columns: use one instance per thread.
 */
final class LevelComposer {
    private static final int ROWS = TermKernel.MAX_ROWS;

    private final boolean litTextures;
    private final LightSum lightSum;
    private final RowFactors factors;
    private final ProductSum products = new ProductSum();
    private final ParentRuns parents = new ParentRuns();
    private final MaterialTable materials;
    private final ShadingMaterial[] shadingMaterials;
    private final float[][] colors = new float[3][ROWS];
    private final GatheredColumns gathered;
    private Set<LightComponent> components = EnumSet.allOf(LightComponent.class);

    LevelComposer(MaterialTable materials, SumKernel sums, ViewEffects view) {
        this.materials = materials;
        lightSum = new LightSum(sums);
        factors = new RowFactors(sums);
        gathered = new GatheredColumns(sums);
        shadingMaterials = new ShadingMaterial[materials.count()];
        Arrays.setAll(shadingMaterials, m -> ShadingMaterial.of(materials, m));
        litTextures = view.litTextures();
    }

    /** Sets the components that are composed from now on; initially all. */
    void setComponents(Set<LightComponent> v) {
        components = v;
    }

    /**
     * Prepares the rows of a level.
     *
     * @param indirect indirect light of the rows
     * @param films    films that will be composed, in ascending order
     */
    void start(HitRows rows, @Nullable IndirectRows indirect, BitSet films) {
        gathered.start(components.contains(LightComponent.GATHERED) ? indirect : null, films);
        for (int run = 0; run < rows.runCount; run++) {
            factors.set(rows, run, shadingMaterials[rows.runMaterial[run]]);
        }
        parents.set(rows);
    }

    /**
     * Writes the color of each row of the level in a film to its parent.
     *
     * @param layers    layer of each light; unread if the light is dark
     * @param mirrored  colors of mirrored rays; null if all are black
     * @param refracted colors of refracted rays; null if all are black
     * @param to        receives the linear colors: red, green, blue, {@code float[1024]} each, where there are rows; unchanged if all rows are black
     */
    void compose(HitRows rows, FilmParts parts, int part, LightLayer[] layers, float @Nullable [][] mirrored,
            float @Nullable [][] refracted, FilmColors to) {
        float[][] indirect = gathered.get(part);
        boolean isLit = (components.contains(LightComponent.DIFFUSE) || components.contains(LightComponent.SPECULAR))
                && LightSum.isLit(parts, part, layers);
        FilmEmission emission = components.contains(LightComponent.EMITTED) ? FilmEmission.of(materials, parts, part) : null;
        boolean isRest = parts.get(part).kind() == FilmPart.Kind.REST;
        if (!isLit && indirect == null && mirrored == null && refracted == null && !emits(rows, emission, isRest)) {
            blacken(rows, to.get(part));
            return;
        }
        int from = firstLitRow(rows);
        SumColumns sum = isLit ? lightSum.total(from, rows.count, rows.owner, parts, part, layers) : null;
        float[][] diffuse = sum == null || !components.contains(LightComponent.DIFFUSE) ? null : sum.diffuse();
        if (indirect != null) {
            diffuse = withDirect(indirect, diffuse, from, rows.count);
        }
        // What the rows reflect of their surroundings: six columns.
        float[][] reflected = indirect == null || indirect.length == 3 ? null : Arrays.copyOfRange(indirect, 3, indirect.length);
        // Rows of one material keep the order of their parents. If every position has a row, row i goes to position i.
        boolean inOrder = rows.runCount == 1 && rows.count == to.positions();
        float[][] target = to.toWrite(part);
        for (int r = 0; r < rows.runCount; r++) {
            ShadingMaterial material = shadingMaterials[rows.runMaterial[r]];
            float[][] run = inOrder ? target : colors;
            if (material.hasImage() && !litTextures) {
                shadeUnlit(rows, r, material, isRest, run);
            } else {
                shade(rows, r, material, diffuse, sum, reflected, mirrored, refracted, run);
            }
            if (emission != null) {
                addEmission(rows, r, material, emission, run);
            }
            if (!inOrder) {
                parents.scatter(rows.runStart(r), rows.runEnd[r], colors, target);
            }
        }
    }

    /** @param background colors of a film with a background; null for others */
    private static void blacken(HitRows rows, float @Nullable [][] background) {
        for (int c = 0; background != null && c < 3; c++) {
            for (int i = 0; i < rows.count; i++) {
                background[c][rows.parent[i]] = 0;
            }
        }
    }

    /** Writes only the bounced rays that the rows of the started level show; parameters as above. */
    void composeImages(HitRows rows, BounceImages images, float[][] to) {
        for (int r = 0; r < rows.runCount; r++) {
            shade(rows, r, shadingMaterials[rows.runMaterial[r]], null, null, null, images.mirrored(), images.refracted(), colors);
            parents.scatter(rows.runStart(r), rows.runEnd[r], colors, to);
        }
    }

    /** Returns whether any row shows light of its own in a film. @param emission null if it is not composed */
    private boolean emits(HitRows rows, @Nullable FilmEmission emission, boolean isRest) {
        boolean emits = false;
        for (int run = 0; run < rows.runCount; run++) {
            int m = rows.runMaterial[run];
            emits |= !litTextures && isRest && shadingMaterials[m].hasImage();
            for (int c = 0; emission != null && c < 3; c++) {
                emits |= emission.amount(m, c) > 0;
            }
        }
        return emits;
    }

    /** Returns the indirect light plus the lights' diffuse sum. */
    private static float[][] withDirect(float[][] indirect, float @Nullable [][] direct, int from, int to) {
        for (int c = 0; direct != null && c < 3; c++) {
            add(direct[c], indirect[c], from, to);
        }
        return indirect;
    }

    private static void add(float[] from, float[] to, int start, int end) {
        for (int i = start; i < end; i++) {
            to[i] += from[i];
        }
    }

    /** Returns the first row whose color depends on light at its surface. */
    private int firstLitRow(HitRows rows) {
        int run = 0;
        while (run < rows.runCount && !shadingMaterials[rows.runMaterial[run]].takesLight()) {
            run++;
        }
        return run == rows.runCount ? rows.count : rows.runStart(run);
    }

    private void shade(HitRows rows, int run, ShadingMaterial material, float @Nullable [][] diffuse, @Nullable SumColumns sum,
            float @Nullable [][] reflected, float @Nullable [][] mirrored, float @Nullable [][] refracted, float[][] to) {
        int start = rows.runStart(run);
        int end = rows.runEnd[run];
        boolean shines = sum != null && sum.hasSpecular && material.hasSpecular() && components.contains(LightComponent.SPECULAR);
        boolean isGrazing = shines && requireNonNull(sum).hasGrazing && material.bsdf().hasFacets();
        for (int c = 0; c < 3; c++) {
            products.start(to[c], start, end);
            if (diffuse != null && material.takesLight()) {
                products.add(factors.diffuse[c], diffuse[c]);
            }
            if (isGrazing) {
                products.addTwo(factors.specular[c], requireNonNull(sum).specular()[c], factors.grazing[c], sum.grazing()[c]);
            } else if (shines) {
                products.add(factors.specular[c], requireNonNull(sum).specular()[c]);
            }
            if (mirrored != null && start < rows.reflectiveCount) {
                products.add(factors.mirrored[c], mirrored[c]);
            }
            if (refracted != null && material.bsdf() instanceof Bsdf.Clear) {
                products.add(factors.refracted()[c], refracted[c]);
            }
            if (reflected != null && material.bsdf() instanceof Bsdf.Principled) {
                products.addTwo(factors.first()[c], reflected[c], factors.second()[c], reflected[3 + c]);
            }
            products.write();
        }
    }

    /** Adds the light that a run's rows emit. */
    private void addEmission(HitRows rows, int run, ShadingMaterial material, FilmEmission emission, float[][] to) {
        boolean isMapped = emission.isMapped() && material.texels().has(ColumnGroup.GLOW_TEXEL);
        for (int c = 0; c < 3; c++) {
            float amount = emission.amount(rows.runMaterial[run], c);
            if (amount > 0) {
                addEmitted(rows, isMapped, c, amount, factors.emitted[c], to[c], rows.runStart(run), rows.runEnd[run]);
            }
        }
    }

    /** @param isMapped whether the glow map multiplies it */
    private static void addEmitted(HitRows rows, boolean isMapped, int c, float amount, float[] factor, float[] to, int start, int end) {
        float[] texel = isMapped ? requireNonNull(rows.texel(ColumnGroup.GLOW_TEXEL, c)) : null;
        for (int i = start; i < end; i++) {
            to[i] += factor[i] * (texel == null ? amount : amount * texel[i]);
        }
    }

    /** Shades an unlit texture, which shows its own color regardless of the lights. */
    private void shadeUnlit(HitRows rows, int run, ShadingMaterial material, boolean isRest, float[][] to) {
        if (isRest) {
            factors.writeUnlit(rows, run, material, to);
        } else {
            for (float[] channel : to) {
                Arrays.fill(channel, rows.runStart(run), rows.runEnd[run], 0);
            }
        }
    }
}

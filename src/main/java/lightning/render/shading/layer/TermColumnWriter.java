package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.AngularMask;
import lightning.render.shading.AnisotropicHighlight;
import lightning.render.shading.Bsdf;
import lightning.render.shading.FaceHighlight;
import lightning.render.shading.LightSource;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.SheenLayer;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Writes the columns of a layer from terms that were aimed at the light: 0 for unlit rows. Holds scratch memory: use one instance
 * per thread.
 */
final class TermColumnWriter {
    private final MaterialTable materials;
    private final TermKernel terms;
    private final RequiredWork requiredWork;
    private final boolean isDiffuseOnly;
    private final int[] reused = RowBits.allocate();
    private final int[] recomputed = RowBits.allocate();
    private final double[] factors = new double[TermKernel.MAX_ROWS];
    /** Scattering of each material, without light that passes. */
    private final Bsdf[] surfaces;
    private final PrincipledWeights weights = new PrincipledWeights();
    private final MappedSurface mapped = new MappedSurface();
    /** Width of the highlight of each row, or roughness of its sheen. */
    private final double[] widths;
    /** For each material whether its highlights have the shape of the faces of area lights. */
    private final boolean[] showsFaces;
    private final float[] coatSpecular;
    private final float[] coatGrazing;
    /** Cosine of the light over the coat of each row. */
    private final float[] coatCosine;

    /** @param diffuseOnly whether rows get no specular terms */
    TermColumnWriter(MaterialTable materials, TermKernel terms, RequiredWork required, boolean diffuseOnly) {
        this.materials = materials;
        this.terms = terms;
        this.requiredWork = required;
        isDiffuseOnly = diffuseOnly;
        surfaces = new Bsdf[materials.count()];
        Arrays.setAll(surfaces, m -> Bsdf.of(materials.material(m)).surface());
        showsFaces = new boolean[materials.count()];
        for (int m = 0; m < showsFaces.length; m++) {
            showsFaces[m] = FaceHighlight.isShownBy(materials.material(m));
        }
        boolean hasWidths = Arrays.stream(surfaces).anyMatch(surface -> surface instanceof Bsdf.Principled m
                && (m.hasRoughnessMap() || m.hasCoatRoughnessMap() || m.highlight() != null || m.sheen() != null));
        widths = new double[hasWidths ? TermKernel.MAX_ROWS : 0];
        boolean isCoated = Arrays.stream(surfaces).anyMatch(surface -> surface instanceof Bsdf.Principled m && m.coat() != null);
        coatSpecular = new float[isCoated ? TermKernel.MAX_ROWS : 0];
        coatGrazing = new float[coatSpecular.length];
        coatCosine = new float[coatSpecular.length];
    }

    /** Returns the diffuse terms of lit rows: the cosine, except for metallic materials that are not principled. */
    float[] diffuseColumn(HitRows rows, float[] cosine, int[] lit, ColumnAllocator columns) {
        float[] column = columns.floats(rows.count);
        terms.select(cosine, lit, rows.count, column);
        writeMetallicDiffuse(rows, lit, column);
        return column;
    }

    /** Replaces the cosine of metallic rows of a set by their diffuse term. */
    void writeMetallicDiffuse(HitRows rows, int[] queried, float[] column) {
        for (int r = 0; r < rows.runCount; r++) {
            if (surfaces[rows.runMaterial[r]].losesDiffuse()) {
                terms.metallicDiffuses(rows, rows.runStart(r), rows.runEnd[r], queried, column);
            }
        }
    }

    /** Specular and grazing columns of a layer, each null if no material needs it. */
    record SpecularColumns(float @Nullable [] specular, float @Nullable [] grazing) {
        static final SpecularColumns NONE = new SpecularColumns(null, null);

        /** Returns the columns of a layer; none if there is no layer. */
        static SpecularColumns of(@Nullable LightRows layer) {
            return layer == null ? NONE : new SpecularColumns(layer.specular, layer.grazing);
        }
    }

    /**
     * Returns the specular and grazing terms of lit rows.
     *
     * @param known rows whose terms are in {@code before}, as far as it has these columns
     */
    SpecularColumns specularColumns(HitRows rows, int[] lit, int @Nullable [] known, SpecularColumns before, ColumnAllocator columns) {
        if (!hasSpecular(rows)) {
            return SpecularColumns.NONE;
        }
        boolean metallic = hasMetallic(rows);
        int[] queried = lit;
        if (known != null) {
            queried = recomputed;
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                reused[b] = lit[b] & known[b];
                recomputed[b] = lit[b] & ~known[b];
            }
        }
        float[] column = startColumn(rows, known, before.specular, columns);
        float[] grazing = metallic ? startColumn(rows, known, before.grazing, columns) : null;
        writeSpeculars(rows, queried, column, grazing, null);
        return new SpecularColumns(column, grazing);
    }

    /** Returns a column with the terms of the rows in {@link #reused}, and 0 elsewhere. */
    private float[] startColumn(HitRows rows, int @Nullable [] known, float @Nullable [] before, ColumnAllocator columns) {
        float[] column = columns.floats(rows.count);
        if (known == null || before == null) {
            Arrays.fill(column, 0, rows.count, 0);
        } else {
            terms.select(before, reused, rows.count, column);
        }
        return column;
    }

    /**
     * Writes the specular terms of the rows of a set whose material is specular.
     *
     * @param grazing receives the grazing terms of metallic rows; unread if there are none
     * @param factors of an area light that the terms were aimed at, if rows show its face; otherwise null
     */
    void writeSpeculars(HitRows rows, int[] queried, float[] column, float @Nullable [] grazing, @Nullable HighlightFactors factors) {
        for (int r = 0; r < rows.runCount; r++) {
            int material = rows.runMaterial[r];
            HighlightFactors itsFactors = showsFaces[material] ? factors : null;
            switch (surfaces[material]) {
                case Bsdf.Phong phong -> {
                    if (isSpecular(material)) {
                        terms.speculars(rows, rows.runStart(r), rows.runEnd[r], queried, phong.shininess(), column);
                    }
                }
                case Bsdf.Metal metal -> {
                    terms.metallicSpeculars(rows, rows.runStart(r), rows.runEnd[r], queried, metal.alpha(), column,
                            requireNonNull(grazing));
                    scaleSurface(rows, r, queried, false, itsFactors, column, grazing);
                }
                case Bsdf.Principled principled ->
                        writePrincipled(rows, r, queried, principled, itsFactors, column, requireNonNull(grazing));
                case Bsdf.Clear _ -> throw new AssertionError("a surface without light that passes");
            }
        }
    }

    private void writePrincipled(HitRows rows, int run, int[] queried, Bsdf.Principled material, @Nullable HighlightFactors factors,
            float[] specular, float[] grazing) {
        if (material.highlight() != null) {
            writeAnisotropic(rows, run, queried, material, material.highlight(), specular, grazing);
        } else if (material.hasRoughnessMap()) {
            writeMappedSpeculars(rows, run, queried, material, specular, grazing);
        } else {
            terms.metallicSpeculars(rows, rows.runStart(run), rows.runEnd[run], queried, material.material().alpha(), specular, grazing);
        }
        scaleSurface(rows, run, queried, material.hasRoughnessMap(), factors, specular, grazing);
        if (material.coat() != null) {
            addCoat(rows, run, queried, material, factors, specular, grazing);
        }
        if (material.sheen() != null) {
            addSheen(rows, run, queried, material, specular, grazing);
        }
    }

    private void writeMappedSpeculars(HitRows rows, int run, int[] queried, Bsdf.Principled material, float[] specular,
            float[] grazing) {
        writeMappedWidths(rows, run, material);
        terms.metallicSpeculars(rows, rows.runStart(run), rows.runEnd[run], queried, widths, specular, grazing);
    }

    private void writeMappedWidths(HitRows rows, int run, Bsdf.Principled material) {
        mapped.start(material.material(), rows);
        for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
            mapped.moveTo(i);
            widths[i] = Material.alpha(mapped.roughness());
        }
    }

    private void writeAnisotropic(HitRows rows, int run, int[] queried, Bsdf.Principled material, AnisotropicHighlight highlight,
            float[] specular, float[] grazing) {
        if (material.hasRoughnessMap()) {
            writeMappedWidths(rows, run, material);
        } else {
            Arrays.fill(widths, rows.runStart(run), rows.runEnd[run], material.material().alpha());
        }
        terms.anisotropicSpeculars(rows, rows.runStart(run), rows.runEnd[run], queried, highlight, widths, specular, grazing);
    }

    private void scaleSurface(HitRows rows, int run, int[] queried, boolean isMapped, @Nullable HighlightFactors factors,
            float[] specular, float[] grazing) {
        double alpha = materials.alpha(rows.runMaterial[run]);
        for (int i = rows.runStart(run); factors != null && i < rows.runEnd[run]; i++) {
            if (RowBits.contains(queried, i)) {
                factors.scaleSurface(rows, i, isMapped ? widths[i] : alpha, specular, grazing);
            }
        }
    }

    /** Changes the terms of a surface to those of the surface below its coat and of the coat, whose reflection has no color. */
    private void addCoat(HitRows rows, int run, int[] queried, Bsdf.Principled material, @Nullable HighlightFactors factors,
            float[] specular, float[] grazing) {
        int from = rows.runStart(run);
        int to = rows.runEnd[run];
        HitRows over = material.hasCoatNormals() ? rows.withCoatNormals() : rows;
        double alpha = requireNonNull(material.coat()).alpha();
        mapped.start(material.material(), rows);
        if (material.hasCoatRoughnessMap()) {
            for (int i = from; i < to; i++) {
                mapped.moveTo(i);
                widths[i] = Material.alpha(mapped.coatRoughness());
            }
            terms.metallicSpeculars(over, from, to, queried, widths, coatSpecular, coatGrazing);
        } else {
            terms.metallicSpeculars(over, from, to, queried, alpha, coatSpecular, coatGrazing);
        }
        if (material.hasCoatNormals()) {
            terms.cosines(over, coatCosine);
            for (int i = from; i < to; i++) {
                coatSpecular[i] = coatCosine[i] > 0 ? coatSpecular[i] : 0;
                coatGrazing[i] = coatCosine[i] > 0 ? coatGrazing[i] : 0;
            }
        }
        for (int i = from; i < to; i++) {
            if (RowBits.contains(queried, i)) {
                if (factors != null) {
                    factors.scaleCoat(over, i, material.hasCoatRoughnessMap() ? widths[i] : alpha, coatSpecular, coatGrazing);
                }
                mapped.moveTo(i);
                weights.moveTo(material, mapped, rows, i);
                specular[i] *= weights.base();
                grazing[i] = weights.coatedGrazing(material, grazing[i], coatSpecular[i], coatGrazing[i]);
            }
        }
    }

    /** Changes the terms of a surface and its coat to one sum and the term of the fibers over them. */
    private void addSheen(HitRows rows, int run, int[] queried, Bsdf.Principled material, float[] specular, float[] grazing) {
        SheenLayer sheen = requireNonNull(material.sheen());
        int from = rows.runStart(run);
        int to = rows.runEnd[run];
        mapped.start(material.material(), rows);
        for (int i = from; i < to; i++) {
            if (RowBits.contains(queried, i)) {
                mapped.moveTo(i);
                widths[i] = mapped.sheenRoughness();
                specular[i] = sheen.below(specular[i], grazing[i]);
            }
        }
        terms.sheens(rows, from, to, queried, widths, grazing);
    }

    /** Adds the rows to a set that may have a specular term for any sample of a light. */
    void addPossibleHighlights(HitRows rows, LightSource source, int[] candidates) {
        for (int r = 0; r < rows.runCount; r++) {
            int material = rows.runMaterial[r];
            if (hasFacets(material)) {
                RowBits.add(candidates, rows.runStart(r), rows.runEnd[r]);
            } else if (isSpecular(material)) {
                terms.addPossibleHighlights(rows, rows.runStart(r), rows.runEnd[r], source, materials.shininess(material), candidates);
            }
        }
    }

    /** Returns whether any row's material has a specular term. */
    boolean hasSpecular(HitRows rows) {
        for (int r = 0; r < rows.runCount; r++) {
            if (isSpecular(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    /** Returns whether any row's material shows faces of area lights in its highlights. */
    boolean showsFaces(HitRows rows) {
        for (int r = 0; r < rows.runCount; r++) {
            if (showsFaces[rows.runMaterial[r]]) {
                return true;
            }
        }
        return false;
    }

    /** Returns whether any row's material is metallic. */
    boolean hasMetallic(HitRows rows) {
        for (int r = 0; r < rows.runCount; r++) {
            if (hasFacets(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    boolean hasFacets(int material) {
        return surfaces[material].hasFacets();
    }

    boolean isSpecular(int material) {
        return !isDiffuseOnly && requiredWork.needsSpecular(materials, material);
    }

    /** Returns the falloff of all rows, lit or not; null if it is 1 everywhere. */
    float @Nullable [] falloffColumn(HitRows rows, LightSource source, ColumnAllocator columns) {
        if (!requiredWork.needsFalloff(source)) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        AngularMask mask = AngularMask.of(source);
        if (mask == null) {
            terms.falloffs(rows, source, column);
        } else {
            terms.unroundedFalloffs(rows, source, factors);
            mask.multiply(rows, factors);
            for (int i = 0; i < rows.count; i++) {
                column[i] = (float) factors[i];
            }
        }
        return column;
    }
}

package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumSet;
import lightning.render.shading.Bsdf;
import lightning.render.shading.FilmEmission;
import lightning.render.shading.FilmParts;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SheenLayer;
import lightning.render.shading.SumKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the direct light, the albedo, the glow and the look of surfels in films. Holds scratch columns: use one instance per thread. */
public final class SurfelShader {
    private static final float[] NO_TEXELS = {};

    private final LightSum lightSum;
    private final ShadingMaterial[] materials;
    private final MaterialTable table;
    private final PrincipledRow principledRow = new PrincipledRow();
    private final SumKernel sumKernel;
    /** Composes what a picture shows of the lights. Created on first use: only pictures with blurred reflections need it. */
    private @Nullable LevelComposer composer;
    private final FilmColors colors = new FilmColors();

    public SurfelShader(MaterialTable table, SumKernel sums) {
        this.table = table;
        lightSum = new LightSum(sums);
        sumKernel = sums;
        materials = new ShadingMaterial[table.count()];
        Arrays.setAll(materials, m -> ShadingMaterial.of(table, m));
    }

    /**
     * Writes the lights' diffuse sum in a film at each surfel of a block.
     *
     * @param layers  layer of each light; unread if the light is dark
     * @param numbers surfel of each parent
     * @param to      receives red, green and blue of all surfels
     * @return false if no light of the film lights the block, so that nothing was written
     */
    public boolean writeDirectLight(HitRows rows, FilmParts parts, int part, LightLayer[] layers, int[] numbers, float[][] to) {
        if (!LightSum.isLit(parts, part, layers)) {
            return false;
        }
        float[][] sum = lightSum.total(0, rows.count, rows.owner, parts, part, layers).diffuse();
        for (int c = 0; c < 3; c++) {
            for (int row = 0; row < rows.count; row++) {
                to[c][numbers[rows.parent[row]]] = sum[c][row];
            }
        }
        return true;
    }

    /** Prepares a block for {@link #addShownLight}. */
    public void start(HitRows rows) {
        composer().start(rows, null, new BitSet());
    }

    /**
     * Adds the lights' diffuse and specular light that a film shows of each surfel of the started block, from where the surfel was first met.
     *
     * @param numbers surfel of each parent
     * @param to      red, green and blue of all surfels
     */
    public void addShownLight(HitRows rows, FilmParts parts, int part, LightLayer[] layers, int[] numbers, float[][] to) {
        colors.clear(parts.count());
        composer().compose(rows, parts, part, layers, null, null, colors);
        float[][] shown = colors.get(part);
        for (int c = 0; shown != null && c < 3; c++) {
            for (int row = 0; row < rows.count; row++) {
                to[c][numbers[rows.parent[row]]] += shown[c][rows.parent[row]];
            }
        }
    }

    private LevelComposer composer() {
        if (composer != null) {
            return composer;
        }
        LevelComposer created = new LevelComposer(table, sumKernel, ViewEffects.ALL);
        created.setComponents(EnumSet.complementOf(EnumSet.of(LightComponent.EMITTED)));
        composer = created;
        return created;
    }

    /**
     * Writes the share of the incoming light that each surfel of a block sends back diffusely.
     *
     * @param numbers surfel of each parent
     * @param to      receives red, green and blue of all surfels
     */
    public void writeAlbedo(HitRows rows, int[] numbers, float[][] to) {
        for (int run = 0; run < rows.runCount; run++) {
            ShadingMaterial material = materials[rows.runMaterial[run]];
            if (material.bsdf() instanceof Bsdf.Principled principled) {
                writePrincipledAlbedo(rows, run, principled, material, numbers, to);
                continue;
            }
            for (int c = 0; c < 3; c++) {
                float[] texel = material.isTextured() ? requireNonNull(rows.texel(c)) : NO_TEXELS;
                float share = (1 - material.reflective()[c]) * material.diffuse()[c];
                for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                    to[c][numbers[rows.parent[row]]] = material.isTextured() ? share * texel[row] : share;
                }
            }
        }
    }

    /**
     * Writes the light that each surfel of a block emits itself in a film, as a picture shows it: glow, bulbs or ambient light.
     *
     * @param numbers surfel of each parent
     * @param to      receives red, green and blue of all surfels
     */
    public void writeEmission(HitRows rows, FilmParts parts, int part, int[] numbers, float[][] to) {
        FilmEmission emission = FilmEmission.of(table, parts, part);
        for (int run = 0; run < rows.runCount; run++) {
            int m = rows.runMaterial[run];
            ShadingMaterial material = materials[m];
            boolean isMapped = emission.isMapped() && material.texels().has(ColumnGroup.GLOW_TEXEL);
            for (int c = 0; c < 3; c++) {
                float amount = (1 - material.reflective()[c]) * emission.amount(m, c);
                float[] map = isMapped ? rows.texel(ColumnGroup.GLOW_TEXEL, c) : null;
                for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                    to[c][numbers[rows.parent[row]]] = map == null ? amount : amount * map[row];
                }
            }
        }
    }

    private void writePrincipledAlbedo(HitRows rows, int run, Bsdf.Principled principled, ShadingMaterial material, int[] numbers,
            float[][] albedo) {
        principledRow.start(principled, material, rows);
        for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
            principledRow.moveTo(row);
            for (int c = 0; c < 3; c++) {
                albedo[c][numbers[rows.parent[row]]] =
                        principledAlbedo(principled, principledRow.surface(), c, principledRow.diffuse(c), principledRow.f0(c));
            }
        }
    }

    /** Returns one channel of the share of light that a principled surface sends back in all directions: reflections count as diffuse. */
    private static float principledAlbedo(Bsdf.Principled material, MappedSurface at, int c, float kd, float f0) {
        float below = kd * (1 - meanFresnel(at.largestNonmetalF0())) + meanFresnel(f0);
        return material.sheen() == null ? below : SheenLayer.meanAlbedo(at, c, below);
    }

    /** Returns the mean of Schlick's reflectance over a hemisphere of uniform light. */
    private static float meanFresnel(float f0) {
        return f0 + (1 - f0) / 21;
    }
}

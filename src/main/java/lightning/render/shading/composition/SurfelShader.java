package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.shading.BounceImages;
import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SheenLayer;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the direct light, the albedo, the glow and the look of surfels. Holds scratch columns: use one instance per thread. */
public final class SurfelShader {
    private static final float[] NO_TEXELS = {};
    private static final World UNLIT = World.DEFAULT.withAmbience(0);

    private final LightSum lightSum;
    private final ShadingMaterial[] materials;
    private final MaterialTable table;
    private final PrincipledRow principledRow = new PrincipledRow();
    private final SumKernel sumKernel;
    /** Composes what a picture shows of the lights. Created on first use: only pictures with blurred reflections need it. */
    private @Nullable LevelComposer composer;
    private float[][] colors = {};

    public SurfelShader(MaterialTable table, SumKernel sums) {
        this.table = table;
        lightSum = new LightSum(sums);
        sumKernel = sums;
        materials = new ShadingMaterial[table.count()];
        Arrays.setAll(materials, m -> ShadingMaterial.of(table, m));
    }

    /**
     * Writes the lights' diffuse sum at each surfel of a block.
     *
     * @param layers layer of each light; unread if the light is dark
     * @param numbers surfel of each parent
     * @param to     receives red, green and blue of all surfels
     */
    public void writeDirectLight(HitRows rows, WeightedLight[] lights, LightLayer[] layers, int[] numbers, float[][] to) {
        float[][] sum = lightSum.total(0, rows.count, rows.owner, lights, layers).diffuse;
        for (int c = 0; c < 3; c++) {
            for (int row = 0; row < rows.count; row++) {
                to[c][numbers[rows.parent[row]]] = sum[c][row];
            }
        }
    }

    /**
     * Adds the lights' diffuse and specular light that a picture shows of each surfel of a block, from where the surfel was first met.
     *
     * @param numbers surfel of each parent
     * @param known   other light of all surfels: red, green and blue
     * @param to      receives the sums; nothing is done if it has no elements
     */
    public void addShownLight(HitRows rows, WeightedLight[] lights, LightLayer[] layers, int[] numbers, float[][] known, float[][] to) {
        if (to[0].length == 0) {
            return;
        }
        composer().compose(rows, lights, layers, null, null, UNLIT, null, BounceImages.BLACK, colors);
        for (int c = 0; c < 3; c++) {
            for (int row = 0; row < rows.count; row++) {
                int surfel = numbers[rows.parent[row]];
                to[c][surfel] = known[c][surfel] + colors[c][rows.parent[row]];
            }
        }
    }

    private LevelComposer composer() {
        if (composer != null) {
            return composer;
        }
        LevelComposer created = new LevelComposer(table, sumKernel, ViewEffects.ALL);
        created.setShowsGlow(false);
        colors = new float[3][TermKernel.MAX_ROWS];
        composer = created;
        return created;
    }

    /**
     * Writes the light that each surfel of a block sends.
     *
     * @param numbers surfel of each parent
     * @param albedo receives the share of the incoming light that is sent back diffusely: red, green and blue of all surfels
     * @param glow   receives the light that the surfels emit themselves: red, green and blue of all surfels
     * @param seen   receives the light that a picture shows of the surfels without lights, bulbs included; empty if it is not needed
     * @param ambience ambient light of the world
     */
    public void writeReflection(HitRows rows, int[] numbers, float[][] albedo, float[][] glow, float[][] seen, float ambience) {
        for (int run = 0; run < rows.runCount; run++) {
            ShadingMaterial material = materials[rows.runMaterial[run]];
            for (int c = 0; c < 3; c++) {
                float[] texel = material.isTextured() ? requireNonNull(rows.texel(c)) : NO_TEXELS;
                float emitted = (1 - material.reflective()[c]) * table.ownGlow(rows.runMaterial[run], c);
                float[] map = material.texels().has(ColumnGroup.GLOW_TEXEL) ? rows.texel(ColumnGroup.GLOW_TEXEL, c) : null;
                float shown = (1 - material.reflective()[c]) * table.glow(rows.runMaterial[run], c);
                float ambient = (1 - material.reflective()[c]) * (material.ambient()[c] * ambience);
                float share = (1 - material.reflective()[c]) * material.diffuse()[c];
                for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                    albedo[c][numbers[rows.parent[row]]] = material.isTextured() ? share * texel[row] : share;
                    glow[c][numbers[rows.parent[row]]] = map == null ? emitted : emitted * map[row];
                    if (seen[c].length > 0) {
                        seen[c][numbers[rows.parent[row]]] = ambient + (map == null ? shown : shown * map[row]);
                    }
                }
            }
            if (material.principled() != null) {
                writePrincipledAlbedo(rows, run, material, numbers, albedo);
            }
        }
    }

    private void writePrincipledAlbedo(HitRows rows, int run, ShadingMaterial material, int[] numbers, float[][] albedo) {
        principledRow.start(material, rows);
        for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
            principledRow.moveTo(row);
            for (int c = 0; c < 3; c++) {
                albedo[c][numbers[rows.parent[row]]] =
                        principledAlbedo(requireNonNull(material.principled()), principledRow.surface(), c, principledRow.diffuse(c),
                                principledRow.f0(c));
            }
        }
    }

    /** Returns one channel of the share of light that a principled surface sends back in all directions: reflections count as diffuse. */
    private static float principledAlbedo(PrincipledMaterial material, MappedSurface at, int c, float kd, float f0) {
        float below = kd * (1 - meanFresnel(at.largestNonmetalF0())) + meanFresnel(f0);
        return material.sheen() == null ? below : SheenLayer.meanAlbedo(at, c, below);
    }

    /** Returns the mean of Schlick's reflectance over a hemisphere of uniform light. */
    private static float meanFresnel(float f0) {
        return f0 + (1 - f0) / 21;
    }
}

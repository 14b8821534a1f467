package lightning.render.relight.paper;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.column.ColumnSet;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ColumnAllocator;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;
import org.jspecify.annotations.Nullable;

/**
 * Second stage for one tile by the paper's method (§4): contributions include all factors and are scaled by ratios. Holds scratch
 * memory: use one instance per thread.
 */
public final class RatioKernel {
    private static final float[] ZEROS = new float[TermKernel.MAX_ROWS];

    private final LightKernel lightKernel;
    private final AttenuationRatio falloffs;
    private final ScratchColumns scratch = new ScratchColumns();
    private double minFalloff = 1;
    private long rowsScaled;

    public RatioKernel(LightKernel exact) {
        this.lightKernel = exact;
        falloffs = new AttenuationRatio(exact.terms());
    }

    /**
     * Returns the smallest falloff, before or after, of any row that {@link #update} scaled by a ratio of falloffs since the start;
     * at least the smallest normal float.
     */
    double minFalloff() {
        return minFalloff;
    }

    /** Returns the number of layer rows tested, written or scaled since the start. */
    long rowsTouched() {
        return lightKernel.rowsTouched() + rowsScaled;
    }

    /** Recomputes all contributions, shadow rays included: the worst case, and the paper's solution for an old value of 0. */
    public RatioRows recompute(HitRows rows, WeightedLight light) {
        scratch.reset();
        return contributions(rows, light, lightKernel.recompute(rows, light.source(), scratch),
                ColumnAllocator.NEW_ARRAYS.states(rows.count));
    }

    /** Recomputes all contributions of rows whose states are known. Casts no shadow ray. */
    RatioRows recomputeContributions(HitRows rows, WeightedLight light, RatioRows before) {
        scratch.reset();
        return contributions(rows, light, lightKernel.recomputeTerms(rows, light.source(), before, scratch),
                ColumnAllocator.NEW_ARRAYS.states(rows.count));
    }

    /** Returns the terms of rows whose states are known. Casts no shadow ray. */
    LightRows terms(HitRows rows, WeightedLight light, RatioRows layer) {
        return lightKernel.recomputeTerms(rows, light.source(), layer, ColumnAllocator.NEW_ARRAYS);
    }

    /** Computes all contributions from known terms, with the result of {@link #recompute}. Casts no ray. */
    RatioRows fromTerms(HitRows rows, WeightedLight light, LightRows layer) {
        rowsScaled += layer.litCount;
        return contributions(rows, light, layer, ColumnAllocator.NEW_ARRAYS.states(rows.count));
    }

    private RatioRows contributions(HitRows rows, WeightedLight light, LightRows layer, byte[] states) {
        if (layer.isUnreached()) {
            return RatioRows.UNREACHED;
        }
        System.arraycopy(layer.state, 0, states, 0, rows.count);
        if (layer.litCount == 0) {
            return new RatioRows(states, null, null, null, copyCompact(rows, layer.visibleSamples()), 0)
                    .withTint(copyCompact(rows, layer.tint()));
        }
        float[][] diffuse = weighted(rows, light, light.diffuse(), requireNonNull(layer.cosine), layer.face, layer);
        float[][] specular =
                layer.specular == null ? null : weighted(rows, light, light.specular(), layer.specular, layer.highlight, layer);
        float[][] grazing = layer.grazing == null ? null : weighted(rows, light, light.specular(), layer.grazing, layer.highlight, layer);
        return new RatioRows(states, diffuse, specular, grazing, copyCompact(rows, layer.visibleSamples()), layer.litCount)
                .withTint(copyCompact(rows, layer.tint()));
    }

    /** Returns a permanent copy that is just long enough. */
    private static float @Nullable [][] copyCompact(HitRows rows, float @Nullable [][] tint) {
        return tint == null ? null
                : Arrays.stream(tint).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows.count))).toArray(float[][]::new);
    }

    /** Returns a permanent copy that is just long enough. */
    private static short @Nullable [][] copyCompact(HitRows rows, short @Nullable [][] visibleSamples) {
        return visibleSamples == null ? null
                : Arrays.stream(visibleSamples).map(column -> Arrays.copyOf(column, HitRows.paddedLength(rows.count)))
                        .toArray(short[][]::new);
    }

    /** @param colors mean colors of the light's image for the term; null if it has none */
    private static float[][] weighted(HitRows rows, WeightedLight light, LightWeight weight, float[] term, float @Nullable [][] colors,
            LightRows layer) {
        if (light.gains() != null || colors != null) {
            return multiplied(rows, light, weight, term, colors, layer);
        }
        float[][] out = columns(rows);
        float[][] tint = layer.tint();
        for (int i = 0; i < rows.count && tint != null; i++) {
            float falloff = layer.falloff == null ? 1 : layer.falloff[i];
            out[0][i] = LightingEquation.contribution(weight.red(), term[i], falloff, tint[0][i]);
            out[1][i] = LightingEquation.contribution(weight.green(), term[i], falloff, tint[1][i]);
            out[2][i] = LightingEquation.contribution(weight.blue(), term[i], falloff, tint[2][i]);
        }
        float[] falloff = layer.falloff;
        for (int i = 0; i < rows.count && tint == null; i++) {
            float premultiplied = falloff == null ? term[i] : term[i] * falloff[i];
            out[0][i] = weight.red() * premultiplied;
            out[1][i] = weight.green() * premultiplied;
            out[2][i] = weight.blue() * premultiplied;
        }
        return out;
    }

    /** Returns the contributions of a light with gains on single shapes or an image. */
    private static float[][] multiplied(HitRows rows, WeightedLight light, LightWeight weight, float[] term, float @Nullable [][] colors,
            LightRows layer) {
        float[][] out = columns(rows);
        for (int i = 0; i < rows.count; i++) {
            float gain = light.gains() == null ? 1 : light.gain(requireNonNull(rows.owner)[i]);
            float falloff = layer.falloff == null ? 1 : layer.falloff[i];
            for (int c = 0; c < 3; c++) {
                out[c][i] = LightingEquation.contribution(weight.channel(c), term[i], falloff, layer.factor(colors, c, i) * gain);
            }
        }
        return out;
    }

    private static float[][] columns(HitRows rows) {
        return new float[][] {ColumnAllocator.NEW_ARRAYS.floats(rows.count), ColumnAllocator.NEW_ARRAYS.floats(rows.count),
            ColumnAllocator.NEW_ARRAYS.floats(rows.count)};
    }

    /** Applies the paper's updates of color, intensity, attenuation, dropoff and angle, alone or together. */
    public RatioRows update(HitRows rows, WeightedLight from, WeightedLight to, RatioRows before, ConeChange cone, boolean falloff) {
        if (to.source().isArea() && (cone != ConeChange.NONE || falloff)) {
            return recomputeArea(rows, to, before, cone);
        }
        if (needsTerms(from) || needsTerms(to)) {
            return recomputeTerms(rows, to, before, cone);
        }
        IntensityRatio intensity = IntensityRatio.between(from, to);
        if (!intensity.isUsable()) {
            return recompute(rows, to);
        }
        if (before.tint() != null && !to.source().isArea()) {
            return recomputeTerms(rows, to, before, cone);
        }
        if (before.litCount() == 0 && cone != ConeChange.ANGLE_ADD) {
            return cone == ConeChange.NONE ? before : updateCone(rows, to, before, before, cone);
        }
        if (falloff && before.litCount() > 0) {
            if (!falloffs.compute(rows, from.source(), to.source(), before.states())) {
                return recompute(rows, to);
            }
            minFalloff = Math.min(minFalloff, falloffs.minFalloff());
        }
        RatioRows scaled = scale(rows, before, intensity, falloff && before.litCount() > 0);
        return cone == ConeChange.NONE ? scaled : updateCone(rows, to, before, scaled, cone);
    }

    /** Returns whether contributions have factors with roundings that the error bound of ratios does not include. */
    private static boolean needsTerms(WeightedLight light) {
        return light.light().influence().isGained() || light.light().sampleImage().isPresent();
    }

    /**
     * Recomputes an area light's layer without casting rays. The samples of one row have different falloff ratios, so their sum has
     * no known ratio.
     */
    private RatioRows recomputeArea(HitRows rows, WeightedLight light, RatioRows before, ConeChange cone) {
        scratch.reset();
        LightRows known = toTermLayer(before);
        LightRows updated = lightKernel.update(rows, light.source(), known, cone, true, scratch);
        return updated == known ? before : contributions(rows, light, updated, ColumnAllocator.NEW_ARRAYS.states(rows.count));
    }

    /**
     * Recomputes a layer that is tinted or has gains or an image, without casting rays. These add roundings that the error bound of ratios
     * does not include.
     */
    private RatioRows recomputeTerms(HitRows rows, WeightedLight light, RatioRows before, ConeChange cone) {
        scratch.reset();
        LightRows known = toTermLayer(before);
        LightRows coneUpdated = cone == ConeChange.NONE ? known : lightKernel.update(rows, light.source(), known, cone, false, scratch);
        return contributions(rows, light, lightKernel.recomputeTerms(rows, light.source(), coneUpdated, scratch),
                ColumnAllocator.NEW_ARRAYS.states(rows.count));
    }

    /** Returns a layer with known states, visible samples and tints. */
    private static LightRows toTermLayer(RatioRows before) {
        if (before.isUnreached()) {
            return LightRows.UNREACHED;
        }
        LightRows layer = before.litCount() == 0 ? LightRows.unlit(before.states())
                : LightRows.lit(before.states(), new LightRows.Terms(ZEROS, before.specular == null ? null : ZEROS,
                        before.grazing == null ? null : ZEROS, null), before.litCount());
        return layer.withVisibleSamples(before.visibleSamples()).withTint(before.tint());
    }

    private RatioRows scale(HitRows rows, RatioRows before, IntensityRatio intensity, boolean falloff) {
        if (before.litCount() == 0 || !falloff && intensity.equals(IntensityRatio.NONE)) {
            return before;
        }
        rowsScaled += before.litCount();
        return new RatioRows(before.states(), scale(rows, requireNonNull(before.diffuse), intensity, falloff),
                before.specular == null ? null : scale(rows, before.specular, intensity, falloff),
                before.grazing == null ? null : scale(rows, before.grazing, intensity, falloff), before.visibleSamples(), before.litCount())
                .withTint(before.tint());
    }

    private float[][] scale(HitRows rows, float[][] from, IntensityRatio intensity, boolean falloff) {
        float[][] to = columns(rows);
        for (int c = 0; c < 3; c++) {
            float factor = intensity.channel(c);
            float[] in = from[c];
            float[] out = to[c];
            for (int i = 0; i < rows.count; i++) {
                out[i] = in[i] * factor;
            }
            if (falloff) {
                float[] ratio = falloffs.ratio;
                for (int i = 0; i < rows.count; i++) {
                    out[i] = out[i] * ratio[i];
                }
            }
        }
        return to;
    }

    /** Removes rows that left the cone and adds rows that entered it; {@code scaled} holds the others. */
    private RatioRows updateCone(HitRows rows, WeightedLight light, RatioRows before, RatioRows scaled, ConeChange cone) {
        scratch.reset();
        LightRows known = toTermLayer(before);
        LightRows coneUpdated = lightKernel.update(rows, light.source(), known, cone, false, scratch);
        return coneUpdated.state == known.state ? scaled : mergeRows(rows, light, before, scaled, coneUpdated);
    }

    /**
     * Updates a layer after a geometry change. Casts shadow rays again from rows whose result may change and recomputes the rows
     * that are now lit.
     *
     * @param light the light that the layer was computed for
     */
    RatioRows updateShadows(HitRows rows, WeightedLight light, RatioRows before, ShapeChange change) {
        scratch.reset();
        LightRows known = toTermLayer(before);
        LightRows updated = lightKernel.updateShadows(rows, light.source(), known, change, scratch);
        if (updated != known && (light.source().isArea() || updated.tint() != null || known.tint() != null)) {
            return contributions(rows, light, lightKernel.recomputeTerms(rows, light.source(), updated, scratch),
                    ColumnAllocator.NEW_ARRAYS.states(rows.count));
        }
        return updated == known ? before
                : mergeRows(rows, light, before, before, lightKernel.update(rows, light.source(), updated, ConeChange.NONE, true, scratch));
    }

    /** Merges rows: those lit before come from {@code scaled}, others from {@code updated}. */
    private RatioRows mergeRows(HitRows rows, WeightedLight light, RatioRows before, RatioRows scaled, LightRows updated) {
        RatioRows entered = contributions(rows, light, updated, ColumnAllocator.NEW_ARRAYS.states(rows.count));
        for (int i = 0; i < rows.count && entered.litCount() > 0; i++) {
            boolean stays = (before.states()[i] & LightRows.STATE_MASK) == LightRows.LIT
                    && (entered.states()[i] & LightRows.STATE_MASK) == LightRows.LIT;
            if (stays) {
                copyRow(requireNonNull(scaled.diffuse), requireNonNull(entered.diffuse), i);
                // A layer that was exact may lack highlights that are 0; then those of the new rows are 0 too.
                if (entered.specular != null && scaled.specular != null) {
                    copyRow(scaled.specular, entered.specular, i);
                }
                if (entered.grazing != null) {
                    copyRow(requireNonNull(scaled.grazing), entered.grazing, i);
                }
            }
        }
        return entered;
    }

    /**
     * Updates a layer after an edit of materials. Recomputes the specular contributions of rows of the changed materials without
     * casting rays, and the diffuse ones too if a material is or was metallic.
     *
     * @param light   the light that the layer was computed for
     * @param changed materials whose shininess, roughness or model changed, or that gained or lost highlights
     */
    RatioRows updateSpeculars(HitRows rows, WeightedLight light, RatioRows before, MaterialSet changed) {
        if (before.litCount() == 0 || !changed.intersects(rows)) {
            return before.grazing == null || lightKernel.needsGrazing(rows) ? before
                    : new RatioRows(before.states(), before.diffuse, before.specular, null, before.visibleSamples(), before.litCount())
                            .withTint(before.tint());
        }
        scratch.reset();
        LightRows known = toTermLayer(before);
        LightRows updated = lightKernel.updateSpeculars(rows, light.source(), known, changed, scratch);
        if (updated.specular == null && updated.cosine == known.cosine) {
            return new RatioRows(before.states(), before.diffuse, null, null, before.visibleSamples(), before.litCount())
                    .withTint(before.tint());
        }
        LightRows premultiplied = lightKernel.update(rows, light.source(), updated, ConeChange.NONE, true, scratch);
        return new RatioRows(before.states(),
                updated.cosine == known.cosine ? before.diffuse
                        : recomputeChanged(rows, light, light.diffuse(), premultiplied, premultiplied.cosine, premultiplied.face,
                                before.diffuse, changed),
                recomputeChanged(rows, light, light.specular(), premultiplied, premultiplied.specular, premultiplied.highlight,
                        before.specular, changed),
                recomputeChanged(rows, light, light.specular(), premultiplied, premultiplied.grazing, premultiplied.highlight,
                        before.grazing, changed),
                before.visibleSamples(),
                before.litCount()).withTint(before.tint());
    }

    /** Returns a term's contributions; rows of unchanged materials keep theirs, if they had any. */
    private static float @Nullable [][] recomputeChanged(HitRows rows, WeightedLight light, LightWeight weight, LightRows layer,
            float @Nullable [] term, float @Nullable [][] colors, float @Nullable [][] before, MaterialSet changed) {
        if (term == null) {
            return null;
        }
        float[][] updated = weighted(rows, light, weight, term, colors, layer);
        for (int r = 0; r < rows.runCount && before != null; r++) {
            for (int i = rows.runStart(r); i < rows.runEnd[r] && !changed.contains(rows.runMaterial[r]); i++) {
                copyRow(before, updated, i);
            }
        }
        return updated;
    }

    /**
     * Returns the layer for rows spliced from old and added ones.
     *
     * @param before layer of the old rows
     * @param added  layer of the added rows; null if there are none
     */
    RatioRows splice(RowSplice splice, RatioRows before, @Nullable RatioRows added) {
        if (before.isUnreached() && (added == null || added.isUnreached())) {
            return RatioRows.UNREACHED;
        }
        Set<RatioRows.Column> known = EnumSet.allOf(RatioRows.Column.class);
        if (!lightKernel.hasSpecular(splice.rows())) {
            known.removeAll(RatioRows.Column.SPECULAR_COLUMNS);
        }
        if (before.grazing == null && !lightKernel.needsGrazing(splice.rows())) {
            known.removeAll(RatioRows.Column.GRAZING_COLUMNS);
        }
        if (before.tint() == null && (added == null || added.tint() == null)) {
            known.removeAll(RatioRows.Column.TINT_COLUMNS);
        }
        known.removeIf(kind -> RatioRows.Column.SAMPLE_COLUMNS.contains(kind) && !before.columns().has(kind)
                && (added == null || !added.columns().has(kind)));
        ColumnSet<RatioRows.Column> columns = ColumnSet.allocate(RatioRows.Column.class, known, splice.rows().count);
        splice.fill(columns, LightRows.withDefaultTint(before.columns(), RatioRows.Column.TINT_COLUMNS),
                added == null ? null : LightRows.withDefaultTint(added.columns(), RatioRows.Column.TINT_COLUMNS));
        byte[] states = (byte[]) columns.get(RatioRows.Column.STATE);
        int lit = 0;
        for (byte state : states) {
            lit += (state & LightRows.STATE_MASK) == LightRows.LIT ? 1 : 0;
        }
        return lit == 0 ? new RatioRows(states, null, null, null, LightRows.readVisibleSamples(columns, RatioRows.Column.SAMPLE_COLUMNS), 0)
                .withTint(LightRows.readChannels(columns, RatioRows.Column.TINT_COLUMNS))
                : new RatioRows(columns, lit);
    }

    private static void copyRow(float[][] from, float[][] to, int row) {
        to[0][row] = from[0][row];
        to[1][row] = from[1][row];
        to[2][row] = from[2][row];
    }
}

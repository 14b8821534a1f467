package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.render.column.ColumnSet;
import lightning.render.shading.LightSource;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Second stage for one tile: computes or updates a light's layer over the hit rows. Holds scratch memory: use one instance per
 * thread.
 */
public final class LightKernel {
    private final LightLinks links;
    /** Created for the first area light. */
    private @Nullable AreaLightKernel areaKernel;
    private final Tracer tracer;
    private final TermKernel terms;
    private final TermColumnWriter columnWriter;
    private final RequiredWork requiredWork;
    private final boolean isDiffuseOnly;
    /** True if rows are surfels: they have few samples, in penumbras too. */
    private final boolean isOfSurfels;
    private final float[] cosine = new float[TermKernel.MAX_ROWS];
    private final int[] facing = RowBits.allocate();
    /** Rows that a cone change affects, and those of them inside the cone. */
    private final int[] coneCandidates = RowBits.allocate();
    private final int[] inside = RowBits.allocate();
    private final int[] chosen = RowBits.allocate();
    private final int[] blocked = RowBits.allocate();
    private final int[] lit = RowBits.allocate();
    private final int[] litBefore = RowBits.allocate();
    /** Rows whose tint must be computed. */
    private final int[] tintRows = RowBits.allocate();
    private long rowsTouched;

    public LightKernel(Geometry geometry, Tracer tracer, TermKernel terms, ViewEffects view) {
        this(geometry, tracer, terms, view, true, false);
    }

    /**
     * Returns a kernel for surfels: the mean over many of them needs few samples.
     *
     * @param shines whether reflections show them, with their highlights; otherwise layers have no specular terms
     */
    public static LightKernel forSurfels(Geometry geometry, Tracer tracer, TermKernel terms, ViewEffects view, boolean shines) {
        return new LightKernel(geometry, tracer, terms, view, shines, true);
    }

    private LightKernel(Geometry geometry, Tracer tracer, TermKernel terms, ViewEffects view, boolean shines, boolean isOfSurfels) {
        this.tracer = tracer;
        this.terms = terms;
        requiredWork = RequiredWork.of(view);
        isDiffuseOnly = !shines;
        this.isOfSurfels = isOfSurfels;
        links = new LightLinks(geometry, tracer, view);
        columnWriter = new TermColumnWriter(geometry.materials(), terms, requiredWork, isDiffuseOnly);
    }

    /** Returns a light with the samples of the kernel's rows. */
    private LightSource sampled(LightSource light) {
        return isOfSurfels ? light.forSurfels() : light;
    }

    private AreaLightKernel areaKernel() {
        areaKernel =
                areaKernel == null ? new AreaLightKernel(links, tracer, terms, columnWriter, requiredWork, !isOfSurfels) : areaKernel;
        return areaKernel;
    }

    /** Returns the kernel that computes the terms. */
    public TermKernel terms() {
        return terms;
    }

    /** Returns the number of all shadow rays since the start. */
    public long shadowRayCount() {
        return links.shadowRayCount();
    }

    /** Returns the number of shadow rays of each light since the start, by its name. */
    public Map<String, Long> shadowRays() {
        return links.shadowRays();
    }

    /** Returns the number of layer rows tested or written since the start. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /** Recomputes the light's diffuse and specular terms in full: the paper's worst case (§4.5). */
    public LightRows recompute(HitRows rows, LightSource light, ColumnAllocator columns) {
        LightSource source = sampled(light);
        if (source.isArea()) {
            rowsTouched += rows.count;
            return areaKernel().recompute(rows, source, columns);
        }
        if (!canReachAnyRow(rows, source)) {
            return LightRows.UNREACHED;
        }
        aim(rows, source);
        TestedRows tested = testAll(rows, source);
        rowsTouched += rows.count;
        float[][] tint = links.shadowCaster(source).tintColumns(rows, source, tested.lit(), null, columns);
        return buildLayer(rows, source, states(rows, tested, columns), tested.lit(), Optional.empty(), columns).withTint(tint);
    }

    /** Returns whether any row may be inside the cone and is of a shape that the light illuminates; otherwise no row needs a test. */
    private boolean canReachAnyRow(HitRows rows, LightSource source) {
        return requiredWork.needsConeTest(source, rows, tracer) && links.canReach(source, rows);
    }

    /**
     * Rows that passed the tests of a recomputed layer, each a part of the one before; in scratch memory, until the next test.
     *
     * @param facing rows that face the light
     * @param inside those of them inside its cone that it illuminates: a shadow ray was cast from each
     * @param lit    those of them whose shadow ray is not blocked
     */
    private record TestedRows(int[] facing, int[] inside, int[] lit) {}

    /** Tests all rows. Expects terms that were aimed; writes {@link #cosine}. */
    private TestedRows testAll(HitRows rows, LightSource source) {
        terms.cosines(rows, cosine);
        terms.selectFacing(cosine, rows.count, facing);
        selectInside(rows, source, facing, chosen);
        links.shadowCaster(source).cast(rows, source, chosen, blocked);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            lit[b] = chosen[b] & ~blocked[b];
        }
        return new TestedRows(facing, chosen, lit);
    }

    /** Selects the candidates that are in the cone and that the light illuminates. */
    private void selectInside(HitRows rows, LightSource source, int[] candidates, int[] selected) {
        if (source.hasCone()) {
            terms.selectInside(candidates, rows.count, source.cosAngle(), selected);
        } else {
            System.arraycopy(candidates, 0, selected, 0, RowBits.words(rows.count));
        }
        links.retainLit(source, rows, selected);
    }

    /** Returns the states of rows that were tested, face away or are outside. */
    private static byte[] states(HitRows rows, TestedRows tested, ColumnAllocator columns) {
        byte[] state = columns.states(rows.count);
        for (int b = 0, row = 0; row < rows.count; b++, row += RowBits.WIDTH) {
            int end = Math.min(rows.count, row + RowBits.WIDTH);
            int valid = RowBits.validBits(b, rows.count);
            if (tested.lit[b] == valid) {
                Arrays.fill(state, row, end, (byte) (LightRows.LIT | LightRows.UNBLOCKED));
            } else if (tested.facing[b] == 0) {
                Arrays.fill(state, row, end, LightRows.FACING_AWAY);
            } else {
                for (int i = row; i < end; i++) {
                    state[i] = state(tested.facing[b] >>> i - row & 1, tested.inside[b] >>> i - row & 1, tested.lit[b] >>> i - row & 1);
                }
            }
        }
        return state;
    }

    private static byte state(int facing, int inside, int lit) {
        return (byte) (facing == 0 ? LightRows.FACING_AWAY
                : inside == 0 ? LightRows.OUTSIDE_CONE
                : lit == 0 ? LightRows.SHADOWED | LightRows.BLOCKED : LightRows.LIT | LightRows.UNBLOCKED);
    }

    private void aim(HitRows rows, LightSource source) {
        terms.aim(rows, source);
        if (source.hasCone()) {
            terms.computeConeCosines(rows, source);
        }
    }

    /**
     * Terms of an earlier layer of the same light at the same place.
     *
     * @param lit rows that were lit, whose specular terms are known
     */
    private record KnownTerms(LightRows layer, int[] lit) {
        static Optional<KnownTerms> of(LightRows layer, int rows, int[] scratch) {
            if (layer.litCount == 0) {
                return Optional.empty();
            }
            RowBits.selectState(layer.state, rows, LightRows.LIT, scratch);
            return Optional.of(new KnownTerms(layer, scratch));
        }

        boolean haveFalloffs() {
            return !layer.isPremultiplied();
        }
    }

    /** Builds a layer from its states, the rows that are lit, and terms that are known. Expects terms that were aimed, and their cosines. */
    private LightRows buildLayer(HitRows rows, LightSource source, byte[] state, int[] litRows, Optional<KnownTerms> known,
            ColumnAllocator columns) {
        int count = RowBits.count(litRows, rows.count);
        if (count == 0) {
            return LightRows.unlit(state);
        }
        float[] diffuse = columnWriter.diffuseColumn(rows, cosine, litRows, columns);
        TermColumnWriter.SpecularColumns speculars = columnWriter.specularColumns(rows, litRows,
                known.filter(k -> k.layer.specular != null).map(KnownTerms::lit).orElse(null),
                TermColumnWriter.SpecularColumns.of(known.map(KnownTerms::layer).orElse(null)), columns);
        float[] falloffs = known.isPresent() && known.get().haveFalloffs() ? known.get().layer.falloff
                : columnWriter.falloffColumn(rows, source, columns);
        return LightRows.lit(state, new LightRows.Terms(diffuse, speculars.specular(), speculars.grazing(), falloffs), count);
    }

    /**
     * Updates a layer after an edit that does not move the light; shares unchanged columns with the old layer.
     *
     * @param cone    rows that may enter or leave the cone
     * @param falloff true if the falloff changed
     */
    public LightRows update(HitRows rows, LightSource light, LightRows before, ConeChange cone, boolean falloff, ColumnAllocator columns) {
        LightSource source = sampled(light);
        if (before.isUnreached()) {
            return cone.canChange(LightRows.OUTSIDE_CONE) ? recompute(rows, source, columns) : before;
        }
        if (source.isArea()) {
            return updateArea(rows, source, before, cone, falloff, columns);
        }
        int count = cone.findAffectedRows(before.state, rows.count, coneCandidates);
        boolean changesFalloffs = falloff && before.litCount > 0;
        if (count == 0 && !changesFalloffs) {
            return before;
        }
        boolean needsDirections = count > 0 || source.hasCone() || before.isPremultiplied();
        if (needsDirections) {
            aim(rows, source);
        } else {
            terms.computeDistances(rows, source);
        }
        LightRows coneUpdated = count == 0 ? before : moveCone(rows, source, before, columns);
        // The falloff is written for lit rows; rows that the cone change tested are already counted.
        rowsTouched += count + (falloff && !cone.canChange(LightRows.LIT) ? before.litCount : 0);
        if (coneUpdated.litCount == 0) {
            return coneUpdated;
        }
        if (coneUpdated.isPremultiplied()) {
            return falloff ? recomputePremultiplied(rows, source, coneUpdated, columns) : coneUpdated;
        }
        return hasCurrentFalloffs(before, coneUpdated, falloff) ? coneUpdated
                : coneUpdated.withFalloff(columnWriter.falloffColumn(rows, source, columns));
    }

    /**
     * Returns whether the falloffs of a layer after its cone update are those of the light now. They are if none changed, or if the cone
     * update wrote a new column. A missing column may mean that the light had no falloff before, so it never counts.
     */
    private static boolean hasCurrentFalloffs(LightRows before, LightRows coneUpdated, boolean falloffChanged) {
        boolean wroteFalloffs = coneUpdated.falloff != before.falloff;
        return coneUpdated.falloff != null && (!falloffChanged || wroteFalloffs);
    }

    /** Recomputes cosines and falloffs into separate columns and keeps the other columns. Expects terms that were aimed. */
    private LightRows recomputePremultiplied(HitRows rows, LightSource source, LightRows before, ColumnAllocator columns) {
        terms.cosines(rows, cosine);
        RowBits.selectState(before.state, rows.count, LightRows.LIT, lit);
        return before.with(LightRows.Column.COSINE, columnWriter.diffuseColumn(rows, cosine, lit, columns))
                .withFalloff(columnWriter.falloffColumn(rows, source, columns));
    }

    /** Updates an area light's layer. Any row that faces the light may have other samples in its cone. */
    private LightRows updateArea(HitRows rows, LightSource source, LightRows before, ConeChange cone, boolean falloff,
            ColumnAllocator columns) {
        if (cone == ConeChange.NONE && !(falloff && before.litCount > 0)) {
            return before;
        }
        rowsTouched += cone == ConeChange.NONE ? before.litCount : rows.count;
        return areaKernel().update(rows, source, before, cone != ConeChange.NONE, columns);
    }

    /**
     * Updates a layer after a geometry change. Casts shadow rays again only from tested rows whose ray may meet an added or removed
     * shape. Shares all other data with the old layer.
     *
     * @param light  source of the light that the layer was computed for
     */
    public LightRows updateShadows(HitRows rows, LightSource light, LightRows before, ShapeChange change, ColumnAllocator columns) {
        LightSource source = sampled(light);
        if (!canShadowsChange(rows, source, before, change)) {
            return before;
        }
        rowsTouched += RowBits.count(chosen, rows.count);
        if (source.isArea()) {
            return areaKernel().updateShadows(rows, source, before, chosen, columns);
        }
        ShadowCaster shadows = links.shadowCaster(source);
        if (shadows.findRetintedRows(rows, source, before.state, change, tintRows)) {
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                tintRows[b] &= ~chosen[b];
            }
            shadows.countRays(source, tintRows, rows.count);
        }
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(chosen, i) && before.state(i) == LightRows.OUTSIDE_CONE) {
                // The row is tested when the cone reaches it.
                state[i] = LightRows.OUTSIDE_CONE;
                RowBits.remove(chosen, i, i + 1);
            }
        }
        shadows.cast(rows, source, chosen, blocked);
        RowStates.applyShadowRays(state, rows.count, chosen, blocked);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            tintRows[b] |= chosen[b] & ~blocked[b];
        }
        float[][] tint = shadows.tintColumns(rows, source, tintRows, before.tint, columns);
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return TintTracer.areEqual(rows, tint, before.tint) ? before : before.withTint(tint);
        }
        aim(rows, source);
        terms.cosines(rows, cosine);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        return buildLayer(rows, source, state, lit, KnownTerms.of(before, rows.count, litBefore), columns).withTint(tint);
    }

    /** Returns whether {@link #updateShadows} would cast any shadow ray. */
    public boolean canShadowsChange(HitRows rows, LightSource light, LightLayer before, ShapeChange change) {
        LightSource source = sampled(light);
        if (before.isUnreached()) {
            return false;
        }
        ShadowCaster shadows = links.shadowCaster(source);
        if (source.isArea()) {
            return shadows.findChangedAreaRows(rows, source, before.states(), change, chosen);
        }
        boolean retinted = shadows.findRetintedRows(rows, source, before.states(), change, tintRows);
        return shadows.findChangedRows(rows, source, before.states(), change, chosen) || retinted;
    }

    /** Recomputes all terms of rows whose states are known. Casts no shadow ray. */
    public LightRows recomputeTerms(HitRows rows, LightSource light, LightLayer before, ColumnAllocator columns) {
        LightSource source = sampled(light);
        rowsTouched += before.litCount();
        if (source.isArea()) {
            return areaKernel().recomputeTerms(rows, source, before, columns);
        }
        if (before.litCount() == 0) {
            return LightRows.unlit(before.states()).withTint(before.tint());
        }
        aim(rows, source);
        terms.cosines(rows, cosine);
        RowBits.selectState(before.states(), rows.count, LightRows.LIT, lit);
        return buildLayer(rows, source, before.states(), lit, Optional.empty(), columns).withTint(before.tint());
    }

    /**
     * Updates a layer after an edit of materials. Recomputes specular terms of the changed materials without a ray. The columns
     * appear with the first and disappear with the last material that needs them. If a material is or was metallic, its diffuse
     * terms are recomputed too. A grazing column marks rows that were metallic and is therefore kept when rows are reordered.
     *
     * @param light  the light that the layer was computed for
     * @param changed materials whose shininess, roughness or model changed, or that gained or lost highlights
     */
    public LightRows updateSpeculars(HitRows rows, LightSource light, LightRows before, MaterialSet changed, ColumnAllocator columns) {
        LightSource source = sampled(light);
        if (before.litCount == 0 || !changed.intersects(rows)) {
            return before.grazing == null || needsGrazing(rows) ? before : before.with(LightRows.Column.GRAZING, null);
        }
        // Without specular terms there are no grazing terms, so no row says whether it was metallic.
        boolean metallic = isDiffuseOnly || before.grazing != null || columnWriter.hasMetallic(rows);
        if (!columnWriter.hasSpecular(rows) && !metallic) {
            return before.specular == null ? before : before.withoutSpecular();
        }
        if (source.isArea()) {
            rowsTouched += before.litCount;
            LightRows recomputed = areaKernel().recomputeTerms(rows, source, before, columns);
            return before.with(LightRows.Column.SPECULAR, recomputed.specular).with(LightRows.Column.GRAZING, recomputed.grazing)
                    .with(LightRows.Column.COSINE, metallic ? reuseIfEqual(rows, before.cosine, recomputed.cosine) : before.cosine)
                    .withFaceColors(metallic ? recomputed.face : before.face, recomputed.highlight);
        }
        RowBits.selectState(before.state, rows.count, LightRows.LIT, lit);
        System.arraycopy(lit, 0, litBefore, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runCount; r++) {
            if (changed.contains(rows.runMaterial[r])) {
                rowsTouched += columnWriter.isSpecular(rows.runMaterial[r]) ? RowBits.count(lit, rows.runStart(r), rows.runEnd[r]) : 0;
                RowBits.remove(litBefore, rows.runStart(r), rows.runEnd[r]);
            }
        }
        if (before.isPremultiplied()) {
            aim(rows, source);
        } else {
            terms.aim(rows, source);
        }
        TermColumnWriter.SpecularColumns column =
                columnWriter.specularColumns(rows, lit, before.specular == null ? null : litBefore,
                        TermColumnWriter.SpecularColumns.of(before), columns);
        LightRows updated = before.with(LightRows.Column.SPECULAR, column.specular()).with(LightRows.Column.GRAZING, column.grazing());
        if (before.isPremultiplied()) {
            return recomputePremultiplied(rows, source, updated, columns);
        }
        if (!metallic) {
            return updated;
        }
        terms.cosines(rows, cosine);
        return updated.with(LightRows.Column.COSINE,
                reuseIfEqual(rows, before.cosine, columnWriter.diffuseColumn(rows, cosine, lit, columns)));
    }

    /** Returns the old column if it has the same bits. */
    private static float[] reuseIfEqual(HitRows rows, float @Nullable [] before, float @Nullable [] updated) {
        assert before != null && updated != null;
        return Arrays.equals(before, 0, rows.count, updated, 0, rows.count) ? before : updated;
    }

    /** Returns the layer for reordered rows, some of which may be removed; {@code before} covers the old rows. */
    public LightRows reorder(RowSplice splice, LightRows before) {
        return splice(splice, before, null, null);
    }

    /**
     * Returns the layer for rows spliced from old and added ones.
     *
     * @param before layer of the old rows
     * @param added  layer of the added rows
     * @param light source of the light that both were computed for
     */
    public LightRows join(RowSplice splice, LightRows before, LightRows added, LightSource light) {
        LightSource source = sampled(light);
        return splice(splice, before, added, source);
    }

    /** @param added null if there are no added rows; then {@code source} is unread */
    private LightRows splice(RowSplice splice, LightRows before, @Nullable LightRows added, @Nullable LightSource source) {
        if (before.isUnreached() && (added == null || added.isUnreached())) {
            return LightRows.UNREACHED;
        }
        HitRows rows = splice.rows();
        // A layer without a term column has no lit row or no highlight, so 0 stands for its terms. A missing falloff column stands for
        // 1 in one layer and for no lit row in the other.
        Set<LightRows.Column> known = EnumSet.allOf(LightRows.Column.class);
        boolean haveFalloff = before.falloff != null && (added == null || added.falloff != null);
        boolean premultiplied = isPremultiplied(before) && (added == null || isPremultiplied(added));
        boolean mixed = !premultiplied && (before.isPremultiplied() || added != null && added.isPremultiplied());
        known.removeIf(kind -> kind == LightRows.Column.FALLOFF && (!haveFalloff || premultiplied)
                || kind == LightRows.Column.SPECULAR && !columnWriter.hasSpecular(rows)
                || kind == LightRows.Column.GRAZING && before.grazing == null && !needsGrazing(rows)
                || LightRows.Column.HIGHLIGHT_COLUMNS.contains(kind) && !columnWriter.hasSpecular(rows)
                || (LightRows.Column.COLOR_COLUMNS.stream().anyMatch(colors -> colors.contains(kind))
                        || LightRows.Column.SAMPLE_COLUMNS.contains(kind)) && !before.columns().has(kind)
                        && (added == null || !added.columns().has(kind)));
        ColumnSet<LightRows.Column> columns = ColumnSet.allocate(LightRows.Column.class, known, rows.count);
        splice.fill(columns, LightRows.withDefaultColors(before.columns()),
                added == null ? null : LightRows.withDefaultColors(added.columns()));
        byte[] state = (byte[]) columns.get(LightRows.Column.STATE);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return LightRows.unlit(state, LightRows.readVisibleSamples(columns, LightRows.Column.SAMPLE_COLUMNS))
                    .withTint(LightRows.readChannels(columns, LightRows.Column.TINT_COLUMNS));
        }
        if (mixed) {
            assert source != null;
            aim(rows, source);
            terms.cosines(rows, cosine);
            return buildLayer(rows, source, state, lit, Optional.empty(), ColumnAllocator.NEW_ARRAYS)
                    .withTint(LightRows.readChannels(columns, LightRows.Column.TINT_COLUMNS));
        }
        return premultiplied ? LightRows.premultiplied(columns, count)
                : haveFalloff || added == null ? LightRows.lit(columns, count)
                : LightRows.lit(columns, count).withFalloff(falloffs(rows, requireNonNull(source)));
    }

    /** Returns whether the terms of all lit rows include the falloff. */
    private static boolean isPremultiplied(LightRows layer) {
        return layer.isPremultiplied() || layer.litCount == 0;
    }

    /** Returns the falloff column; for a light without falloff, or if one of the spliced layers has no lit row and so no falloffs. */
    private float @Nullable [] falloffs(HitRows rows, LightSource source) {
        if (source.needsFalloffColumn()) {
            aim(rows, source);
        }
        return columnWriter.falloffColumn(rows, source, ColumnAllocator.NEW_ARRAYS);
    }

    /** Returns whether layers of the rows have grazing terms. */
    public boolean needsGrazing(HitRows rows) {
        return !isDiffuseOnly && columnWriter.hasMetallic(rows);
    }

    /** Returns whether any row's material has a highlight. */
    public boolean hasSpecular(HitRows rows) {
        return columnWriter.hasSpecular(rows);
    }

    /** Moves the rows of {@link #coneCandidates} into and out of the cone; keeps falloffs. Expects terms that were aimed. */
    private LightRows moveCone(HitRows rows, LightSource source, LightRows before, ColumnAllocator columns) {
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        terms.cosines(rows, cosine);
        terms.selectFacing(cosine, rows.count, facing);
        selectInside(rows, source, coneCandidates, inside);
        RowStates.moveCone(state, rows.count, coneCandidates, inside, facing, chosen);
        links.shadowCaster(source).cast(rows, source, chosen, blocked);
        RowStates.applyShadowRays(state, rows.count, chosen, blocked);
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return before;
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            tintRows[b] = chosen[b] & ~blocked[b];
        }
        float[][] tint = links.shadowCaster(source).tintColumns(rows, source, tintRows, before.tint, columns);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        return buildLayer(rows, source, state, lit, KnownTerms.of(before, rows.count, litBefore), columns).withTint(tint);
    }
}

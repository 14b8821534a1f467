package lightning.render.shading;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.column.ColumnSet;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.scene.effects.ViewEffects;

/**
 * The second stage for one tile: fills a light's layer over the hit rows, in full or in part. Holds
 * scratch memory: one for each thread.
 */
public final class LightKernel {
    private final LightLinks links;
    /** Made when a light larger than a point asks for it first. */
    private AreaLightKernel areaKernel;
    private final Tracer tracer;
    private final TermKernel terms;
    private final TermColumnWriter columnWriter;
    private final RequiredWork requiredWork;
    private final float[] cosine = new float[TermKernel.MAX_ROWS];
    private final int[] facing = RowBits.allocate();
    /** Rows that a change of the cone asks for, and those of them that are in it. */
    private final int[] coneCandidates = RowBits.allocate();
    private final int[] inside = RowBits.allocate();
    private final int[] chosen = RowBits.allocate();
    private final int[] blocked = RowBits.allocate();
    private final int[] lit = RowBits.allocate();
    private final int[] litBefore = RowBits.allocate();
    /** Rows of which it must be asked what passes of the light. */
    private final int[] tintRows = RowBits.allocate();
    private long rowsTouched;

    public LightKernel(Geometry geometry, Tracer tracer, TermKernel terms, ViewEffects view) {
        this.tracer = tracer;
        this.terms = terms;
        requiredWork = RequiredWork.of(view);
        links = new LightLinks(geometry, tracer, view);
        columnWriter = new TermColumnWriter(geometry.materials(), terms, requiredWork);
    }

    private AreaLightKernel areaKernel() {
        areaKernel = areaKernel == null ? new AreaLightKernel(links, tracer, terms, columnWriter, requiredWork) : areaKernel;
        return areaKernel;
    }

    /** What computes the terms. */
    public TermKernel terms() {
        return terms;
    }

    /** Shadow rays cast since the start. */
    public long shadowRays() {
        return links.shadowRays();
    }

    /** Rows of layers that were looked at or written since the start. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /** The light's whole diffuse and specular terms: the paper's worst case (§4.5). */
    public LightRows recompute(HitRows rows, LightSource source, ColumnAllocator columns) {
        if (source.isArea()) {
            rowsTouched += rows.count;
            return areaKernel().recompute(rows, source, columns);
        }
        if (!requiredWork.needsConeTest(source, rows, tracer) || !links.canReach(source, rows)) {
            return LightRows.UNREACHED;
        }
        aim(rows, source);
        terms.cosines(rows, cosine);
        int words = RowBits.words(rows.count);
        terms.selectFacing(cosine, rows.count, facing);
        selectInside(rows, source, facing, chosen);
        links.shadowCaster(source).cast(rows, source, chosen, blocked);
        for (int b = 0; b < words; b++) {
            lit[b] = chosen[b] & ~blocked[b];
        }
        rowsTouched += rows.count;
        float[][] tint = links.shadowCaster(source).tintColumns(rows, source, lit, null, columns);
        return buildLayer(rows, source, states(rows, columns), null, columns).withTint(tint);
    }

    /** Puts those of a set into another that are in the cone, and that the light shines on. */
    private void selectInside(HitRows rows, LightSource source, int[] candidates, int[] selected) {
        if (source.hasCone()) {
            terms.selectInside(candidates, rows.count, source.cosAngle(), selected);
        } else {
            System.arraycopy(candidates, 0, selected, 0, RowBits.words(rows.count));
        }
        links.retainLit(source, rows, selected);
    }

    /** The states of rows that were all asked, or away, or outside. */
    private byte[] states(HitRows rows, ColumnAllocator columns) {
        byte[] state = columns.states(rows.count);
        for (int b = 0, row = 0; row < rows.count; b++, row += RowBits.WIDTH) {
            int end = Math.min(rows.count, row + RowBits.WIDTH);
            int valid = RowBits.validBits(b, rows.count);
            if (lit[b] == valid) {
                Arrays.fill(state, row, end, (byte) (LightRows.LIT | LightRows.UNBLOCKED));
            } else if (facing[b] == 0) {
                Arrays.fill(state, row, end, LightRows.FACING_AWAY);
            } else {
                for (int i = row; i < end; i++) {
                    state[i] = state(facing[b] >>> i - row & 1, chosen[b] >>> i - row & 1, lit[b] >>> i - row & 1);
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

    /** A layer from its states and the rows in {@link #lit}; terms of rows lit before are taken over. */
    private LightRows buildLayer(HitRows rows, LightSource source, byte[] state, LightRows before, ColumnAllocator columns) {
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return LightRows.unlit(state);
        }
        int[] known = before == null || before.specular == null ? null : litBefore;
        float[] diffuse = columnWriter.diffuseColumn(rows, cosine, lit, columns);
        TermColumnWriter.SpecularColumns speculars =
                columnWriter.specularColumns(rows, lit, known, TermColumnWriter.SpecularColumns.of(before), columns);
        return new LightRows(state, diffuse, speculars.specular(), speculars.grazing(),
                before == null || before.isPremultiplied() ? columnWriter.falloffColumn(rows, source, columns) : before.falloff, count);
    }

    /**
     * The layer after an edit that leaves the light where it is; all it does not touch is shared with
     * the layer before.
     *
     * @param cone    which rows may enter or leave the cone
     * @param falloff whether the falloff changed
     */
    public LightRows update(HitRows rows, LightSource source, LightRows before, ConeChange cone, boolean falloff, ColumnAllocator columns) {
        if (before.state == LightRows.UNREACHED.state) {
            return cone.canChange(LightRows.OUTSIDE_CONE) ? recompute(rows, source, columns) : before;
        }
        if (source.isArea()) {
            return updateArea(rows, source, before, cone, falloff, columns);
        }
        int count = cone.findAffectedRows(before.state, rows.count, coneCandidates);
        if (count == 0 && !(falloff && before.litCount > 0)) {
            return before;
        }
        if (count > 0 || source.hasCone() || before.isPremultiplied()) {
            aim(rows, source);
        } else {
            terms.computeDistances(rows, source);
        }
        LightRows coneUpdated = count == 0 ? before : moveCone(rows, source, before, columns);
        // The falloff is written for lit rows; those of them that were looked at are counted already.
        rowsTouched += count + (falloff && !cone.canChange(LightRows.LIT) ? before.litCount : 0);
        if (coneUpdated.litCount == 0) {
            return coneUpdated;
        }
        if (coneUpdated.isPremultiplied()) {
            return falloff ? recomputePremultiplied(rows, source, coneUpdated, columns) : coneUpdated;
        }
        float[] falloffs = falloff && coneUpdated.falloff == before.falloff || coneUpdated.falloff == null
                ? columnWriter.falloffColumn(rows, source, columns)
                : coneUpdated.falloff;
        return coneUpdated.with(LightRows.Column.FALLOFF, falloffs);
    }

    /** A layer with cosines and falloffs anew, each in a column of its own; its other columns stay. Expects terms that were aimed. */
    private LightRows recomputePremultiplied(HitRows rows, LightSource source, LightRows before, ColumnAllocator columns) {
        terms.cosines(rows, cosine);
        RowBits.selectState(before.state, rows.count, LightRows.LIT, lit);
        return before.with(LightRows.Column.COSINE, columnWriter.diffuseColumn(rows, cosine, lit, columns))
                .with(LightRows.Column.FALLOFF, columnWriter.falloffColumn(rows, source, columns));
    }

    /** Whatever happens to the cone, every row that faces the light may have other samples in it. */
    private LightRows updateArea(HitRows rows, LightSource source, LightRows before, ConeChange cone, boolean falloff,
            ColumnAllocator columns) {
        if (cone == ConeChange.NONE && !(falloff && before.litCount > 0)) {
            return before;
        }
        rowsTouched += cone == ConeChange.NONE ? before.litCount : rows.count;
        return areaKernel().update(rows, source, before, cone != ConeChange.NONE, columns);
    }

    /**
     * The layer after other shapes: of the rows that were asked, those are asked again whose way to the light may meet what came
     * or what is gone. All else is shared with the layer before.
     *
     * @param source that of the light that the layer was computed for
     */
    public LightRows updateShadows(HitRows rows, LightSource source, LightRows before, ShapeChange change, ColumnAllocator columns) {
        if (!canShadowsChange(rows, source, before, change)) {
            return before;
        }
        rowsTouched += RowBits.count(chosen, rows.count);
        ShadowCaster shadows = links.shadowCaster(source);
        if (shadows.findRetintedRows(rows, source, before.state, change, tintRows)) {
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                tintRows[b] &= ~chosen[b];
            }
            shadows.countRays(tintRows, rows.count);
        }
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(chosen, i) && before.state(i) == LightRows.OUTSIDE_CONE) {
                // Nobody need know: it is asked when the cone reaches it.
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
        RowBits.selectState(before.state, rows.count, LightRows.LIT, litBefore);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        return buildLayer(rows, source, state, before.litCount == 0 ? null : before, columns).withTint(tint);
    }

    /** Whether {@link #updateShadows} would ask any row. */
    public boolean canShadowsChange(HitRows rows, LightSource source, LightLayer before, ShapeChange change) {
        if (before.states() == LightRows.UNREACHED.state) {
            return false;
        }
        ShadowCaster shadows = links.shadowCaster(source);
        boolean retinted = shadows.findRetintedRows(rows, source, before.states(), change, tintRows);
        return shadows.findChangedRows(rows, source, before.states(), change, chosen) || retinted;
    }

    /** All terms anew for rows whose states are known: no shadow ray is cast. */
    public LightRows recomputeTerms(HitRows rows, LightSource source, LightLayer before, ColumnAllocator columns) {
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
        return buildLayer(rows, source, before.states(), null, columns).withTint(before.tint());
    }

    /**
     * The layer after an edit of materials: of the rows of those that changed the specular terms anew, without a ray; the
     * columns come and go with the first and last material that has one. Where a material is metallic, or was, the diffuse term too:
     * that one was, a grazing column tells, which rows keep for this when they are put into another order.
     *
     * @param source    the light that the layer was computed for
     * @param changed materials whose shininess, roughness or model changed, or that got or lost their highlights
     */
    public LightRows updateSpeculars(HitRows rows, LightSource source, LightRows before, MaterialSet changed, ColumnAllocator columns) {
        if (before.litCount == 0 || !changed.intersects(rows)) {
            return before.grazing == null || columnWriter.hasMetallic(rows) ? before : before.with(LightRows.Column.GRAZING, null);
        }
        boolean metallic = before.grazing != null || columnWriter.hasMetallic(rows);
        if (!columnWriter.hasSpecular(rows) && !metallic) {
            return before.specular == null ? before : before.with(LightRows.Column.SPECULAR, null);
        }
        if (source.isArea()) {
            rowsTouched += before.litCount;
            LightRows recomputed = areaKernel().recomputeTerms(rows, source, before, columns);
            return before.with(LightRows.Column.SPECULAR, recomputed.specular).with(LightRows.Column.GRAZING, recomputed.grazing)
                    .with(LightRows.Column.COSINE, metallic ? reuseIfEqual(rows, before.cosine, recomputed.cosine) : before.cosine);
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

    /** The column of before where it has the same bits. */
    private static float[] reuseIfEqual(HitRows rows, float[] before, float[] updated) {
        return Arrays.equals(before, 0, rows.count, updated, 0, rows.count) ? before : updated;
    }

    /** The layer over rows of which some may be gone, in another order; {@code before} is over the old rows. */
    public LightRows reorder(RowSplice splice, LightRows before) {
        return splice(splice, before, null, null);
    }

    /**
     * The layer over rows that were put together of old ones and others.
     *
     * @param before over the old rows
     * @param added  over the added rows
     * @param source   that of the light that both were computed for
     */
    public LightRows join(RowSplice splice, LightRows before, LightRows added, LightSource source) {
        return splice(splice, before, added, source);
    }

    /** @param added null where there are no added rows; then {@code source} is unread */
    private LightRows splice(RowSplice splice, LightRows before, LightRows added, LightSource source) {
        if (before.state == LightRows.UNREACHED.state && (added == null || added.state == LightRows.UNREACHED.state)) {
            return LightRows.UNREACHED;
        }
        HitRows rows = splice.rows();
        // A layer that lacks terms has no lit row, or none with a highlight: 0 stands for them. A lack of falloffs tells less.
        Set<LightRows.Column> known = EnumSet.allOf(LightRows.Column.class);
        boolean haveFalloff = before.falloff != null && (added == null || added.falloff != null);
        boolean premultiplied = isPremultiplied(before) && (added == null || isPremultiplied(added));
        boolean mixed = !premultiplied && (before.isPremultiplied() || added != null && added.isPremultiplied());
        known.removeIf(kind -> kind == LightRows.Column.FALLOFF && (!haveFalloff || premultiplied)
                || kind == LightRows.Column.SPECULAR && !columnWriter.hasSpecular(rows)
                || kind == LightRows.Column.GRAZING && before.grazing == null && !columnWriter.hasMetallic(rows)
                || LightRows.Column.TINT_COLUMNS.contains(kind) && before.tint == null && (added == null || added.tint == null)
                || LightRows.Column.SAMPLE_COLUMNS.contains(kind) && !before.columns().has(kind)
                        && (added == null || !added.columns().has(kind)));
        ColumnSet<LightRows.Column> columns = ColumnSet.allocate(LightRows.Column.class, known, rows.count);
        splice.fill(columns, LightRows.withDefaultTint(before.columns(), LightRows.Column.TINT_COLUMNS),
                added == null ? null : LightRows.withDefaultTint(added.columns(), LightRows.Column.TINT_COLUMNS));
        byte[] state = (byte[]) columns.get(LightRows.Column.STATE);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return LightRows.unlit(state, LightRows.readVisibleSamples(columns, LightRows.Column.SAMPLE_COLUMNS))
                    .withTint(LightRows.readChannels(columns, LightRows.Column.TINT_COLUMNS));
        }
        if (mixed) {
            aim(rows, source);
            terms.cosines(rows, cosine);
            return buildLayer(rows, source, state, null, ColumnAllocator.NEW_ARRAYS)
                    .withTint(LightRows.readChannels(columns, LightRows.Column.TINT_COLUMNS));
        }
        return new LightRows(premultiplied ? columns.with(LightRows.Column.FALLOFF, LightRows.PREMULTIPLIED)
                : haveFalloff || added == null ? columns
                : columns.with(LightRows.Column.FALLOFF, falloffs(rows, source)), count);
    }

    /** Whether the terms of all lit rows have the falloff in them. */
    private static boolean isPremultiplied(LightRows layer) {
        return layer.isPremultiplied() || layer.litCount == 0;
    }

    /** For a light that does not fall off, or where one of the layers put together has no lit row and therefore no falloffs. */
    private float[] falloffs(HitRows rows, LightSource source) {
        if (source.needsFalloffColumn()) {
            aim(rows, source);
        }
        return columnWriter.falloffColumn(rows, source, ColumnAllocator.NEW_ARRAYS);
    }

    /** Whether any of the rows' materials is metallic. */
    public boolean hasMetallic(HitRows rows) {
        return columnWriter.hasMetallic(rows);
    }

    /** Whether any of the rows' materials has a highlight. */
    public boolean hasSpecular(HitRows rows) {
        return columnWriter.hasSpecular(rows);
    }

    /** Moves the rows of {@link #coneCandidates} into and out of the cone; falloffs are left as before. Expects terms that were aimed. */
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
        RowBits.selectState(before.state, rows.count, LightRows.LIT, litBefore);
        RowBits.selectState(state, rows.count, LightRows.LIT, lit);
        return buildLayer(rows, source, state, before, columns).withTint(tint);
    }
}

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
    private AreaKernel areas;
    private final Tracer tracer;
    private final Terms terms;
    private final TermColumns written;
    private final Demands demands;
    private final float[] cosine = new float[Terms.ROWS];
    private final int[] facing = RowBits.room();
    /** Rows that a change of the cone asks for, and those of them that are in it. */
    private final int[] looked = RowBits.room();
    private final int[] inside = RowBits.room();
    private final int[] chosen = RowBits.room();
    private final int[] blocked = RowBits.room();
    private final int[] lit = RowBits.room();
    private final int[] litBefore = RowBits.room();
    /** Rows of which it must be asked what passes of the light. */
    private final int[] tinted = RowBits.room();
    private long rowsTouched;

    public LightKernel(Geometry geometry, Tracer tracer, Terms terms, ViewEffects view) {
        this.tracer = tracer;
        this.terms = terms;
        demands = Demands.of(view);
        links = new LightLinks(geometry, tracer, view);
        written = new TermColumns(geometry.materials(), terms, demands);
    }

    private AreaKernel areas() {
        areas = areas == null ? new AreaKernel(links, tracer, terms, written, demands) : areas;
        return areas;
    }

    /** What computes the terms. */
    public Terms terms() {
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
    public LightRows full(HitRows rows, Lamp lamp, Columns columns) {
        if (lamp.isArea()) {
            rowsTouched += rows.count;
            return areas().full(rows, lamp, columns);
        }
        if (!demands.reaches(lamp, rows, tracer) || !links.reaches(lamp, rows)) {
            return LightRows.UNREACHED;
        }
        aim(rows, lamp);
        terms.cosines(rows, cosine);
        int words = RowBits.words(rows.count);
        terms.facing(cosine, rows.count, facing);
        keepInside(rows, lamp, facing, chosen);
        links.shadows(lamp).cast(rows, lamp, chosen, blocked);
        for (int b = 0; b < words; b++) {
            lit[b] = chosen[b] & ~blocked[b];
        }
        rowsTouched += rows.count;
        float[][] tint = links.shadows(lamp).tints(rows, lamp, lit, null, columns);
        return layer(rows, lamp, states(rows, columns), null, columns).withTint(tint);
    }

    /** Puts those of a set into another that are in the cone, and that the light shines on. */
    private void keepInside(HitRows rows, Lamp lamp, int[] among, int[] kept) {
        if (lamp.hasCone()) {
            terms.inside(among, rows.count, lamp.cosAngle(), kept);
        } else {
            System.arraycopy(among, 0, kept, 0, RowBits.words(rows.count));
        }
        links.keep(lamp, rows, kept);
    }

    /** The states of rows that were all asked, or away, or outside. */
    private byte[] states(HitRows rows, Columns columns) {
        byte[] state = columns.states(rows.count);
        for (int b = 0, row = 0; row < rows.count; b++, row += RowBits.WIDTH) {
            int end = Math.min(rows.count, row + RowBits.WIDTH);
            int valid = RowBits.valid(b, rows.count);
            if (lit[b] == valid) {
                Arrays.fill(state, row, end, (byte) (LightRows.LIT | LightRows.CLEAR));
            } else if (facing[b] == 0) {
                Arrays.fill(state, row, end, LightRows.AWAY);
            } else {
                for (int i = row; i < end; i++) {
                    state[i] = state(facing[b] >>> i - row & 1, chosen[b] >>> i - row & 1, lit[b] >>> i - row & 1);
                }
            }
        }
        return state;
    }

    private static byte state(int facing, int inside, int lit) {
        return (byte) (facing == 0 ? LightRows.AWAY
                : inside == 0 ? LightRows.OUTSIDE
                : lit == 0 ? LightRows.SHADOWED | LightRows.BLOCKED : LightRows.LIT | LightRows.CLEAR);
    }

    private void aim(HitRows rows, Lamp lamp) {
        terms.aim(rows, lamp);
        if (lamp.hasCone()) {
            terms.aimCone(rows, lamp);
        }
    }

    /** A layer from its states and the rows in {@link #lit}; terms of rows lit before are taken over. */
    private LightRows layer(HitRows rows, Lamp lamp, byte[] state, LightRows before, Columns columns) {
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return LightRows.unlit(state);
        }
        int[] known = before == null || before.specular == null ? null : litBefore;
        float[] diffuse = written.diffuses(rows, cosine, lit, columns);
        TermColumns.Speculars speculars = written.speculars(rows, lit, known, TermColumns.Speculars.of(before), columns);
        return new LightRows(state, diffuse, speculars.specular(), speculars.grazing(),
                before == null || before.isFaded() ? written.falloffs(rows, lamp, columns) : before.falloff, count);
    }

    /**
     * The layer after an edit that leaves the light where it is; all it does not touch is shared with
     * the layer before.
     *
     * @param cone    which rows may enter or leave the cone
     * @param falloff whether the falloff changed
     */
    public LightRows partial(HitRows rows, Lamp lamp, LightRows before, ConeChange cone, boolean falloff, Columns columns) {
        if (before.state == LightRows.UNREACHED.state) {
            return cone.looksAt(LightRows.OUTSIDE) ? full(rows, lamp, columns) : before;
        }
        if (lamp.isArea()) {
            return areaPartial(rows, lamp, before, cone, falloff, columns);
        }
        int count = cone.looksAt(before.state, rows.count, looked);
        if (count == 0 && !(falloff && before.lit > 0)) {
            return before;
        }
        if (count > 0 || lamp.hasCone() || before.isFaded()) {
            aim(rows, lamp);
        } else {
            terms.measure(rows, lamp);
        }
        LightRows moved = count == 0 ? before : moveCone(rows, lamp, before, columns);
        // The falloff is written for lit rows; those of them that were looked at are counted already.
        rowsTouched += count + (falloff && !cone.looksAt(LightRows.LIT) ? before.lit : 0);
        if (moved.lit == 0) {
            return moved;
        }
        if (moved.isFaded()) {
            return falloff ? whole(rows, lamp, moved, columns) : moved;
        }
        float[] falloffs = falloff && moved.falloff == before.falloff || moved.falloff == null ? written.falloffs(rows, lamp, columns)
                : moved.falloff;
        return moved.with(LightRows.Column.FALLOFF, falloffs);
    }

    /** A layer with cosines and falloffs anew, each in a column of its own; its other columns stay. Expects terms that were aimed. */
    private LightRows whole(HitRows rows, Lamp lamp, LightRows before, Columns columns) {
        terms.cosines(rows, cosine);
        RowBits.inState(before.state, rows.count, LightRows.LIT, lit);
        return before.with(LightRows.Column.COSINE, written.diffuses(rows, cosine, lit, columns))
                .with(LightRows.Column.FALLOFF, written.falloffs(rows, lamp, columns));
    }

    /** Whatever happens to the cone, every row that faces the light may have other samples in it. */
    private LightRows areaPartial(HitRows rows, Lamp lamp, LightRows before, ConeChange cone, boolean falloff, Columns columns) {
        if (cone == ConeChange.NONE && !(falloff && before.lit > 0)) {
            return before;
        }
        rowsTouched += cone == ConeChange.NONE ? before.lit : rows.count;
        return areas().partial(rows, lamp, before, cone != ConeChange.NONE, columns);
    }

    /**
     * The layer after other shapes: of the rows that were asked, those are asked again whose way to the light may meet what came
     * or what is gone. All else is shared with the layer before.
     *
     * @param lamp that of the light that the layer was computed for
     */
    public LightRows shadowed(HitRows rows, Lamp lamp, LightRows before, ShapeChange change, Columns columns) {
        if (!mayChange(rows, lamp, before, change)) {
            return before;
        }
        rowsTouched += RowBits.count(chosen, rows.count);
        ShadowCaster shadows = links.shadows(lamp);
        if (shadows.chooseTints(rows, lamp, before.state, change, tinted)) {
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                tinted[b] &= ~chosen[b];
            }
            shadows.count(tinted, rows.count);
        }
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(chosen, i) && before.state(i) == LightRows.OUTSIDE) {
                // Nobody need know: it is asked when the cone reaches it.
                state[i] = LightRows.OUTSIDE;
                RowBits.remove(chosen, i, i + 1);
            }
        }
        shadows.cast(rows, lamp, chosen, blocked);
        StateChange.settle(state, rows.count, chosen, blocked);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            tinted[b] |= chosen[b] & ~blocked[b];
        }
        float[][] tint = shadows.tints(rows, lamp, tinted, before.tint, columns);
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return TintCaster.areAlike(rows, tint, before.tint) ? before : before.withTint(tint);
        }
        aim(rows, lamp);
        terms.cosines(rows, cosine);
        RowBits.inState(before.state, rows.count, LightRows.LIT, litBefore);
        RowBits.inState(state, rows.count, LightRows.LIT, lit);
        return layer(rows, lamp, state, before.lit == 0 ? null : before, columns).withTint(tint);
    }

    /** Whether {@link #shadowed} would ask any row. */
    public boolean mayChange(HitRows rows, Lamp lamp, LightLayer before, ShapeChange change) {
        if (before.states() == LightRows.UNREACHED.state) {
            return false;
        }
        ShadowCaster shadows = links.shadows(lamp);
        boolean retinted = shadows.chooseTints(rows, lamp, before.states(), change, tinted);
        return shadows.choose(rows, lamp, before.states(), change, chosen) || retinted;
    }

    /** All terms anew for rows whose states are known: no shadow ray is cast. */
    public LightRows again(HitRows rows, Lamp lamp, LightLayer before, Columns columns) {
        rowsTouched += before.lit();
        if (lamp.isArea()) {
            return areas().again(rows, lamp, before, columns);
        }
        if (before.lit() == 0) {
            return LightRows.unlit(before.states()).withTint(before.tint());
        }
        aim(rows, lamp);
        terms.cosines(rows, cosine);
        RowBits.inState(before.states(), rows.count, LightRows.LIT, lit);
        return layer(rows, lamp, before.states(), null, columns).withTint(before.tint());
    }

    /**
     * The layer after an edit of materials: of the rows of those that changed the specular terms anew, without a ray; the
     * columns come and go with the first and last material that has one. Where a material is metallic, or was, the diffuse term too:
     * that one was, a grazing column tells, which rows keep for this when they are put into another order.
     *
     * @param lamp    the light that the layer was computed for
     * @param changed materials whose shininess, roughness or model changed, or that got or lost their highlights
     */
    public LightRows speculars(HitRows rows, Lamp lamp, LightRows before, MaterialSet changed, Columns columns) {
        if (before.lit == 0 || !changed.isIn(rows)) {
            return before.grazing == null || written.hasMetallic(rows) ? before : before.with(LightRows.Column.GRAZING, null);
        }
        boolean metallic = before.grazing != null || written.hasMetallic(rows);
        if (!written.hasSpecular(rows) && !metallic) {
            return before.specular == null ? before : before.with(LightRows.Column.SPECULAR, null);
        }
        if (lamp.isArea()) {
            rowsTouched += before.lit;
            LightRows again = areas().again(rows, lamp, before, columns);
            return before.with(LightRows.Column.SPECULAR, again.specular).with(LightRows.Column.GRAZING, again.grazing)
                    .with(LightRows.Column.COSINE, metallic ? same(rows, before.cosine, again.cosine) : before.cosine);
        }
        RowBits.inState(before.state, rows.count, LightRows.LIT, lit);
        System.arraycopy(lit, 0, litBefore, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runs; r++) {
            if (changed.contains(rows.runMaterial[r])) {
                rowsTouched += written.isSpecular(rows.runMaterial[r]) ? RowBits.count(lit, rows.runStart(r), rows.runEnd[r]) : 0;
                RowBits.remove(litBefore, rows.runStart(r), rows.runEnd[r]);
            }
        }
        if (before.isFaded()) {
            aim(rows, lamp);
        } else {
            terms.aim(rows, lamp);
        }
        TermColumns.Speculars column =
                written.speculars(rows, lit, before.specular == null ? null : litBefore, TermColumns.Speculars.of(before), columns);
        LightRows now = before.with(LightRows.Column.SPECULAR, column.specular()).with(LightRows.Column.GRAZING, column.grazing());
        if (before.isFaded()) {
            return whole(rows, lamp, now, columns);
        }
        if (!metallic) {
            return now;
        }
        terms.cosines(rows, cosine);
        return now.with(LightRows.Column.COSINE, same(rows, before.cosine, written.diffuses(rows, cosine, lit, columns)));
    }

    /** The column of before where it has the same bits. */
    private static float[] same(HitRows rows, float[] before, float[] now) {
        return Arrays.equals(before, 0, rows.count, now, 0, rows.count) ? before : now;
    }

    /** The layer over rows of which some may be gone, in another order; {@code before} is over the old rows. */
    public LightRows sorted(RowSplice splice, LightRows before) {
        return spliced(splice, before, null, null);
    }

    /**
     * The layer over rows that were put together of old ones and others.
     *
     * @param before over the old rows
     * @param added  over the added rows
     * @param lamp   that of the light that both were computed for
     */
    public LightRows joined(RowSplice splice, LightRows before, LightRows added, Lamp lamp) {
        return spliced(splice, before, added, lamp);
    }

    /** @param added null where there are no added rows; then {@code lamp} is unread */
    private LightRows spliced(RowSplice splice, LightRows before, LightRows added, Lamp lamp) {
        if (before.state == LightRows.UNREACHED.state && (added == null || added.state == LightRows.UNREACHED.state)) {
            return LightRows.UNREACHED;
        }
        HitRows rows = splice.rows();
        // A layer that lacks terms has no lit row, or none with a highlight: 0 stands for them. A lack of falloffs tells less.
        Set<LightRows.Column> known = EnumSet.allOf(LightRows.Column.class);
        boolean fades = before.falloff != null && (added == null || added.falloff != null);
        boolean faded = isFaded(before) && (added == null || isFaded(added));
        boolean mixed = !faded && (before.isFaded() || added != null && added.isFaded());
        known.removeIf(kind -> kind == LightRows.Column.FALLOFF && (!fades || faded)
                || kind == LightRows.Column.SPECULAR && !written.hasSpecular(rows)
                || kind == LightRows.Column.GRAZING && before.grazing == null && !written.hasMetallic(rows)
                || LightRows.Column.TINT.contains(kind) && before.tint == null && (added == null || added.tint == null)
                || LightRows.Column.SEEN.contains(kind) && !before.columns().has(kind) && (added == null || !added.columns().has(kind)));
        ColumnSet<LightRows.Column> columns = ColumnSet.room(LightRows.Column.class, known, rows.count);
        splice.fill(columns, LightRows.plainlyTinted(before.columns(), LightRows.Column.TINT),
                added == null ? null : LightRows.plainlyTinted(added.columns(), LightRows.Column.TINT));
        byte[] state = (byte[]) columns.get(LightRows.Column.STATE);
        RowBits.inState(state, rows.count, LightRows.LIT, lit);
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return LightRows.unlit(state, LightRows.seen(columns, LightRows.Column.SEEN))
                    .withTint(LightRows.colors(columns, LightRows.Column.TINT));
        }
        if (mixed) {
            aim(rows, lamp);
            terms.cosines(rows, cosine);
            return layer(rows, lamp, state, null, Columns.FRESH).withTint(LightRows.colors(columns, LightRows.Column.TINT));
        }
        return new LightRows(faded ? columns.with(LightRows.Column.FALLOFF, LightRows.FADED)
                : fades || added == null ? columns
                : columns.with(LightRows.Column.FALLOFF, falloffs(rows, lamp)), count);
    }

    /** Whether the terms of all lit rows have the falloff in them. */
    private static boolean isFaded(LightRows layer) {
        return layer.isFaded() || layer.lit == 0;
    }

    /** For a light that does not fall off, or where one of the layers put together has no lit row and therefore no falloffs. */
    private float[] falloffs(HitRows rows, Lamp lamp) {
        if (lamp.fallsOff()) {
            aim(rows, lamp);
        }
        return written.falloffs(rows, lamp, Columns.FRESH);
    }

    /** Whether any of the rows' materials is metallic. */
    public boolean hasMetallic(HitRows rows) {
        return written.hasMetallic(rows);
    }

    /** Whether any of the rows' materials has a highlight. */
    public boolean hasSpecular(HitRows rows) {
        return written.hasSpecular(rows);
    }

    /** Moves the rows of {@link #looked} into and out of the cone; falloffs are left as before. Expects terms that were aimed. */
    private LightRows moveCone(HitRows rows, Lamp lamp, LightRows before, Columns columns) {
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        terms.cosines(rows, cosine);
        terms.facing(cosine, rows.count, facing);
        keepInside(rows, lamp, looked, inside);
        StateChange.move(state, rows.count, looked, inside, facing, chosen);
        links.shadows(lamp).cast(rows, lamp, chosen, blocked);
        StateChange.settle(state, rows.count, chosen, blocked);
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return before;
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            tinted[b] = chosen[b] & ~blocked[b];
        }
        float[][] tint = links.shadows(lamp).tints(rows, lamp, tinted, before.tint, columns);
        RowBits.inState(before.state, rows.count, LightRows.LIT, litBefore);
        RowBits.inState(state, rows.count, LightRows.LIT, lit);
        return layer(rows, lamp, state, before, columns).withTint(tint);
    }
}

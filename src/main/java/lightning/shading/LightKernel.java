package lightning.shading;

import java.util.Arrays;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.MaterialSet;
import lightning.trace.PacketTracer;
import lightning.trace.RowSplice;

/**
 * The second stage for one tile: fills a light's layer over the hit rows, in full or in part. Holds
 * scratch memory: one for each thread.
 */
public final class LightKernel {
    private static final int WAY = LightRows.CLEAR | LightRows.BLOCKED;

    private final ShadowCaster shadows;
    private final LightLanes lanes = new LightLanes();
    private final TermColumns terms;
    private final float[] cosine = new float[LightLanes.ROWS];
    private final int[] facing = RowBits.room();
    private final int[] chosen = RowBits.room();
    private final int[] blocked = RowBits.room();
    private final int[] lit = RowBits.room();
    private final int[] litBefore = RowBits.room();
    /** Whether tiles are asked that a cone cannot reach. */
    private final boolean asksAll;
    private long rowsTouched;

    public LightKernel(Geometry geometry, PacketTracer tracer, ViewEffects view) {
        asksAll = view.forces(Effect.SPOT_CONE);
        shadows = new ShadowCaster(geometry, tracer, view);
        terms = new TermColumns(geometry.materials(), lanes, view);
    }

    /** Shadow rays cast since the start. */
    public long shadowRays() {
        return shadows.rays();
    }

    /** Rows of layers that were looked at or written since the start. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /** The light's whole diffuse and specular terms: the paper's worst case (§4.5). */
    public LightRows full(HitRows rows, Lamp lamp, Columns columns) {
        if (rows.count > 0 && lamp.type().hasCone() && !asksAll && !ConeReach.mayReach(lamp, rows.box())) {
            return LightRows.UNREACHED;
        }
        aim(rows, lamp);
        lanes.cosines(rows, cosine);
        boolean cone = lamp.type().hasCone();
        int words = RowBits.words(rows.count);
        for (int b = 0; b < words; b++) {
            facing[b] = lanes.facing(cosine, b) & RowBits.valid(b, rows.count);
            chosen[b] = cone && facing[b] != 0 ? facing[b] & lanes.inside(b, lamp.cosAngle()) : facing[b];
        }
        shadows.cast(rows, lamp, chosen, blocked);
        for (int b = 0; b < words; b++) {
            lit[b] = chosen[b] & ~blocked[b];
        }
        rowsTouched += rows.count;
        return layer(rows, lamp, states(rows, columns), null, columns);
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
        lanes.aim(rows, lamp);
        if (lamp.type().hasCone()) {
            lanes.axisCosines(rows, lamp);
        }
    }

    /** A layer from its states and the rows in {@link #lit}; terms of rows lit before are taken over. */
    private LightRows layer(HitRows rows, Lamp lamp, byte[] state, LightRows before, Columns columns) {
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return new LightRows(state, null, null, null, 0);
        }
        int[] known = before == null || before.specular == null ? null : litBefore;
        return new LightRows(state, terms.cosines(rows, cosine, lit, columns),
                terms.speculars(rows, lit, known, before == null ? null : before.specular, columns),
                before == null ? terms.falloffs(rows, lamp, columns) : before.falloff, count);
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
        int looked = looksAt(rows, before, cone);
        if (looked == 0 && !(falloff && before.lit > 0)) {
            return before;
        }
        aim(rows, lamp);
        LightRows moved = looked == 0 ? before : moveCone(rows, lamp, before, cone, columns);
        // The falloff is written for lit rows; those of them that were looked at are counted already.
        rowsTouched += looked + (falloff && !cone.looksAt(LightRows.LIT) ? before.lit : 0);
        if (moved.lit == 0) {
            return moved;
        }
        float[] falloffs = falloff || before.falloff == null ? terms.falloffs(rows, lamp, columns) : before.falloff;
        return new LightRows(moved.state, moved.cosine, moved.specular, falloffs, moved.lit);
    }

    /** All terms anew for rows whose states are known: no shadow ray is cast. */
    public LightRows again(HitRows rows, Lamp lamp, LightLayer before, Columns columns) {
        rowsTouched += before.lit();
        if (before.lit() == 0) {
            return new LightRows(before.states(), null, null, null, 0);
        }
        aim(rows, lamp);
        lanes.cosines(rows, cosine);
        RowBits.inState(before.states(), rows.count, LightRows.LIT, lit);
        return layer(rows, lamp, before.states(), null, columns);
    }

    /**
     * The layer after an edit of materials: of the rows of those that changed the specular term anew, without a ray; the
     * column comes and goes with the first and last material that has one.
     *
     * @param lamp    the light that the layer was computed for
     * @param changed materials whose shininess changed, or that got or lost their highlights
     */
    public LightRows speculars(HitRows rows, Lamp lamp, LightRows before, MaterialSet changed, Columns columns) {
        if (before.lit == 0 || !changed.isIn(rows)) {
            return before;
        }
        if (!terms.hasSpecular(rows)) {
            return before.specular == null ? before : new LightRows(before.state, before.cosine, null, before.falloff, before.lit);
        }
        RowBits.inState(before.state, rows.count, LightRows.LIT, lit);
        System.arraycopy(lit, 0, litBefore, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runs; r++) {
            if (changed.contains(rows.runMaterial[r])) {
                rowsTouched += terms.isSpecular(rows.runMaterial[r]) ? RowBits.count(lit, rows.runStart(r), rows.runEnd[r]) : 0;
                RowBits.remove(litBefore, rows.runStart(r), rows.runEnd[r]);
            }
        }
        lanes.aim(rows, lamp);
        float[] column = terms.speculars(rows, lit, before.specular == null ? null : litBefore, before.specular, columns);
        return new LightRows(before.state, before.cosine, column, before.falloff, before.lit);
    }

    /**
     * The layer over rows that were put together anew.
     *
     * @param before over the old rows
     * @param added  over the added rows; null where there are none
     * @param lamp   the light that both were computed for; unread where no rows were added
     */
    public LightRows spliced(RowSplice splice, LightRows before, LightRows added, Lamp lamp) {
        if (before.state == LightRows.UNREACHED.state && (added == null || added.state == LightRows.UNREACHED.state)) {
            return LightRows.UNREACHED;
        }
        HitRows rows = splice.rows();
        byte[] state = Columns.FRESH.states(rows.count);
        splice.copy(before.state, added == null ? null : added.state, state);
        RowBits.inState(state, rows.count, LightRows.LIT, lit);
        int count = RowBits.count(lit, rows.count);
        if (count == 0) {
            return new LightRows(state, null, null, null, 0);
        }
        float[] specular = terms.hasSpecular(rows) ? spliced(splice, before.specular, added == null ? null : added.specular) : null;
        return new LightRows(state, spliced(splice, before.cosine, added == null ? null : added.cosine), specular,
                falloffs(splice, before, added, lamp), count);
    }

    private float[] falloffs(RowSplice splice, LightRows before, LightRows added, Lamp lamp) {
        if (added == null) {
            return before.falloff == null ? null : spliced(splice, before.falloff, null);
        }
        if (before.falloff != null && added.falloff != null) {
            return spliced(splice, before.falloff, added.falloff);
        }
        // The light does not fall off, or one of the two has no lit row and therefore no falloffs.
        if (lamp.fallsOff()) {
            aim(splice.rows(), lamp);
        }
        return terms.falloffs(splice.rows(), lamp, Columns.FRESH);
    }

    private static float[] spliced(RowSplice splice, float[] before, float[] added) {
        float[] column = Columns.FRESH.floats(splice.rows().count);
        splice.copy(before, added, column);
        return column;
    }

    /** Whether any of the rows' materials has a highlight. */
    boolean hasSpecular(HitRows rows) {
        return terms.hasSpecular(rows);
    }

    private static int looksAt(HitRows rows, LightRows before, ConeChange cone) {
        int looked = 0;
        if (cone != ConeChange.NONE) {
            for (int i = 0; i < rows.count; i++) {
                looked += cone.looksAt(before.state(i)) ? 1 : 0;
            }
        }
        return looked;
    }

    /** Moves rows into and out of the cone; falloffs are left as before. Expects aimed lanes. */
    private LightRows moveCone(HitRows rows, Lamp lamp, LightRows before, ConeChange change, Columns columns) {
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        Arrays.fill(chosen, 0);
        lanes.cosines(rows, cosine);
        boolean cone = lamp.type().hasCone();
        for (int i = 0; i < rows.count; i++) {
            if (!change.looksAt(before.state(i))) {
                continue;
            }
            int way = before.state[i] & WAY;
            if (cone && !(lanes.axisCosine[i] >= lamp.cosAngle())) {
                state[i] = (byte) (LightRows.OUTSIDE | way);
            } else if (way == 0 && !(cosine[i] > 0)) {
                // It was among rows that the cone did not reach at all.
                state[i] = LightRows.AWAY;
            } else if (way == 0) {
                RowBits.add(chosen, i);
            } else {
                state[i] = (byte) (way | (way == LightRows.CLEAR ? LightRows.LIT : LightRows.SHADOWED));
            }
        }
        shadows.cast(rows, lamp, chosen, blocked);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(chosen, i)) {
                state[i] = state(1, 1, RowBits.contains(blocked, i) ? 0 : 1);
            }
        }
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return before;
        }
        RowBits.inState(before.state, rows.count, LightRows.LIT, litBefore);
        RowBits.inState(state, rows.count, LightRows.LIT, lit);
        return layer(rows, lamp, state, before, columns);
    }
}

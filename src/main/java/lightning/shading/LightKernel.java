package lightning.shading;

import java.util.Arrays;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.trace.PacketTracer;

/**
 * The second stage for one tile: fills a light's layer over the hit rows, in full or in part. Holds
 * scratch memory: one for each thread.
 */
public final class LightKernel {
    private static final int ROWS = LightLanes.ROWS;
    private static final int WAY = LightRows.CLEAR | LightRows.BLOCKED;

    private final MaterialTable materials;
    private final ShadowCaster shadows;
    private final LightLanes lanes = new LightLanes();
    private final float[] cosine = new float[ROWS];
    private final float[] specular = new float[ROWS];
    private long rowsTouched;

    public LightKernel(Geometry geometry, PacketTracer tracer) {
        materials = geometry.materials();
        shadows = new ShadowCaster(geometry, tracer);
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
        byte[] state = columns.states(rows.count);
        lanes.aim(rows, lamp);
        lanes.cosines(rows, cosine);
        boolean cone = lamp.type().hasCone();
        if (cone) {
            lanes.axisCosines(rows, lamp);
        }
        for (int i = 0; i < rows.count; i++) {
            if (!(cosine[i] > 0)) {
                state[i] = LightRows.AWAY;
            } else if (cone && !(lanes.axisCosine[i] >= lamp.cosAngle())) {
                state[i] = LightRows.OUTSIDE;
            } else {
                shadows.choose(i);
            }
        }
        int lit = shadows.cast(rows, lamp, state);
        rowsTouched += rows.count;
        if (lit == 0) {
            return new LightRows(state, null, null, null, 0);
        }
        return new LightRows(state, cosines(rows, state, columns), speculars(rows, state, null, columns),
                falloffs(rows, lamp, columns), lit);
    }

    /**
     * The layer after an edit that leaves the light where it is; all it does not touch is shared with
     * the layer before.
     *
     * @param cone    which rows may enter or leave the cone
     * @param falloff whether the falloff changed
     */
    public LightRows partial(HitRows rows, Lamp lamp, LightRows before, ConeChange cone, boolean falloff, Columns columns) {
        int looked = looksAt(rows, before, cone);
        if (looked == 0 && !(falloff && before.lit > 0)) {
            return before;
        }
        lanes.aim(rows, lamp);
        if (lamp.type().hasCone()) {
            lanes.axisCosines(rows, lamp);
        }
        LightRows moved = looked == 0 ? before : moveCone(rows, lamp, before, cone, columns);
        // The falloff is written for lit rows; those of them that were looked at are counted already.
        rowsTouched += looked + (falloff && !cone.looksAt(LightRows.LIT) ? before.lit : 0);
        if (moved.lit == 0) {
            return moved;
        }
        float[] falloffs = falloff || before.falloff == null ? falloffs(rows, lamp, columns) : before.falloff;
        return new LightRows(moved.state, moved.cosine, moved.specular, falloffs, moved.lit);
    }

    /** All terms anew for rows whose states are known: no shadow ray is cast. */
    LightRows again(HitRows rows, Lamp lamp, LightLayer before, Columns columns) {
        rowsTouched += before.lit();
        if (before.lit() == 0) {
            return new LightRows(before.states(), null, null, null, 0);
        }
        lanes.aim(rows, lamp);
        if (lamp.type().hasCone()) {
            lanes.axisCosines(rows, lamp);
        }
        lanes.cosines(rows, cosine);
        return new LightRows(before.states(), cosines(rows, before.states(), columns),
                speculars(rows, before.states(), null, columns), falloffs(rows, lamp, columns), before.lit());
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
        boolean cone = lamp.type().hasCone();
        int lit = before.lit;
        for (int i = 0; i < rows.count; i++) {
            int old = before.state(i);
            if (!change.looksAt(old)) {
                continue;
            }
            lit -= old == LightRows.LIT ? 1 : 0;
            int way = before.state[i] & WAY;
            if (cone && !(lanes.axisCosine[i] >= lamp.cosAngle())) {
                state[i] = (byte) (LightRows.OUTSIDE | way);
            } else if (way == 0) {
                shadows.choose(i);
            } else {
                state[i] = (byte) (way | (way == LightRows.CLEAR ? LightRows.LIT : LightRows.SHADOWED));
                lit += way == LightRows.CLEAR ? 1 : 0;
            }
        }
        lit += shadows.cast(rows, lamp, state);
        if (lit == 0) {
            return new LightRows(state, null, null, null, 0);
        }
        if (Arrays.equals(state, 0, rows.count, before.state, 0, rows.count)) {
            return before;
        }
        lanes.cosines(rows, cosine);
        return new LightRows(state, cosines(rows, state, columns), speculars(rows, state, before, columns),
                before.falloff, lit);
    }

    private static boolean isLit(byte[] state, int row) {
        return (state[row] & LightRows.STATE) == LightRows.LIT;
    }

    /** The cosine of lit rows, 0 for others. */
    private float[] cosines(HitRows rows, byte[] state, Columns columns) {
        float[] column = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            column[i] = isLit(state, i) ? cosine[i] : 0;
        }
        return column;
    }

    /** The specular term of lit rows, 0 for others; computed only where a row was not lit before. */
    private float[] speculars(HitRows rows, byte[] state, LightRows before, Columns columns) {
        if (!hasSpecular(rows)) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        for (int r = 0; r < rows.runs; r++) {
            int from = rows.runStart(r);
            int to = rows.runEnd[r];
            if (!materials.isSpecular(rows.runMaterial[r])) {
                Arrays.fill(column, from, to, 0);
                continue;
            }
            boolean hasOld = before != null && before.specular != null;
            int first = to;
            int last = from;
            for (int i = from; i < to; i++) {
                boolean lit = isLit(state, i);
                boolean known = hasOld && before.state(i) == LightRows.LIT;
                column[i] = lit && known ? before.specular[i] : 0;
                if (lit && !known) {
                    first = Math.min(first, i);
                    last = i + 1;
                }
            }
            if (first < last) {
                lanes.speculars(rows, first, last, materials.shininess(rows.runMaterial[r]), specular);
                for (int i = first; i < last; i++) {
                    column[i] = isLit(state, i) ? specular[i] : 0;
                }
            }
        }
        return column;
    }

    private boolean hasSpecular(HitRows rows) {
        for (int r = 0; r < rows.runs; r++) {
            if (materials.isSpecular(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    /** The falloff of all rows, or null where it is 1 everywhere. Expects aimed lanes. */
    private float[] falloffs(HitRows rows, Lamp lamp, Columns columns) {
        if (!lamp.fallsOff()) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        lanes.falloffs(rows, lamp, column);
        return column;
    }
}

package lightning.shading;

import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.trace.PacketTracer;
import lightning.trace.RayPacket;

/**
 * The second stage for one tile: fills a light's layer over the hit rows, in full or in part. Holds
 * scratch memory: one for each thread.
 */
public final class LightKernel {
    private static final int ROWS = LightLanes.ROWS;

    private final MaterialTable materials;
    private final PacketTracer tracer;
    private final LightLanes lanes = new LightLanes();
    private final RayPacket packet = new RayPacket();
    private final float[] cosine = new float[ROWS];
    private final int[] candidates = new int[ROWS];
    private long shadowRays;
    private long rowsWritten;

    public LightKernel(MaterialTable materials, PacketTracer tracer) {
        this.materials = materials;
        this.tracer = tracer;
    }

    /** Shadow rays cast since the start. */
    public long shadowRays() {
        return shadowRays;
    }

    /** Rows of layers written since the start. */
    public long rowsWritten() {
        return rowsWritten;
    }

    /**
     * The light's whole diffuse and specular terms: the paper's worst case.
     *
     * @param before the layer before, whose knowledge of free ways still holds; null if none does
     * @param columns gives the columns to write
     */
    public LightRows full(HitRows rows, Lamp lamp, LightRows before, Columns columns) {
        byte[] state = columns.states(rows.count);
        lanes.aim(rows, lamp);
        lanes.cosines(rows, cosine);
        boolean cone = lamp.type().hasCone();
        if (cone) {
            lanes.axisCosines(rows, lamp);
        }
        int unknown = 0;
        int lit = 0;
        for (int i = 0; i < rows.count; i++) {
            int way = before == null ? 0 : before.state[i] & (LightRows.CLEAR | LightRows.BLOCKED);
            if (!(cosine[i] > 0)) {
                state[i] = (byte) (LightRows.AWAY | way);
            } else if (cone && !(lanes.axisCosine[i] >= lamp.cosAngle())) {
                state[i] = (byte) (LightRows.OUTSIDE | way);
            } else if (way == 0) {
                candidates[unknown++] = i;
            } else {
                state[i] = (byte) (way | (way == LightRows.CLEAR ? LightRows.LIT : LightRows.SHADOWED));
                lit += way == LightRows.CLEAR ? 1 : 0;
            }
        }
        lit += castShadows(rows, lamp, unknown, state);
        rowsWritten += rows.count;
        return fill(rows, lamp, state, lit, columns);
    }

    /** Writes all columns of a tile whose states are known and whose rows have been aimed at. */
    private LightRows fill(HitRows rows, Lamp lamp, byte[] state, int lit, Columns columns) {
        if (lit == 0) {
            return new LightRows(state, null, null, null, 0);
        }
        float[] cosines = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            cosines[i] = (state[i] & LightRows.STATE) == LightRows.LIT ? cosine[i] : 0;
        }
        float[] speculars = hasSpecular(rows) ? columns.floats(rows.count) : null;
        if (speculars != null) {
            fillSpecular(rows, state, speculars);
        }
        float[] falloffs = null;
        if (lamp.fallsOff()) {
            falloffs = columns.floats(rows.count);
            lanes.falloffs(rows, lamp, falloffs);
        }
        return new LightRows(state, cosines, speculars, falloffs, lit);
    }

    private void fillSpecular(HitRows rows, byte[] state, float[] to) {
        for (int r = 0; r < rows.runs; r++) {
            int start = rows.runStart(r);
            int end = rows.runEnd[r];
            if (materials.isSpecular(rows.runMaterial[r])) {
                lanes.speculars(rows, start, end, materials.shininess(rows.runMaterial[r]), to);
                for (int i = start; i < end; i++) {
                    if ((state[i] & LightRows.STATE) != LightRows.LIT) {
                        to[i] = 0;
                    }
                }
            } else {
                java.util.Arrays.fill(to, start, end, 0);
            }
        }
    }

    private boolean hasSpecular(HitRows rows) {
        for (int r = 0; r < rows.runs; r++) {
            if (materials.isSpecular(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    /**
     * Casts the shadow rays of the first {@code count} candidates and writes their state and way.
     *
     * @return how many of them are lit
     */
    private int castShadows(HitRows rows, Lamp lamp, int count, byte[] state) {
        boolean positional = lamp.type().hasPosition();
        double x = lamp.source().x();
        double y = lamp.source().y();
        double z = lamp.source().z();
        int lit = 0;
        for (int at = 0; at < count; at += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, count - at);
            for (int i = 0; i < live; i++) {
                int row = candidates[at + i];
                packet.ox[i] = rows.px[row];
                packet.oy[i] = rows.py[row];
                packet.oz[i] = rows.pz[row];
                packet.dx[i] = positional ? x - rows.px[row] : x;
                packet.dy[i] = positional ? y - rows.py[row] : y;
                packet.dz[i] = positional ? z - rows.pz[row] : z;
                packet.limit[i] = positional ? 1 : Double.POSITIVE_INFINITY;
            }
            int blocked = tracer.blocked(packet, live);
            for (int i = 0; i < live; i++) {
                boolean dark = (blocked >>> i & 1) != 0;
                state[candidates[at + i]] =
                        (byte) (dark ? LightRows.SHADOWED | LightRows.BLOCKED : LightRows.LIT | LightRows.CLEAR);
                lit += dark ? 0 : 1;
            }
        }
        shadowRays += count;
        return lit;
    }
}

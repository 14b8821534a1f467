package lightning.shading;

import lightning.trace.Beam;
import lightning.trace.Candidates;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.PacketTracer;
import lightning.trace.RayPacket;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    private final Geometry geometry;
    private final PacketTracer tracer;
    private final Beam beam = new Beam();
    private final Candidates blockers = new Candidates();
    private final RayPacket packet = new RayPacket();
    private final int[] chosen = new int[LightLanes.ROWS];
    private int count;
    private long rays;

    ShadowCaster(Geometry geometry, PacketTracer tracer) {
        this.geometry = geometry;
        this.tracer = tracer;
    }

    /** Chooses a row for the next cast. */
    void choose(int row) {
        chosen[count++] = row;
    }

    /** Rays cast since the start. */
    long rays() {
        return rays;
    }

    /**
     * Casts a ray for each chosen row, writes its state and way, and forgets the choice.
     *
     * @return how many of the rows are lit
     */
    int cast(HitRows rows, Lamp lamp, byte[] state) {
        if (count == 0) {
            return 0;
        }
        aim(rows, lamp);
        int lit = 0;
        for (int at = 0; at < count; at += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, count - at);
            load(rows, lamp, at, live);
            int blocked = tracer.blocked(packet, live, blockers);
            for (int i = 0; i < live; i++) {
                boolean dark = (blocked >>> i & 1) != 0;
                state[chosen[at + i]] =
                        (byte) (dark ? LightRows.SHADOWED | LightRows.BLOCKED : LightRows.LIT | LightRows.CLEAR);
                lit += dark ? 0 : 1;
            }
        }
        rays += count;
        count = 0;
        return lit;
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private void aim(HitRows rows, Lamp lamp) {
        beam.clear();
        beam.origins(rows.px, rows.py, rows.pz, rows.count);
        if (lamp.type().hasPosition()) {
            beam.towards(lamp.source());
        } else {
            beam.along(lamp.source());
        }
        blockers.collect(geometry, beam);
    }

    /** The ray to a position ends there, at distance 1; the ray to a directional light never ends. */
    private void load(HitRows rows, Lamp lamp, int at, int live) {
        boolean positional = lamp.type().hasPosition();
        double x = lamp.source().x();
        double y = lamp.source().y();
        double z = lamp.source().z();
        for (int i = 0; i < live; i++) {
            int row = chosen[at + i];
            packet.ox[i] = rows.px[row];
            packet.oy[i] = rows.py[row];
            packet.oz[i] = rows.pz[row];
            packet.dx[i] = positional ? x - rows.px[row] : x;
            packet.dy[i] = positional ? y - rows.py[row] : y;
            packet.dz[i] = positional ? z - rows.pz[row] : z;
            packet.limit[i] = positional ? 1 : Double.POSITIVE_INFINITY;
        }
    }
}

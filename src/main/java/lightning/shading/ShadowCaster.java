package lightning.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import jdk.incubator.vector.DoubleVector;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.math.Vec3;
import lightning.trace.Beam;
import lightning.trace.Candidates;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.PacketTracer;
import lightning.trace.RayPacket;
import lightning.trace.WayEnd;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    private final Geometry geometry;
    private final PacketTracer tracer;
    private final Beam beam = new Beam();
    private final Candidates blockers = new Candidates();
    private final RayPacket packet = new RayPacket();
    /** Where the ways to lights end that rays were cast to. */
    private final Map<Vec3, WayEnd> ends = new HashMap<>();
    private final boolean casts;
    private final boolean forced;
    private long rays;

    /** @param view whether any shape blocks a light, else all ways are free; and whether rays are cast that cannot meet one */
    ShadowCaster(Geometry geometry, PacketTracer tracer, ViewEffects view) {
        casts = view.shows(Effect.SHADOWS);
        forced = view.forces(Effect.SHADOWS);
        this.geometry = geometry;
        this.tracer = tracer;
    }

    /** Rays cast since the start. */
    long rays() {
        return rays;
    }

    /**
     * Casts a ray from each chosen row.
     *
     * @param chosen  rows to ask, as {@link RowBits}
     * @param blocked gets those of them from which the light is not seen
     */
    void cast(HitRows rows, Lamp lamp, int[] chosen, int[] blocked) {
        if (!casts) {
            Arrays.fill(blocked, 0);
            return;
        }
        int count = RowBits.count(chosen, rows.count);
        rays += count;
        if (count > 0) {
            aim(rows, lamp);
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            blocked[b] = 0;
            if (chosen[b] != 0 && (forced || !blockers.isEmpty())) {
                load(rows, lamp, b * RayPacket.WIDTH, chosen[b]);
                blocked[b] = tracer.blocked(packet, RayPacket.WIDTH, blockers) & chosen[b];
            }
        }
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private void aim(HitRows rows, Lamp lamp) {
        beam.clear();
        beam.origins(rows.box());
        if (lamp.type().hasPosition()) {
            beam.towards(lamp.source());
            packet.end = ends.computeIfAbsent(lamp.source(), geometry::end);
        } else {
            beam.along(lamp.source());
            packet.end = WayEnd.OPEN;
        }
        blockers.collect(geometry, beam);
    }

    /**
     * The ray to a position ends there, at distance 1; the ray to a directional light never ends. Rows
     * that were not chosen get a ray that ends before it begins.
     */
    private void load(HitRows rows, Lamp lamp, int row, int chosen) {
        boolean positional = lamp.type().hasPosition();
        axis(rows.px, row, lamp.source().x(), positional, packet.ox, packet.dx);
        axis(rows.py, row, lamp.source().y(), positional, packet.oy, packet.dy);
        axis(rows.pz, row, lamp.source().z(), positional, packet.oz, packet.dz);
        double limit = positional ? 1 : Double.POSITIVE_INFINITY;
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            packet.limit[i] = (chosen >>> i & 1) != 0 ? limit : -1;
        }
    }

    private static void axis(float[] points, int row, double source, boolean positional, double[] origin, double[] direction) {
        for (int i = 0; i < RayPacket.WIDTH; i += LightLanes.LANES) {
            DoubleVector o = LightLanes.load(points, row + i);
            DoubleVector s = DoubleVector.broadcast(LightLanes.D, source);
            o.intoArray(origin, i);
            (positional ? s.sub(o) : s).intoArray(direction, i);
        }
    }
}

package lightning.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.math.Vec3;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.Tracer;
import lightning.trace.Ways;
import lightning.trace.tree.Beam;
import lightning.trace.tree.Candidates;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    private final Geometry geometry;
    private final Tracer tracer;
    private final Demands demands;
    private final Beam beam = new Beam();
    private final Candidates blockers = new Candidates();
    /** Where the ways to lights lead that rays were cast to. */
    private final Map<Vec3, Ways> ways = new HashMap<>();
    private final boolean casts;
    private long rays;

    /** @param view whether any shape blocks a light, else all ways are free */
    ShadowCaster(Geometry geometry, Tracer tracer, ViewEffects view) {
        casts = view.shows(Effect.SHADOWS);
        demands = Demands.of(view);
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
        if (count == 0) {
            Arrays.fill(blocked, 0);
            return;
        }
        Ways way = aim(rows, lamp);
        if (demands.meets(blockers)) {
            tracer.blocked(rows, chosen, way, blockers, blocked);
        } else {
            Arrays.fill(blocked, 0);
        }
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private Ways aim(HitRows rows, Lamp lamp) {
        beam.clear();
        beam.origins(rows.box(tracer));
        Ways way;
        if (lamp.type().hasPosition()) {
            beam.towards(lamp.source());
            way = ways.computeIfAbsent(lamp.source(), point -> Ways.to(geometry.end(point)));
        } else {
            beam.along(lamp.source());
            way = Ways.along(lamp.source());
        }
        blockers.collect(geometry.bvh(), beam);
        return way;
    }
}

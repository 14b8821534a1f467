package lightning.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.math.Vec3;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.ShapeChange;
import lightning.trace.Tracer;
import lightning.trace.Ways;
import lightning.trace.tree.Beam;
import lightning.trace.tree.BoxRay;
import lightning.trace.tree.BoxSet;
import lightning.trace.tree.Candidates;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    private final Geometry geometry;
    private final Tracer tracer;
    private final Demands demands;
    private final Beam beam = new Beam();
    private final BoxRay ray = new BoxRay();
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

    /**
     * Chooses rows whose way to a light other shapes may block or free.
     *
     * <p>What blocks a row that no way of which meets anything that is gone, is still there; and where a way was free, only what
     * came can block it. {@link ShapeChange#keepsEnd} must hold for a light at a point.
     *
     * @param state  whether the rows' ways are blocked, as {@link LightRows} has it; those that nobody asked are not chosen
     * @param chosen gets the rows, as {@link RowBits}
     * @return whether there are any
     */
    boolean choose(HitRows rows, Lamp lamp, byte[] state, ShapeChange change, int[] chosen) {
        if (rows.count == 0) {
            return false;
        }
        Ways way = bound(rows, lamp);
        boolean gone = casts && change.gone().touches(beam);
        boolean come = casts && change.come().touches(beam);
        Arrays.fill(chosen, 0);
        boolean any = false;
        for (int i = 0; (gone || come) && i < rows.count; i++) {
            boolean asked = gone && (state[i] & LightRows.BLOCKED) != 0 && touches(rows, i, way, change.gone())
                    || come && (state[i] & LightRows.CLEAR) != 0 && touches(rows, i, way, change.come());
            if (asked) {
                RowBits.add(chosen, i);
                any = true;
            }
        }
        return any;
    }

    private boolean touches(HitRows rows, int i, Ways way, BoxSet boxes) {
        Vec3 to = way.source();
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        if (way.ends()) {
            ray.enter(x, y, z, to.x() - x, to.y() - y, to.z() - z);
        } else {
            ray.enter(x, y, z, to.x(), to.y(), to.z());
        }
        return boxes.touches(ray, way.ends() ? 1 : Double.POSITIVE_INFINITY);
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private Ways aim(HitRows rows, Lamp lamp) {
        Ways way = bound(rows, lamp);
        blockers.collect(geometry.bvh(), beam);
        return way;
    }

    /** Makes the beam of the ways from all rows of the tile to the light. */
    private Ways bound(HitRows rows, Lamp lamp) {
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
        return way;
    }
}

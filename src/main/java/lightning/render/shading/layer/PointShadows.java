package lightning.render.shading.layer;

import java.util.Map;
import lightning.render.shading.LightSource;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.Tracer;
import lightning.scene.effects.ViewEffects;

/** Casts shadow rays from points in space. Holds scratch memory: use one instance per thread. */
public final class PointShadows {
    private final LightLinks links;
    private final HitRows points = new HitRows(Tracer.ROWS_PER_WORD * RowBits.allocate().length, TexelColumns.NONE);

    public PointShadows(Geometry geometry, Tracer tracer, ViewEffects view) {
        links = new LightLinks(geometry, tracer, view);
    }

    /** Returns the points, to be set by the caller: px, py, pz and count, at most 1024. */
    public HitRows points() {
        return points;
    }

    /**
     * Finds the points from which a light is blocked.
     *
     * @param source  a light without an area, or one sample of an area light
     * @param chosen  points to test, as {@link RowBits}
     * @param blocked receives those of them from which the light is not visible
     */
    public void cast(LightSource source, int[] chosen, int[] blocked) {
        links.shadowCaster(source).cast(points, source, chosen, blocked);
    }

    /**
     * Chooses points whose result a change of shapes may change.
     *
     * @param state  {@link LightRows#BLOCKED} or {@link LightRows#UNBLOCKED} of each point
     * @param chosen receives the points, as {@link RowBits}
     * @return whether any point is chosen
     */
    public boolean findChanged(LightSource source, byte[] state, ShapeChange change, int[] chosen) {
        return links.shadowCaster(source).findChangedRows(points, source, state, change, chosen);
    }

    /** Returns the number of shadow rays of each light since the start, by its name. */
    public Map<String, Long> rayCount() {
        return links.shadowRays();
    }
}

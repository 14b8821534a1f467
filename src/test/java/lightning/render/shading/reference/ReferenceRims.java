package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.rim.RimAim;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;

/** Finds the directions in which gather points cast additional rays, for {@link ReferenceTracer}: the oracle of {@link RimAim}'s users. */
final class ReferenceRims {
    private final CellKeys keys;
    private final List<Source> sources = new ArrayList<>();

    /** Point whose rays tell where the rims of openings are. */
    private record Source(long wideKey, List<ReferenceGatherRay> rays) {}

    ReferenceRims(CellKeys keys) {
        this.keys = keys;
    }

    /** Adds the rays of a gather point. */
    void add(SurfacePoint at, List<ReferenceGatherRay> rays) {
        sources.add(new Source(wideKey(at), rays));
    }

    private long wideKey(SurfacePoint at) {
        return keys.wideKey(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
    }

    /** Casts the additional rays of a point that was added; returns them by the number of its own ray that they accompany. */
    Map<Integer, List<ReferenceGatherRay>> cast(ReferenceGatherPoints.GatherPoint point, Geometry geometry, GlowShapes glows,
            DirectionTable directions) {
        List<Source> others =
                sources.stream().filter(source -> source.rays != point.rays() && source.wideKey == wideKey(point.at())).toList();
        Map<Integer, List<ReferenceGatherRay>> added = new TreeMap<>();
        for (int k = 0; k < directions.rays(); k++) {
            int cell = k;
            long misses = others.stream().filter(source -> source.rays.get(cell).isMiss()).count();
            if (misses > 0 && misses < others.size()) {
                added.put(cell, new ArrayList<>());
            }
        }
        int count = RimAim.raysPerCell(added.size(), directions.rays());
        if (count == 1) {
            return Map.of();
        }
        for (int ray = 1; ray < count; ray++) {
            List<ReferenceGatherRay> turned =
                    ReferenceGatherRay.cast(geometry, keys, glows, directions, point.seed(), RimAim.turn(ray), point.at());
            added.forEach((cell, rays) -> rays.add(turned.get(cell)));
        }
        return added;
    }
}

package lightning.render.gather;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import lightning.render.image.Film;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;

/**
 * Traces the surfaces that a picture shows, through some pixels of each tile: those seen directly, and those seen in mirrors and through
 * transparent surfaces. Gather points are chosen among them. Use one instance per thread.
 */
final class CandidateTracer {
    private final TileVisibility visibility;
    private final int depth;
    private final BitSet selected = new BitSet();
    private long rays;

    /** @param step distance of the pixels */
    CandidateTracer(Geometry geometry, Scene scene, Tracer tracer, int step) {
        visibility = new TileVisibility(geometry, scene, tracer);
        depth = scene.picture().depth();
        for (int y = 0; y < Film.TILE_SIZE; y += step) {
            for (int x = 0; x < Film.TILE_SIZE; x += step) {
                selected.set(y * Film.TILE_SIZE + x);
            }
        }
    }

    /** Returns the number of rays cast so far. */
    long rayCount() {
        return rays;
    }

    /** Traces a tile whose upper left pixel is {@code x0, y0}; returns its levels in preorder. */
    List<HitRows> trace(int x0, int y0) {
        List<HitRows> levels = new ArrayList<>();
        HitRows rows = visibility.traceEyeRays(SamplePositions.centers(x0, y0), selected, CandidateTracer::allocate);
        rays += visibility.rayCount();
        levels.add(rows);
        traceBounces(rows, 0, levels);
        return levels;
    }

    private void traceBounces(HitRows rows, int level, List<HitRows> levels) {
        for (BounceKind bounce : BounceKind.values()) {
            if (level < depth && bounce.rowCount(rows) > 0) {
                HitRows next = visibility.traceBounceRays(rows, bounce, null, CandidateTracer::allocate);
                rays += visibility.rayCount();
                levels.add(next);
                traceBounces(next, level + 1, levels);
            }
        }
    }

    private static HitRows allocate(int count, boolean textured, boolean transparent) {
        return new HitRows(count, textured, transparent, false, true);
    }
}

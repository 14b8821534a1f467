package lightning.render.gather.build;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.render.gather.cell.SeenSurfaces;
import lightning.render.gather.reflection.ReflectionGroup;
import lightning.render.image.Film;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/**
 * Traces the surfaces that a picture shows, through some pixels of each tile: those seen directly, and those seen in mirrors and through
 * transparent surfaces. Gather points are chosen among them. Use one instance per thread.
 */
final class CandidateTracer {
    private static final short NONE = -1;

    private final TileVisibility visibility;
    private final int depth;
    private final MaterialTable materials;
    private final BitSet selected = new BitSet();
    /** For each material whether it mirrors or transmits light; others may cast bounce rays too, which show nothing. */
    private final boolean[] bounces;
    private final short[] rowByPixel = new short[Film.TILE_PIXELS];
    private long rays;

    /** @param step distance of the pixels */
    CandidateTracer(Geometry geometry, Scene scene, Tracer tracer, int step) {
        visibility = new TileVisibility(geometry, scene, tracer);
        depth = scene.picture().depth();
        materials = geometry.materials();
        bounces = new boolean[materials.count()];
        for (int m = 0; m < bounces.length; m++) {
            bounces[m] = MaterialTable.CASTS_REFLECTIONS.test(materials.material(m));
        }
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

    /** Traces a tile whose upper left pixel is {@code x0, y0}; returns its levels in preorder, each in the order of the pixels. */
    List<SeenSurfaces> trace(int x0, int y0) {
        List<SeenSurfaces> levels = new ArrayList<>();
        HitRows rows = visibility.traceEyeRays(SamplePositions.centers(x0, y0), selected, CandidateTracer::allocate);
        rays += visibility.rayCount();
        levels.add(sort(rows, rows.parent));
        traceBounces(rows, rows.parent, 0, levels);
        return levels;
    }

    /** @param pixels pixel of each row, {@link #NONE} for rows that are no candidates */
    private void traceBounces(HitRows rows, short[] pixels, int level, List<SeenSurfaces> levels) {
        for (BounceKind bounce : BounceKind.values()) {
            if (level < depth && bounce.rowCount(rows) > 0) {
                HitRows next = visibility.traceBounceRays(rows, bounce, null, CandidateTracer::allocate);
                rays += visibility.rayCount();
                short[] itsPixels = new short[next.count];
                for (int row = 0; row < next.count; row++) {
                    int parent = next.parent[row];
                    itsPixels[row] = bounces[rows.material(parent)] ? pixels[parent] : NONE;
                }
                levels.add(sort(next, itsPixels));
                traceBounces(next, itsPixels, level + 1, levels);
            }
        }
    }

    /** Returns rows in the order of their pixels. The order of rows depends on the numbers of materials, which depend on earlier edits. */
    private SeenSurfaces sort(HitRows rows, short[] pixels) {
        Arrays.fill(rowByPixel, NONE);
        for (int row = 0; row < rows.count; row++) {
            if (pixels[row] != NONE) {
                rowByPixel[pixels[row]] = (short) row;
            }
        }
        assert rows.owner != null;
        SeenSurfaces sorted = new SeenSurfaces(rows.count);
        for (int row : rowByPixel) {
            if (row != NONE) {
                if (rows.tangentX != null && rows.tangentY != null && rows.tangentZ != null) {
                    sorted.tangents.set(sorted.count(), rows.tangentX[row], rows.tangentY[row], rows.tangentZ[row]);
                }
                sorted.add(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], rows.owner[row],
                        rows.vx[row], rows.vy[row], rows.vz[row],
                        roughness(rows, row));
            }
        }
        return sorted;
    }

    private float roughness(HitRows rows, int row) {
        Material material = materials.material(rows.material(row));
        return material.isPrincipled() ? ReflectionGroup.roughness(material, rows, row) : 0;
    }

    private static HitRows allocate(int count, TexelColumns texels, boolean transparent) {
        return new HitRows(count, texels, transparent, false, true);
    }
}

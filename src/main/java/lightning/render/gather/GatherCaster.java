package lightning.render.gather;

import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;

/** Casts the rays by which points on surfaces gather light. Holds scratch memory: use one instance per thread. */
final class GatherCaster {
    private final int rays;
    private final RayBatch batch;
    private final GatherDirections directions;
    private final CellKeys keys;
    private final MaterialTable materials;
    private final CellColors colors;
    /** Points whose rays are cast together. */
    private final int[] together = new int[RayBatch.MAX_RAYS];
    /** Cell of each row that was hit. */
    private final long[] cells = new long[RayBatch.MAX_RAYS];
    /** Directions around one point. */
    private final double[] x;
    private final double[] y;
    private final double[] z;

    /** @param colors receives the texture colors that rays hit */
    GatherCaster(Geometry geometry, Scene scene, Tracer tracer, CellKeys keys, DirectionTable table, CellColors colors) {
        rays = table.rays();
        this.keys = keys;
        this.colors = colors;
        materials = geometry.materials();
        batch = new RayBatch(geometry, scene, tracer);
        directions = new GatherDirections(table, batch);
        x = new double[rays];
        y = new double[rays];
        z = new double[rays];
    }

    /** Points whose rays are cast together. */
    static int pointsPerBatch(DirectionTable directions) {
        return Math.max(1, RayBatch.MAX_RAYS / directions.rays());
    }

    /**
     * Casts the rays of points {@code from … to − 1}, at most {@link #pointsPerBatch}.
     *
     * @param seeds    of the points' directions
     * @param links    receives the cell that each ray hit
     * @param harmonic receives the harmonic mean length of each point's rays, {@code +∞} if none hits; null if not wanted
     */
    void cast(SurfaceColumns points, long[] seeds, int from, int to, RayLinks links, float[] harmonic) {
        for (int p = from; p < to; p++) {
            together[p - from] = p;
        }
        directions.findNormals(points, together, to - from);
        for (int p = from; p < to; p++) {
            aim(points, p, p - from, seeds[p]);
        }
        int count = (to - from) * rays;
        batch.trace(count);
        HitRows rows = batch.rows((hits, textured, transparent) -> new HitRows(hits, textured, transparent, false, false));
        links.clear(from * rays, to * rays);
        for (int row = 0; row < rows.count; row++) {
            int ray = rows.parent[row];
            long key = keys.surfelKey(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row],
                    batch.primitive(ray), batch.distance(ray));
            links.setKey(from * rays + ray, key);
            cells[row] = key;
        }
        addColors(rows);
        if (batch.isTinted()) {
            links.setTints(from * rays, count, batch.tint);
        }
        if (harmonic != null) {
            for (int p = from; p < to; p++) {
                harmonic[p] = harmonicMean((p - from) * rays);
            }
        }
    }

    private void addColors(HitRows rows) {
        for (int run = 0; run < rows.runCount; run++) {
            if (materials.isTextured(rows.runMaterial[run])) {
                for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                    colors.add(cells[row], rows.texelRed[row], rows.texelGreen[row], rows.texelBlue[row]);
                }
            }
        }
    }

    private void aim(SurfaceColumns points, int p, int i, long seed) {
        directions.write(points, p, i, seed, batch.directionX, batch.directionY, batch.directionZ, i * rays);
        for (int ray = i * rays; ray < (i + 1) * rays; ray++) {
            setStart(ray, points, p);
        }
    }

    private void setStart(int ray, SurfaceColumns points, int p) {
        batch.startX[ray] = points.px[p];
        batch.startY[ray] = points.py[p];
        batch.startZ[ray] = points.pz[p];
    }

    private float harmonicMean(int first) {
        double sum = 0;
        for (int ray = first; ray < first + rays; ray++) {
            sum += batch.primitive(ray) < 0 ? 0 : 1 / batch.distance(ray);
        }
        return (float) (rays / sum);
    }

    /**
     * Casts some rays again and returns what they hit.
     *
     * @param selected indices of the rays, at most 1024, ascending; each hits a surface
     * @param from     first of them
     * @return rows sorted by material; {@code parent} is the position among the selected
     */
    HitRows hits(SurfaceColumns points, long[] seeds, int[] selected, int from, int to) {
        int count = 0;
        for (int i = from; i < to; i++) {
            if (i == from || selected[i] / rays != selected[i - 1] / rays) {
                together[count++] = selected[i] / rays;
            }
        }
        directions.findNormals(points, together, count);
        int known = -1;
        for (int i = from; i < to; i++) {
            int p = selected[i] / rays;
            if (known < 0 || p != together[known]) {
                known++;
                directions.write(points, p, known, seeds[p], x, y, z, 0);
            }
            int k = selected[i] % rays;
            batch.directionX[i - from] = x[k];
            batch.directionY[i - from] = y[k];
            batch.directionZ[i - from] = z[k];
            setStart(i - from, points, p);
        }
        batch.trace(to - from);
        return batch.rows((hits, textured, transparent) -> new HitRows(hits, textured, transparent, false, true)).compact();
    }
}

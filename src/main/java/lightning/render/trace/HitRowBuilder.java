package lightning.render.trace;

import java.util.Arrays;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import org.jspecify.annotations.Nullable;

/** Builds hit rows from traced rays. Holds scratch memory: use one per thread. */
final class HitRowBuilder {
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final Tracer tracer;
    private final TexelWriter texels;
    private final int[] starts;
    /** Rank of the material that each ray hit, −1 for a miss. */
    private final int[] ranks = new int[RayColumns.MAX_RAYS];
    /** Created on first use. */
    private @Nullable SurfaceHit surface;

    HitRowBuilder(Geometry geometry, Tracer tracer) {
        primitives = geometry.primitives();
        materials = geometry.materials();
        this.tracer = tracer;
        texels = new TexelWriter(geometry);
        starts = new int[materials.count() + 1];
    }

    /**
     * Sorts the hits of rays by material and computes their surfaces.
     *
     * @param patterns sample patterns by the slots of the rays; unread if the rows have none
     */
    HitRows build(RayColumns rays, byte @Nullable [] patterns, TileVisibility.Allocator allocator) {
        return build(rays, patterns, true, allocator);
    }

    /** @param withTexels whether to look up the textures of the hits */
    HitRows build(RayColumns rays, byte @Nullable [] patterns, boolean withTexels, TileVisibility.Allocator allocator) {
        Arrays.fill(starts, 0);
        rankHits(rays);
        for (int i = 0; i < rays.count; i++) {
            if (ranks[i] >= 0) {
                starts[ranks[i] + 1]++;
            }
        }
        TexelColumns columns = TexelColumns.NONE;
        for (int r = 0; r < materials.count(); r++) {
            columns = withTexels && starts[r + 1] > 0 ? columns.or(materials.texels(materials.materialAtRank(r))) : columns;
            starts[r + 1] += starts[r];
        }
        rays.hitCount = starts[materials.count()];
        int clearCount = starts[materials.clearCount()];
        HitRows rows = allocator.allocate(rays.hitCount, columns, clearCount > 0);
        rows.count = rays.hitCount;
        rows.runCount = 0;
        rows.bounds = null;
        rows.clearCount = clearCount;
        rows.reflectiveCount = starts[materials.reflectiveCount()];
        for (int r = 0; r < materials.count(); r++) {
            if (starts[r + 1] > starts[r]) {
                rows.addRun(materials.materialAtRank(r), starts[r + 1]);
            }
        }
        for (int i = 0; i < rays.count; i++) {
            if (ranks[i] >= 0) {
                rays.order[starts[ranks[i]]++] = (short) i;
            }
        }
        writeRows(rays, patterns, rows, !columns.isNone());
        return rows;
    }

    /** Replaces the texels of the rows built last by means over squares on their surfaces, as {@link TexelWriter#writeMeans}. */
    void writeMeanTexels(HitRows rows, RayColumns rays, double[] sides) {
        if (!rows.texels().isNone()) {
            texels.writeMeans(rows, rays, sides);
        }
    }

    private void writeRows(RayColumns rays, byte @Nullable [] patterns, HitRows rows, boolean textured) {
        tracer.writeSurfaces(rays, rows, textured);
        for (int row = 0; row < rows.count; row++) {
            int ray = rays.order[row];
            rows.vx[row] = (float) rays.dx[ray];
            rows.vy[row] = (float) rays.dy[ray];
            rows.vz[row] = (float) rays.dz[ray];
            rows.parent[row] = rays.slot[ray];
        }
        for (int row = 0; row < rows.clearCount; row++) {
            writeBackSide(rays, rows, row);
        }
        if (textured) {
            texels.write(rows, 0, rays);
        }
        if (rows.pattern != null) {
            assert patterns != null;
            for (int row = 0; row < rows.count; row++) {
                rows.pattern[row] = patterns[rows.parent[row]];
            }
        }
        for (int row = 0; rows.owner != null && row < rows.count; row++) {
            rows.owner[row] = rays.primitive[rays.order[row]];
        }
    }

    /** Writes the start of the refracted ray of a row with a transparent material. */
    private void writeBackSide(RayColumns rays, HitRows rows, int row) {
        surface = surface == null ? new SurfaceHit() : surface;
        int ray = rays.order[row];
        int primitive = rays.primitive[ray];
        surface.compute(primitives, primitive, rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray],
                rays.dy[ray], rays.dz[ray], rays.t[ray]);
        surface.computeBackPoint();
        assert rows.backX != null && rows.backY != null && rows.backZ != null && rows.insideDistance != null;
        rows.backX[row] = surface.backX;
        rows.backY[row] = surface.backY;
        rows.backZ[row] = surface.backZ;
        rows.insideDistance[row] =
                SurfacePointBuilder.insideDistance(materials.transmission(primitives.material[primitive]), surface, rays.t[ray]);
    }

    /** Finds the rank of the material that each ray hit; adjacent rays mostly hit the same primitive. */
    private void rankHits(RayColumns rays) {
        int last = -1;
        int rank = -1;
        for (int i = 0; i < rays.count; i++) {
            int primitive = rays.primitive[i];
            if (primitive != last) {
                last = primitive;
                rank = primitive < 0 ? -1 : materials.rank(primitives.material[primitive]);
            }
            ranks[i] = rank;
        }
    }
}

package lightning.trace;

import java.util.Arrays;
import lightning.scene.Scene;
import lightning.trace.primitive.PrimitiveTable;
import lightning.trace.tree.Beam;
import lightning.trace.tree.BoxSet;
import lightning.trace.tree.Candidates;

/**
 * The first stage: finds what the rays of one tile hit and writes the hit rows. Holds scratch
 * memory: one for each thread.
 */
public final class TileVisibility {
    /** Gives the columns that rows are written to: new ones to keep, or the same again and again. */
    @FunctionalInterface
    public interface Allocator {
        HitRows rows(int count, boolean textured);
    }

    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final int width;
    private final int height;
    private final Geometry geometry;
    private final Tracer tracer;
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();
    private final RayColumns rays;
    private final int[] starts;
    private final TexelColumns texels;

    public TileVisibility(Geometry geometry, Scene scene, Tracer tracer) {
        this.geometry = geometry;
        primitives = geometry.primitives();
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        rays = new RayColumns(camera);
        width = scene.picture().width();
        height = scene.picture().height();
        this.tracer = tracer;
        starts = new int[materials.count() + 1];
        texels = new TexelColumns(geometry);
    }

    /**
     * Traces the eye rays of the tile whose upper left pixel is {@code x0, y0}.
     *
     * @param size pixels along a side of the tile, at most 32
     * @return the rows of the pixels that hit something; {@code parent} is the pixel's index in the tile
     */
    public HitRows eye(int x0, int y0, int size, Allocator allocator) {
        int columns = Math.min(size, width - x0);
        int lines = Math.min(size, height - y0);
        rays.from = null;
        rays.count = columns * lines;
        rays.columns = columns;
        for (int y = 0, ray = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                rays.slot[ray++] = (short) (y * size + x);
            }
        }
        tracer.eye(camera, x0, y0, columns, lines, rays);
        camera.sweep(beam, x0, y0, columns, lines);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
        return rows(allocator);
    }

    /** Whether any eye ray of the places can meet any of the boxes. */
    public boolean eyeTouches(SamplePlaces places, BoxSet boxes) {
        if (places.pixels() == null) {
            camera.sweep(beam, places.x0(), places.y0(), Math.min(SamplePlaces.SIDE, width - places.x0()),
                    Math.min(SamplePlaces.SIDE, height - places.y0()));
        } else {
            places.bound(beam, camera);
        }
        return boxes.touches(beam);
    }

    /** Whether any mirrored ray of a level's reflective rows can meet any of the boxes. */
    public boolean mirrorsTouch(HitRows from, BoxSet boxes) {
        if (from.reflective == 0 || boxes.isEmpty()) {
            return false;
        }
        direct(from);
        bound();
        return boxes.touches(beam);
    }

    /**
     * Traces finer samples of some pixels of a tile.
     *
     * @param places of all of them, at most 1024
     * @return the rows of the samples that hit something; {@code parent} is the sample's number
     */
    public HitRows fine(SamplePlaces places, Allocator allocator) {
        rays.from = null;
        rays.count = places.count();
        rays.columns = 0;
        for (int ray = 0; ray < rays.count; ray++) {
            rays.slot[ray] = (short) ray;
        }
        tracer.samples(camera, places, rays);
        places.bound(beam, camera);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
        return rows(allocator);
    }

    /**
     * Traces the mirrored rays of the reflective rows of a level.
     *
     * @param known the shape that each ray hits, −1 for none, where that is known; else null
     * @return the rows that were hit; {@code parent} is the row they are seen from
     */
    public HitRows mirrored(HitRows from, int[] known, Allocator allocator) {
        direct(from);
        if (known == null) {
            nearest();
        } else {
            System.arraycopy(known, 0, rays.primitive, 0, rays.count);
            tracer.distances(rays);
        }
        return rows(allocator);
    }

    /**
     * Traces the mirrored rays of some reflective rows of a level.
     *
     * @param which those rows, ascending
     * @return as {@link #mirrored(HitRows, int[], Allocator)}
     */
    public HitRows mirroredFrom(HitRows from, int[] which, Allocator allocator) {
        for (int i = 0; i < which.length; i++) {
            rays.slot[i] = (short) which[i];
        }
        direct(from, which.length);
        nearest();
        return rows(allocator);
    }

    /** Directs the mirrored rays of all reflective rows. */
    private void direct(HitRows from) {
        for (int i = 0; i < from.reflective; i++) {
            rays.slot[i] = (short) i;
        }
        direct(from, from.reflective);
    }

    /** Directs the mirrored rays of the rows in the first {@code count} slots. */
    private void direct(HitRows from, int count) {
        rays.from = from;
        rays.count = count;
        rays.columns = 0;
        for (int i = 0; i < count; i++) {
            MirrorRays.direction(from, rays.slot[i], rays.dx, rays.dy, rays.dz, i);
        }
    }

    /** Finds what mirrored rays hit. */
    private void nearest() {
        if (rays.count == 0) {
            return;
        }
        bound();
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
    }

    /** Makes the beam of the mirrored rays; there must be any. */
    private void bound() {
        beam.clear();
        if (rays.count == rays.from.reflective) {
            beam.origins(tracer.box(rays.from.px, rays.from.py, rays.from.pz, 0, rays.count));
        } else {
            for (int i = 0; i < rays.count; i++) {
                beam.origin(rays.originX(i), rays.originY(i), rays.originZ(i));
            }
        }
        rays.sweep(beam, tracer);
    }

    /** The shapes that the rays traced last hit, −1 for none, one for each ray. */
    public int[] hitShapes(int count) {
        return Arrays.copyOf(rays.primitive, count);
    }

    /** Sorts the hits by material and computes their surfaces. */
    private HitRows rows(Allocator allocator) {
        Arrays.fill(starts, 0);
        for (int i = 0; i < rays.count; i++) {
            if (rays.primitive[i] >= 0) {
                starts[rank(i) + 1]++;
            }
        }
        boolean textured = false;
        for (int r = 0; r < materials.count(); r++) {
            textured |= starts[r + 1] > 0 && materials.isTextured(materials.ranked(r));
            starts[r + 1] += starts[r];
        }
        rays.hits = starts[materials.count()];
        HitRows rows = allocator.rows(rays.hits, textured);
        rows.count = rays.hits;
        rows.runs = 0;
        rows.box = null;
        rows.reflective = starts[materials.reflectiveCount()];
        for (int r = 0; r < materials.count(); r++) {
            if (starts[r + 1] > starts[r]) {
                rows.addRun(materials.ranked(r), starts[r + 1]);
            }
        }
        for (int i = 0; i < rays.count; i++) {
            if (rays.primitive[i] >= 0) {
                rays.order[starts[rank(i)]++] = (short) i;
            }
        }
        fill(rows, textured);
        return rows;
    }

    private void fill(HitRows rows, boolean textured) {
        tracer.surfaces(rays, rows, textured);
        for (int row = 0; row < rows.count; row++) {
            int ray = rays.order[row];
            rows.vx[row] = (float) rays.dx[ray];
            rows.vy[row] = (float) rays.dy[ray];
            rows.vz[row] = (float) rays.dz[ray];
            rows.parent[row] = rays.slot[ray];
        }
        if (textured) {
            texels.write(rows, 0, rays);
        }
        for (int row = 0; rows.code != null && row < rows.count; row++) {
            rows.code[row] = HitCode.of(geometry.number(rays.primitive[rays.order[row]]), rows.nx[row], rows.ny[row], rows.nz[row]);
        }
        for (int row = 0; rows.owner != null && row < rows.count; row++) {
            rows.owner[row] = rays.primitive[rays.order[row]];
        }
    }

    /** The place in the order of rows of the material that a ray hit. */
    private int rank(int ray) {
        return materials.rank(primitives.material[rays.primitive[ray]]);
    }
}

package lightning.render.trace;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Scene;

/**
 * The first stage: finds what the rays of one tile hit and writes the hit rows. Holds scratch
 * memory: one for each thread.
 */
public final class TileVisibility {
    /** Gives the columns that rows are written to: new ones to keep, or the same again and again. */
    @FunctionalInterface
    public interface Allocator {
        HitRows rows(int count, boolean textured, boolean clear);
    }

    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final int width;
    private final int height;
    private final Geometry geometry;
    private final Tracer tracer;
    private final Beam beam = new Beam();
    private final BoxRay way = new BoxRay();
    private final Candidates candidates = new Candidates();
    private final RayColumns rays;
    private final int[] starts;
    /** Of the material that each ray hit, −1 for a miss. */
    private final int[] ranks = new int[RayColumns.MOST];
    private final double[] direction = new double[3];
    /** Made when it is needed first. */
    private Surface surface;
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
        centers(x0, y0, size, columns, lines);
        camera.sweep(beam, x0, y0, columns, lines);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
        return rows(allocator);
    }

    private void centers(int x0, int y0, int size, int columns, int lines) {
        rays.fromEye();
        rays.count = columns * lines;
        rays.columns = columns;
        for (int y = 0, ray = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                rays.slot[ray++] = (short) (y * size + x);
            }
        }
        tracer.eye(camera, x0, y0, columns, lines, rays);
    }

    private void samples(SamplePlaces places) {
        rays.fromEye();
        rays.count = places.count();
        rays.columns = 0;
        for (int ray = 0; ray < rays.count; ray++) {
            rays.slot[ray] = (short) ray;
        }
        tracer.samples(camera, places, rays);
    }

    /** Directs the eye rays of some places; of the centres of pixels those in the picture. */
    private void direct(SamplePlaces places) {
        if (places.pixels() == null) {
            int columns = Math.min(SamplePlaces.SIDE, width - places.x0());
            int lines = Math.min(SamplePlaces.SIDE, height - places.y0());
            centers(places.x0(), places.y0(), SamplePlaces.SIDE, columns, lines);
        } else {
            samples(places);
        }
    }

    private boolean eyeTouches(SamplePlaces places, BoxSet boxes) {
        if (places.pixels() == null) {
            camera.sweep(beam, places.x0(), places.y0(), Math.min(SamplePlaces.SIDE, width - places.x0()),
                    Math.min(SamplePlaces.SIDE, height - places.y0()));
        } else {
            places.bound(beam, camera);
        }
        return boxes.touches(beam);
    }

    /** The numbers of those of the places whose eye rays can meet any of the boxes. */
    public BitSet eyeTouching(SamplePlaces places, BoxSet boxes) {
        if (boxes.isEmpty() || !eyeTouches(places, boxes)) {
            return new BitSet();
        }
        direct(places);
        return touching(boxes);
    }

    /** The rows of a level whose rays that go on in some way can meet any of the boxes. */
    public BitSet touching(HitRows from, Bounce bounce, BoxSet boxes) {
        if (bounce.rows(from) == 0 || boxes.isEmpty()) {
            return new BitSet();
        }
        direct(from, bounce);
        if (rays.count == 0) {
            return new BitSet();
        }
        bound(bounce);
        return boxes.touches(beam) ? touching(boxes) : new BitSet();
    }

    private BitSet touching(BoxSet boxes) {
        BitSet touching = new BitSet();
        for (int i = 0; i < rays.count; i++) {
            way.enter(rays.originX(i), rays.originY(i), rays.originZ(i), rays.dx[i], rays.dy[i], rays.dz[i]);
            if (boxes.touches(way, Double.POSITIVE_INFINITY)) {
                touching.set(rays.slot[i]);
            }
        }
        return touching;
    }

    /**
     * Traces the eye rays of some places.
     *
     * @param which the numbers of those places, at least one
     * @return the rows of those that hit something; {@code parent} is the place's number
     */
    public HitRows eye(SamplePlaces places, BitSet which, Allocator allocator) {
        direct(places);
        int count = 0;
        for (int i = 0; i < rays.count; i++) {
            if (which.get(rays.slot[i])) {
                rays.slot[count] = rays.slot[i];
                rays.dx[count] = rays.dx[i];
                rays.dy[count] = rays.dy[i];
                rays.dz[count++] = rays.dz[i];
            }
        }
        rays.count = count;
        rays.columns = 0;
        beam.clear();
        beam.origin(rays.originX(0), rays.originY(0), rays.originZ(0));
        rays.sweep(beam, tracer);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
        return rows(allocator);
    }

    /**
     * Traces finer samples of some pixels of a tile.
     *
     * @param places of all of them, at most 1024
     * @return the rows of the samples that hit something; {@code parent} is the sample's number
     */
    public HitRows fine(SamplePlaces places, Allocator allocator) {
        samples(places);
        places.bound(beam, camera);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
        return rows(allocator);
    }

    /**
     * Traces the rays that go on from a level's rows in some way.
     *
     * @param known the shape that each ray hits, −1 for none, where that is known; else null
     * @return the rows that were hit; {@code parent} is the row they are seen from
     */
    public HitRows seenFrom(HitRows from, Bounce bounce, int[] known, Allocator allocator) {
        direct(from, bounce);
        if (known == null) {
            nearest(bounce);
        } else {
            System.arraycopy(known, 0, rays.primitive, 0, rays.count);
            tracer.distances(rays);
        }
        return rows(allocator);
    }

    /**
     * Traces the rays that go on from some of those rows.
     *
     * @param which those rows
     * @return as {@link #seenFrom(HitRows, Bounce, int[], Allocator)}
     */
    public HitRows seenFromSome(HitRows from, Bounce bounce, BitSet which, Allocator allocator) {
        int count = 0;
        for (int row = which.nextSetBit(0); row >= 0; row = which.nextSetBit(row + 1)) {
            rays.slot[count++] = (short) row;
        }
        direct(from, bounce, count);
        nearest(bounce);
        return rows(allocator);
    }

    /** How many rays were traced last. */
    public int rays() {
        return rays.count;
    }

    /** Directs the rays of all rows. */
    private void direct(HitRows from, Bounce bounce) {
        int count = bounce.rows(from);
        for (int i = 0; i < count; i++) {
            rays.slot[i] = (short) i;
        }
        direct(from, bounce, count);
    }

    /** Directs the rays of the rows in the first {@code count} slots; rows from which none goes on lose their slots. */
    private void direct(HitRows from, Bounce bounce, int count) {
        rays.from(from, bounce);
        rays.columns = 0;
        int casting = 0;
        for (int i = 0; i < count; i++) {
            if (bounce.direct(from, rays.slot[i], materials, direction)) {
                rays.slot[casting] = rays.slot[i];
                rays.dx[casting] = direction[0];
                rays.dy[casting] = direction[1];
                rays.dz[casting++] = direction[2];
            }
        }
        rays.count = casting;
    }

    /** Finds what rays from rows hit. */
    private void nearest(Bounce bounce) {
        if (rays.count == 0) {
            return;
        }
        bound(bounce);
        candidates.collect(geometry.bvh(), beam);
        tracer.nearest(rays, candidates);
    }

    /** Makes the beam of the rays from rows; there must be any. */
    private void bound(Bounce bounce) {
        beam.clear();
        if (rays.count == bounce.rows(rays.from)) {
            beam.origins(tracer.box(rays.fromX, rays.fromY, rays.fromZ, 0, rays.count));
        } else {
            for (int i = 0; i < rays.count; i++) {
                beam.origin(rays.originX(i), rays.originY(i), rays.originZ(i));
            }
        }
        rays.sweep(beam, tracer);
    }

    /** The shapes that the rays traced last hit, −1 for none, one for each ray. */
    public int[] hitShapes() {
        return Arrays.copyOf(rays.primitive, rays.count);
    }

    /** Sorts the hits by material and computes their surfaces. */
    private HitRows rows(Allocator allocator) {
        Arrays.fill(starts, 0);
        rank();
        for (int i = 0; i < rays.count; i++) {
            if (ranks[i] >= 0) {
                starts[ranks[i] + 1]++;
            }
        }
        boolean textured = false;
        for (int r = 0; r < materials.count(); r++) {
            textured |= starts[r + 1] > 0 && materials.isTextured(materials.ranked(r));
            starts[r + 1] += starts[r];
        }
        rays.hits = starts[materials.count()];
        int clear = starts[materials.clearCount()];
        HitRows rows = allocator.rows(rays.hits, textured, clear > 0);
        rows.count = rays.hits;
        rows.runs = 0;
        rows.box = null;
        rows.clear = clear;
        rows.reflective = starts[materials.reflectiveCount()];
        for (int r = 0; r < materials.count(); r++) {
            if (starts[r + 1] > starts[r]) {
                rows.addRun(materials.ranked(r), starts[r + 1]);
            }
        }
        for (int i = 0; i < rays.count; i++) {
            if (ranks[i] >= 0) {
                rays.order[starts[ranks[i]]++] = (short) i;
            }
        }
        fill(rows, textured);
        return rows;
    }

    /** Rows beside each other mostly show the same primitive, whose number is found once. */
    private void codes(HitRows rows) {
        int last = -1;
        int number = 0;
        for (int row = 0; row < rows.count; row++) {
            int primitive = rays.primitive[rays.order[row]];
            if (primitive != last) {
                last = primitive;
                number = geometry.number(primitive);
            }
            rows.code[row] = HitCode.of(number, rows.nx[row], rows.ny[row], rows.nz[row]);
        }
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
        for (int row = 0; row < rows.clear; row++) {
            behind(rows, row);
        }
        if (textured) {
            texels.write(rows, 0, rays);
        }
        if (rows.code != null) {
            codes(rows);
        }
        for (int row = 0; rows.owner != null && row < rows.count; row++) {
            rows.owner[row] = rays.primitive[rays.order[row]];
        }
    }

    /** Writes where the ray of a row of a clear material goes on behind the surface. */
    private void behind(HitRows rows, int row) {
        surface = surface == null ? new Surface() : surface;
        int ray = rays.order[row];
        int primitive = rays.primitive[ray];
        surface.at(primitives, primitive, rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray), rays.dx[ray],
                rays.dy[ray], rays.dz[ray], rays.t[ray]);
        surface.behind();
        rows.behindX[row] = surface.behindX;
        rows.behindY[row] = surface.behindY;
        rows.behindZ[row] = surface.behindZ;
        rows.inside[row] = SurfaceProbe.way(materials.clarity(primitives.material[primitive]), surface, rays.t[ray]);
    }

    /** Finds the place in the order of rows of the material that each ray hit; rays beside each other mostly hit the same primitive. */
    private void rank() {
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

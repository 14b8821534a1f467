package lightning.trace;

import java.util.Arrays;
import lightning.scene.Scene;

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

    private static final int ROWS = 1024;

    private final ShapeTable shapes;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final int width;
    private final int height;
    private final Geometry geometry;
    private final PacketTracer tracer;
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();
    private final RayPacket packet = new RayPacket();
    private final SurfacePacket surface = new SurfacePacket();
    private final double[] dx = new double[ROWS];
    private final double[] dy = new double[ROWS];
    private final double[] dz = new double[ROWS];
    private final double[] t = new double[ROWS];
    private final int[] shape = new int[ROWS];
    private final short[] slot = new short[ROWS];
    private final short[] order = new short[ROWS];
    private final double[] sampleX = new double[RayPacket.WIDTH];
    private final double[] sampleY = new double[RayPacket.WIDTH];
    private final int[] starts;
    private final TexelColumns texels;

    public TileVisibility(Geometry geometry, Scene scene, PacketTracer tracer) {
        this.geometry = geometry;
        shapes = geometry.shapes();
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
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
        int rays = 0;
        beam.eye(camera, x0, y0, columns, lines);
        candidates.collect(geometry, beam);
        for (int y = 0; y < lines; y++) {
            for (int x = 0; x < columns; x += RayPacket.WIDTH) {
                int live = Math.min(RayPacket.WIDTH, columns - x);
                PacketTracer.eyeRays(camera, x0 + x, y0 + y, live, packet);
                tracer.nearest(packet, live, candidates);
                keep(rays, live);
                for (int i = 0; i < live; i++) {
                    slot[rays + i] = (short) (y * size + x + i);
                }
                rays += live;
            }
        }
        return rows(null, rays, allocator);
    }

    /**
     * Traces finer samples of some pixels of a tile.
     *
     * @param places of all of them, at most 1024
     * @return the rows of the samples that hit something; {@code parent} is the sample's number
     */
    public HitRows fine(SamplePlaces places, Allocator allocator) {
        int rays = places.count();
        places.bound(beam, camera);
        candidates.collect(geometry, beam);
        for (int ray = 0; ray < rays; ray += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, rays - ray);
            for (int i = 0; i < live; i++) {
                sampleX[i] = places.x(ray + i);
                sampleY[i] = places.y(ray + i);
                slot[ray + i] = (short) (ray + i);
            }
            EyeLanes.at(camera, sampleX, sampleY, packet);
            tracer.nearest(packet, live, candidates);
            keep(ray, live);
        }
        return rows(null, rays, allocator);
    }

    /**
     * Traces the mirrored rays of the reflective rows of a level.
     *
     * @param known the shape that each ray hits, −1 for none, where that is known; else null
     * @return the rows that were hit; {@code parent} is the row they are seen from
     */
    public HitRows mirrored(HitRows from, int[] known, Allocator allocator) {
        int rays = from.reflective;
        for (int i = 0; i < rays; i++) {
            slot[i] = (short) i;
        }
        return mirrored(from, rays, known, allocator);
    }

    /**
     * Traces the mirrored rays of some reflective rows of a level.
     *
     * @param which those rows, ascending
     * @return as {@link #mirrored(HitRows, int[], Allocator)}
     */
    public HitRows mirroredFrom(HitRows from, int[] which, Allocator allocator) {
        for (int i = 0; i < which.length; i++) {
            slot[i] = (short) which[i];
        }
        return mirrored(from, which.length, null, allocator);
    }

    /** Traces the mirrored rays of the rows in the first {@code rays} slots. */
    private HitRows mirrored(HitRows from, int rays, int[] known, Allocator allocator) {
        beam.clear();
        for (int i = 0; i < rays; i++) {
            MirrorRays.direction(from, slot[i], dx, dy, dz, i);
        }
        if (known == null && rays > 0) {
            if (rays == from.reflective) {
                beam.origins(from.px, from.py, from.pz, rays);
            } else {
                for (int i = 0; i < rays; i++) {
                    beam.origin(from.px[slot[i]], from.py[slot[i]], from.pz[slot[i]]);
                }
            }
            beam.directions(dx, dy, dz, rays);
            candidates.collect(geometry, beam);
        }
        for (int i = 0; i < rays; i += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, rays - i);
            load(from, i, live);
            if (known == null) {
                tracer.nearest(packet, live, candidates);
            } else {
                System.arraycopy(known, i, packet.shape, 0, live);
                tracer.distances(packet, live);
            }
            System.arraycopy(packet.t, 0, t, i, live);
            System.arraycopy(packet.shape, 0, shape, i, live);
        }
        return rows(from, rays, allocator);
    }

    /** The shapes that the rays traced last hit, −1 for none, one for each ray. */
    public int[] hitShapes(int rays) {
        return Arrays.copyOf(shape, rays);
    }

    /** Puts rays {@code ray …}, from the rows of a level in their slots, into the packet. */
    private void load(HitRows from, int ray, int live) {
        for (int i = 0; i < live; i++) {
            int row = slot[ray + i];
            packet.ox[i] = from.px[row];
            packet.oy[i] = from.py[row];
            packet.oz[i] = from.pz[row];
        }
        System.arraycopy(dx, ray, packet.dx, 0, live);
        System.arraycopy(dy, ray, packet.dy, 0, live);
        System.arraycopy(dz, ray, packet.dz, 0, live);
    }

    private void keep(int at, int live) {
        System.arraycopy(packet.dx, 0, dx, at, live);
        System.arraycopy(packet.dy, 0, dy, at, live);
        System.arraycopy(packet.dz, 0, dz, at, live);
        System.arraycopy(packet.t, 0, t, at, live);
        System.arraycopy(packet.shape, 0, shape, at, live);
    }

    /** Sorts the hits by material and computes their surfaces. */
    private HitRows rows(HitRows from, int rays, Allocator allocator) {
        Arrays.fill(starts, 0);
        for (int i = 0; i < rays; i++) {
            if (shape[i] >= 0) {
                starts[rank(i) + 1]++;
            }
        }
        boolean textured = false;
        for (int r = 0; r < materials.count(); r++) {
            textured |= starts[r + 1] > 0 && materials.isTextured(materials.ranked(r));
            starts[r + 1] += starts[r];
        }
        int hits = starts[materials.count()];
        HitRows rows = allocator.rows(hits, textured);
        rows.count = hits;
        rows.runs = 0;
        rows.box = null;
        rows.reflective = starts[materials.reflectiveCount()];
        for (int r = 0; r < materials.count(); r++) {
            if (starts[r + 1] > starts[r]) {
                rows.addRun(materials.ranked(r), starts[r + 1]);
            }
        }
        for (int i = 0; i < rays; i++) {
            if (shape[i] >= 0) {
                order[starts[rank(i)]++] = (short) i;
            }
        }
        for (int row = 0; row < hits; row += RayPacket.WIDTH) {
            surfaces(from, rows, row, Math.min(RayPacket.WIDTH, hits - row), textured);
        }
        return rows;
    }

    /** The place in the order of rows of the material that a ray hit. */
    private int rank(int ray) {
        return materials.rank(shapes.material[shape[ray]]);
    }

    private void loadSorted(HitRows from, int row, int live) {
        for (int i = 0; i < live; i++) {
            int ray = order[row + i];
            packet.ox[i] = from == null ? 0 : from.px[slot[ray]];
            packet.oy[i] = from == null ? 0 : from.py[slot[ray]];
            packet.oz[i] = from == null ? 0 : from.pz[slot[ray]];
            packet.dx[i] = dx[ray];
            packet.dy[i] = dy[ray];
            packet.dz[i] = dz[ray];
            packet.t[i] = t[ray];
            packet.shape[i] = shape[ray];
        }
    }

    private void surfaces(HitRows from, HitRows rows, int row, int live, boolean textured) {
        loadSorted(from, row, live);
        tracer.surfaces(packet, live, surface);
        System.arraycopy(surface.px, 0, rows.px, row, live);
        System.arraycopy(surface.py, 0, rows.py, row, live);
        System.arraycopy(surface.pz, 0, rows.pz, row, live);
        System.arraycopy(surface.nx, 0, rows.nx, row, live);
        System.arraycopy(surface.ny, 0, rows.ny, row, live);
        System.arraycopy(surface.nz, 0, rows.nz, row, live);
        for (int i = 0; i < live; i++) {
            rows.vx[row + i] = (float) packet.dx[i];
            rows.vy[row + i] = (float) packet.dy[i];
            rows.vz[row + i] = (float) packet.dz[i];
            rows.parent[row + i] = slot[order[row + i]];
        }
        if (textured) {
            texels.write(rows, row, live, packet, surface);
        }
        for (int i = 0; rows.code != null && i < live; i++) {
            rows.code[row + i] = HitCode.of(packet.shape[i], rows.nx[row + i], rows.ny[row + i], rows.nz[row + i]);
        }
    }
}

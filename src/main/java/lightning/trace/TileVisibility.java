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
    private static final int SIDE = 32;

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
    private final float[] texel = new float[3];

    public TileVisibility(Geometry geometry, Scene scene, PacketTracer tracer) {
        this.geometry = geometry;
        shapes = geometry.shapes();
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        width = scene.picture().width();
        height = scene.picture().height();
        this.tracer = tracer;
        starts = new int[materials.count() + 1];
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
     * Traces all samples of some pixels of the tile whose upper left pixel is {@code x0, y0}.
     *
     * @param pixels indices in a tile of 32×32 pixels, ascending; those from {@code from} to before {@code to} are meant
     * @param grid   samples along each side of a pixel; all samples together at most 1024
     * @return the rows of the samples that hit something; {@code parent} is the sample's number: those of the first pixel
     *         come first, line by line
     */
    public HitRows fine(int x0, int y0, short[] pixels, int from, int to, int grid, Allocator allocator) {
        int perPixel = grid * grid;
        int rays = (to - from) * perPixel;
        boundFine(x0, y0, pixels, from, to);
        candidates.collect(geometry, beam);
        for (int ray = 0; ray < rays; ray += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, rays - ray);
            for (int i = 0; i < live; i++) {
                int pixel = pixels[from + (ray + i) / perPixel];
                int sample = (ray + i) % perPixel;
                sampleX[i] = x0 + pixel % SIDE + SampleGrid.offset(sample % grid, grid);
                sampleY[i] = y0 + pixel / SIDE + SampleGrid.offset(sample / grid, grid);
                slot[ray + i] = (short) (ray + i);
            }
            EyeLanes.at(camera, sampleX, sampleY, packet);
            tracer.nearest(packet, live, candidates);
            keep(ray, live);
        }
        return rows(null, rays, allocator);
    }

    /** The beam through the smallest rectangle that holds the pixels. */
    private void boundFine(int x0, int y0, short[] pixels, int from, int to) {
        int left = SIDE;
        int right = 0;
        for (int i = from; i < to; i++) {
            left = Math.min(left, pixels[i] % SIDE);
            right = Math.max(right, pixels[i] % SIDE);
        }
        int top = pixels[from] / SIDE;
        int bottom = pixels[to - 1] / SIDE;
        beam.eye(camera, x0 + left, y0 + top, right - left + 1, bottom - top + 1);
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
            mirror(from, i);
            slot[i] = (short) i;
        }
        if (known == null && rays > 0) {
            beam.clear();
            beam.origins(from.px, from.py, from.pz, rays);
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

    /** The direction of a row's mirrored ray, as {@link SurfacePoint#mirrored}. */
    private void mirror(HitRows from, int r) {
        double nx = from.nx[r];
        double ny = from.ny[r];
        double nz = from.nz[r];
        double twice = 2 * Math.abs(nx * from.vx[r] + ny * from.vy[r] + nz * from.vz[r]);
        double rx = from.vx[r] + twice * nx;
        double ry = from.vy[r] + twice * ny;
        double rz = from.vz[r] + twice * nz;
        double length = Math.sqrt(rx * rx + ry * ry + rz * rz);
        dx[r] = rx / length;
        dy[r] = ry / length;
        dz[r] = rz / length;
    }

    /** Puts the mirrored rays of rows {@code row …} into the packet. */
    private void load(HitRows from, int row, int live) {
        for (int i = 0; i < live; i++) {
            packet.ox[i] = from.px[row + i];
            packet.oy[i] = from.py[row + i];
            packet.oz[i] = from.pz[row + i];
        }
        System.arraycopy(dx, row, packet.dx, 0, live);
        System.arraycopy(dy, row, packet.dy, 0, live);
        System.arraycopy(dz, row, packet.dz, 0, live);
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
                starts[shapes.material[shape[i]] + 1]++;
            }
        }
        boolean textured = false;
        for (int m = 0; m < materials.count(); m++) {
            textured |= starts[m + 1] > 0 && materials.isTextured(m);
            starts[m + 1] += starts[m];
        }
        int hits = starts[materials.count()];
        HitRows rows = allocator.rows(hits, textured);
        rows.count = hits;
        rows.runs = 0;
        rows.reflective = starts[materials.reflectiveCount()];
        for (int m = 0; m < materials.count(); m++) {
            if (starts[m + 1] > starts[m]) {
                rows.addRun(m, starts[m + 1]);
            }
        }
        for (int i = 0; i < rays; i++) {
            if (shape[i] >= 0) {
                order[starts[shapes.material[shape[i]]]++] = (short) i;
            }
        }
        for (int row = 0; row < hits; row += RayPacket.WIDTH) {
            surfaces(from, rows, row, Math.min(RayPacket.WIDTH, hits - row), textured);
        }
        return rows;
    }

    private void loadSorted(HitRows from, int row, int live) {
        for (int i = 0; i < live; i++) {
            int ray = order[row + i];
            packet.ox[i] = from == null ? 0 : from.px[ray];
            packet.oy[i] = from == null ? 0 : from.py[ray];
            packet.oz[i] = from == null ? 0 : from.pz[ray];
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
            textures(rows, row, live);
        }
        if (rows.code != null) {
            codes(rows, row, live);
        }
    }

    private void codes(HitRows rows, int row, int live) {
        for (int i = 0; i < live; i++) {
            int r = row + i;
            int hit = packet.shape[i];
            rows.code[r] = materials.isTextured(shapes.material[hit])
                    ? HitCode.of(hit, rows.nx[r], rows.ny[r], rows.nz[r], rows.diffuseRed[r], rows.diffuseGreen[r], rows.diffuseBlue[r])
                    : HitCode.of(hit, rows.nx[r], rows.ny[r], rows.nz[r]);
        }
    }

    private void textures(HitRows rows, int row, int live) {
        for (int i = 0; i < live; i++) {
            int material = shapes.material[packet.shape[i]];
            if (materials.isTextured(material)) {
                TextureLookup.sample(materials.texture(material), shapes.kind[packet.shape[i]],
                        surface.ownX[i], surface.ownY[i], surface.ownZ[i], texel);
                rows.diffuseRed[row + i] = materials.diffuse(material, 0) * texel[0];
                rows.diffuseGreen[row + i] = materials.diffuse(material, 1) * texel[1];
                rows.diffuseBlue[row + i] = materials.diffuse(material, 2) * texel[2];
            }
        }
    }
}

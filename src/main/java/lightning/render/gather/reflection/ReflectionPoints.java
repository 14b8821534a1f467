package lightning.render.gather.reflection;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SeenSurfaces;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RaySources;

/** Points on rough surfaces whose reflections are computed, with the views that they have. */
public final class ReflectionPoints {
    /** Places, shading normals and primitives. */
    final RaySources sources;
    final SeenSurfaces seen;
    /** Mirrored views: unit directions. */
    float[] rx = {};
    float[] ry = {};
    float[] rz = {};
    int[] material = {};
    /** Distance at which the weight of each point is 0, scene units. */
    float[] radius = {};
    /** Seed of each point's directions. */
    long[] seed = {};

    ReflectionPoints(CellKeys keys) {
        this(keys, new SeenSurfaces(1024));
    }

    private ReflectionPoints(CellKeys keys, SeenSurfaces seen) {
        this.seen = seen;
        sources = new RaySources(keys, seen.surfaces, false);
    }

    public int count() {
        return seen.count();
    }

    SurfaceColumns surface() {
        return seen.surfaces;
    }

    /** Appends a surface. */
    void add(SeenSurfaces from, int i, int itsMaterial, long itsSeed) {
        int p = count();
        if (p == rx.length) {
            resize(Math.max(1024, 2 * p));
            seed = Arrays.copyOf(seed, rx.length);
        }
        seen.add(from, i);
        float[] mirrored = new float[3];
        mirror(from.surfaces.nx[i], from.surfaces.ny[i], from.surfaces.nz[i], from.vx[i], from.vy[i], from.vz[i], mirrored);
        rx[p] = mirrored[0];
        ry[p] = mirrored[1];
        rz[p] = mirrored[2];
        material[p] = itsMaterial;
        seed[p] = itsSeed;
    }

    /** Appends a point at the place of another, with other directions. */
    void addCopy(int p, long itsSeed) {
        add(seen, p, material[p], itsSeed);
    }

    /** Keeps the first points only, and nothing that only their rays need, as {@link #readFrom}. */
    void trim(int count) {
        seen.trim(count);
        sources.reserveNormals(0);
        resize(count);
        seed = new long[0];
    }

    private void resize(int length) {
        rx = Arrays.copyOf(rx, length);
        ry = Arrays.copyOf(ry, length);
        rz = Arrays.copyOf(rz, length);
        material = Arrays.copyOf(material, length);
        radius = Arrays.copyOf(radius, length);
    }

    /** Writes the mirrored direction of a view that meets a normal: x, y, z. */
    public static void mirror(float nx, float ny, float nz, float vx, float vy, float vz, float[] to) {
        float twice = 2 * (nx * vx + ny * vy + nz * vz);
        to[0] = vx - twice * nx;
        to[1] = vy - twice * ny;
        to[2] = vz - twice * nz;
    }

    void writeTo(ColumnWriter out) throws IOException {
        seen.writeTo(out);
        for (float[] column : new float[][] {rx, ry, rz, radius}) {
            out.writeArray(Arrays.copyOf(column, count()));
        }
        out.writeArray(Arrays.copyOf(material, count()));
    }

    /** Reads points without the seeds of their directions. */
    static ReflectionPoints readFrom(ColumnReader in, CellKeys keys) throws IOException {
        var points = new ReflectionPoints(keys, SeenSurfaces.readFrom(in));
        points.rx = in.readFloats();
        points.ry = in.readFloats();
        points.rz = in.readFloats();
        points.radius = in.readFloats();
        points.material = in.readInts();
        return points;
    }

    long bytes() {
        return 68L * count() + seen.tangents.bytes();
    }
}

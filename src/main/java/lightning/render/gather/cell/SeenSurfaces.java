package lightning.render.gather.cell;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/** Surfaces that rays hit, with the directions of these rays. Render space. */
public final class SeenSurfaces {
    public final SurfaceColumns surfaces;
    /** Unit directions of the rays. */
    public float[] vx;
    public float[] vy;
    public float[] vz;
    /** Roughness of principled surfaces with their maps, 0…1; otherwise 0. */
    public float[] roughness;
    public final TangentColumns tangents;

    public SeenSurfaces(int capacity) {
        this(new SurfaceColumns(capacity), new TangentColumns(), capacity);
    }

    private SeenSurfaces(SurfaceColumns surfaces, TangentColumns tangents, int capacity) {
        this.surfaces = surfaces;
        this.tangents = tangents;
        vx = new float[capacity];
        vy = new float[capacity];
        vz = new float[capacity];
        roughness = new float[capacity];
    }

    public void writeTo(ColumnWriter out) throws IOException {
        surfaces.writeTo(out);
        tangents.writeTo(out);
        out.writeArray(Arrays.copyOf(vx, count()));
        out.writeArray(Arrays.copyOf(vy, count()));
        out.writeArray(Arrays.copyOf(vz, count()));
        out.writeArray(Arrays.copyOf(roughness, count()));
    }

    public static SeenSurfaces readFrom(ColumnReader in) throws IOException {
        var seen = new SeenSurfaces(SurfaceColumns.readFrom(in), TangentColumns.readFrom(in), 0);
        seen.vx = in.readFloats();
        seen.vy = in.readFloats();
        seen.vz = in.readFloats();
        seen.roughness = in.readFloats();
        return seen;
    }

    public int count() {
        return surfaces.count();
    }

    public void add(float px, float py, float pz, float nx, float ny, float nz, int primitive, float itsX, float itsY, float itsZ,
            float itsRoughness) {
        reserveViews(surfaces.count + 1);
        vx[surfaces.count] = itsX;
        vy[surfaces.count] = itsY;
        vz[surfaces.count] = itsZ;
        roughness[surfaces.count] = itsRoughness;
        surfaces.add(px, py, pz, nx, ny, nz, primitive);
    }

    /** Adds surface {@code i} of others. */
    public void add(SeenSurfaces o, int i) {
        tangents.set(count(), o.tangents, i);
        add(o.surfaces.px[i], o.surfaces.py[i], o.surfaces.pz[i], o.surfaces.nx[i], o.surfaces.ny[i], o.surfaces.nz[i],
                o.surfaces.primitive[i], o.vx[i], o.vy[i], o.vz[i], o.roughness[i]);
    }

    /** Keeps the first surfaces only, and no room for others. */
    public void trim(int count) {
        surfaces.trim(count);
        tangents.trim(count);
        vx = Arrays.copyOf(vx, count);
        vy = Arrays.copyOf(vy, count);
        vz = Arrays.copyOf(vz, count);
        roughness = Arrays.copyOf(roughness, count);
    }

    private void reserveViews(int count) {
        if (count > vx.length) {
            int length = Math.max(count, 2 * vx.length);
            vx = Arrays.copyOf(vx, length);
            vy = Arrays.copyOf(vy, length);
            vz = Arrays.copyOf(vz, length);
            roughness = Arrays.copyOf(roughness, length);
        }
    }
}

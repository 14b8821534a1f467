package lightning.meshes;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import lightning.base.file.AtomicFile;
import lightning.base.math.Vec3;

/**
 * Surface over the unit square, tessellated into a grid of quadrilaterals.
 *
 * @param across squares along u
 * @param rows   squares along v
 * @param closed true if u = 1 equals u = 0
 * @param form   the surface
 */
record ParametricSurface(int across, int rows, boolean closed, SurfaceFunction form) {
    /** Step of the finite differences for normals: the square root of a float's unit in the last place. */
    private static final double STEP = 0x1p-12;

    /** Surface function. */
    @FunctionalInterface
    interface SurfaceFunction {
        /** Returns the point at u and v from 0 to 1. Normals sample slightly outside this range; periodic in u if closed. */
        Vec3 at(double u, double v);
    }

    int triangles() {
        return 2 * across * rows;
    }

    private int columns() {
        return closed ? across : across + 1;
    }

    /** Writes a binary PLY file with vertex normals; counter-clockwise if u × v points outwards. */
    void write(Path file) throws IOException {
        int vertices = columns() * (rows + 1);
        byte[] header = String.format(Locale.ROOT, """
                ply
                format binary_little_endian 1.0
                element vertex %d
                property float x
                property float y
                property float z
                property float nx
                property float ny
                property float nz
                element face %d
                property list uchar int vertex_indices
                end_header
                """, vertices, across * rows).getBytes(StandardCharsets.US_ASCII);
        ByteBuffer bytes = ByteBuffer.allocate(header.length + 24 * vertices + 17 * across * rows).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header);
        for (int j = 0; j <= rows; j++) {
            for (int i = 0; i < columns(); i++) {
                put(bytes, form.at((double) i / across, (double) j / rows));
                put(bytes, normal((double) i / across, (double) j / rows));
            }
        }
        for (int j = 0; j < rows; j++) {
            for (int i = 0; i < across; i++) {
                int right = (i + 1) % columns();
                bytes.put((byte) 4).putInt(j * columns() + i).putInt(j * columns() + right);
                bytes.putInt((j + 1) * columns() + right).putInt((j + 1) * columns() + i);
            }
        }
        AtomicFile.write(file, out -> out.write(bytes.array()));
    }

    private Vec3 normal(double u, double v) {
        // At a pole all u map to one point; slightly next to it the surface has a normal.
        double w = Math.min(1 - STEP, Math.max(STEP, v));
        Vec3 du = form.at(u + STEP, w).minus(form.at(u - STEP, w));
        Vec3 dv = form.at(u, w + STEP / 2).minus(form.at(u, w - STEP / 2));
        return du.cross(dv).normalized();
    }

    private static void put(ByteBuffer bytes, Vec3 p) {
        bytes.putFloat((float) p.x()).putFloat((float) p.y()).putFloat((float) p.z());
    }
}

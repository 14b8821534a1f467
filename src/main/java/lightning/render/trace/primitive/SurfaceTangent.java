package lightning.render.trace.primitive;

import static lightning.render.trace.primitive.TangentFrame.cross;

import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.render.trace.solid.SolidKind;

/**
 * Tangent at a point of a surface, from which the rotation of an anisotropic material counts. Reused.
 *
 * <p>On a mesh with texture coordinates it is the direction in which u grows, on a plane the direction of its x axis. On other solids, and on meshes
 * without texture coordinates, it runs around the y axis of the object, through the middle of the mesh. It is transformed to the scene as the surface
 * is, and made perpendicular to the shading normal. Where there is no such direction, at a pole or on a triangle with one texture coordinate, it is a
 * fixed direction: the axis of the scene that is farthest from the normal.
 */
public final class SurfaceTangent {
    /** Squared sine of the angle to the normal below which a direction is too close to it. */
    private static final double MIN_SQUARE = 1e-12;
    /** Largest component of a normal whose axis is not taken instead; one component is always smaller. */
    private static final double FAR = 0.6;

    private final TrianglePoint facet = new TrianglePoint();
    private final double[] local = new double[3];

    /**
     * Computes the tangent at a point of primitive {@code s}.
     *
     * @param part part that was hit
     * @param x    point in local space; also {@code y}, {@code z}
     * @param nx   unit shading normal; also {@code ny}, {@code nz}
     * @param to   receives the unit tangent, {@code float[3]}
     */
    public void compute(PrimitiveTable primitives, int s, int part, double x, double y, double z, float nx, float ny, float nz,
            float[] to) {
        MeshSolid mesh = primitives.mesh(s);
        if (mesh != null) {
            facet.setPoint(mesh.mesh(), part, x, y, z);
            setMeshDirection(mesh, x, z);
        } else if (primitives.kind(s) == SolidKind.PLANE) {
            set(1, 0, 0);
        } else {
            set(z, 0, -x);
        }
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        // The transform itself, up to a factor, from the rows of its inverse, as in TangentFrame.
        double tx = local[0] * cross(m, i, 4, 8, 1, 2) + local[1] * cross(m, i, 8, 0, 1, 2) + local[2] * cross(m, i, 0, 4, 1, 2);
        double ty = local[0] * cross(m, i, 4, 8, 2, 0) + local[1] * cross(m, i, 8, 0, 2, 0) + local[2] * cross(m, i, 0, 4, 2, 0);
        double tz = local[0] * cross(m, i, 4, 8, 0, 1) + local[1] * cross(m, i, 8, 0, 0, 1) + local[2] * cross(m, i, 0, 4, 0, 1);
        double volume = m[i] * cross(m, i, 4, 8, 1, 2) + m[i + 1] * cross(m, i, 4, 8, 2, 0) + m[i + 2] * cross(m, i, 4, 8, 0, 1);
        double side = volume < 0 ? -1 : 1;
        if (!project(side * tx, side * ty, side * tz, nx, ny, nz, to)) {
            boolean isX = Math.abs(nx) < FAR;
            boolean isY = !isX && Math.abs(ny) < FAR;
            project(isX ? 1 : 0, isY ? 1 : 0, isX || isY ? 0 : 1, nx, ny, nz, to);
        }
    }

    private void setMeshDirection(MeshSolid mesh, double x, double z) {
        if (mesh.mesh().coordinates() == null) {
            set(z - mesh.middle(2), 0, mesh.middle(0) - x);
        } else if (facet.hasTangents()) {
            set(facet.tangent(0), facet.tangent(1), facet.tangent(2));
        } else if (mesh.mesh().normals() == null) {
            facet.growthOfU(local);
        } else {
            facet.interpolate(mesh.vertexTangents(), local);
        }
    }

    private void set(double x, double y, double z) {
        local[0] = x;
        local[1] = y;
        local[2] = z;
    }

    /** Makes a direction perpendicular to a normal and gives it length 1; returns false if it is 0 or along the normal. */
    private static boolean project(double x, double y, double z, float nx, float ny, float nz, float[] to) {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        double scale = 1 / largest;
        double ax = x * scale;
        double ay = y * scale;
        double az = z * scale;
        double normal = (double) nx * nx + (double) ny * ny + (double) nz * nz;
        double along = (ax * nx + ay * ny + az * nz) / normal;
        ax -= along * nx;
        ay -= along * ny;
        az -= along * nz;
        double square = ax * ax + ay * ay + az * az;
        // False for NaN and without any direction.
        if (!(square > MIN_SQUARE) || !(scale < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double unit = 1 / Math.sqrt(square);
        to[0] = (float) (ax * unit);
        to[1] = (float) (ay * unit);
        to[2] = (float) (az * unit);
        return true;
    }
}

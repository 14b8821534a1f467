package lightning.trace;

import java.util.List;
import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.scene.PlacedShape;
import lightning.scene.Shape;

/**
 * All shapes of a scene as plain columns, in render space.
 *
 * <p>Shape {@code s} has kind {@code kind[s]}, material index {@code material[s]}, and the map from
 * render space to its own space in {@code inverse[12 s …]}, row by row: m00 m01 m02 t0 m10 … t2.
 */
final class ShapeTable {
    static final int SPHERE = 0;
    static final int CONE = 1;
    static final int CYLINDER = 2;
    static final int PLANE = 3;

    final int count;
    final byte[] kind;
    final int[] material;
    final double[] inverse;
    /** A bound on the error of a hit point on the shape that its distance from the camera causes, scene units. */
    final double[] error;
    /** Boxes in render space, {@code double[6 * count]}: min x y z, max x y z. */
    final double[] bounds;
    /** A bound on how far {@code inverse} lets rays meet the shape outside {@code bounds}; {@code +∞} if nobody knows. */
    final double[] slack;

    /** @param materialOf the material index of each shape */
    ShapeTable(List<PlacedShape> shapes, int[] materialOf, Vec3 camera) {
        count = shapes.size();
        kind = new byte[count];
        material = materialOf;
        inverse = new double[12 * count];
        error = new double[count];
        bounds = new double[6 * count];
        slack = new double[count];
        for (int s = 0; s < count; s++) {
            Transform world = shapes.get(s).toWorld();
            Transform render = new Transform(
                    world.m00(), world.m01(), world.m02(), world.t0() - camera.x(),
                    world.m10(), world.m11(), world.m12(), world.t1() - camera.y(),
                    world.m20(), world.m21(), world.m22(), world.t2() - camera.z());
            kind[s] = kindOf(shapes.get(s).shape());
            Transform inverse = inverse(shapes.get(s).directionsBack(), render);
            store(s, inverse);
            ShapeBounds.of(kind[s], render, bounds, 6 * s);
            double reach = 0;
            for (int i = 6 * s; i < 6 * s + 6; i++) {
                reach = Math.max(reach, Math.abs(bounds[i]));
            }
            error[s] = reach * Surface.ERROR;
            slack[s] = ShapeBounds.slack(render, inverse, reach);
        }
    }

    /** Directions back, and the translation by which the place of the shape becomes the origin. */
    private static Transform inverse(Transform back, Transform render) {
        Vec3 origin = back.vector(new Vec3(render.t0(), render.t1(), render.t2()));
        return new Transform(back.m00(), back.m01(), back.m02(), -origin.x(), back.m10(), back.m11(), back.m12(), -origin.y(),
                back.m20(), back.m21(), back.m22(), -origin.z());
    }

    private static byte kindOf(Shape shape) {
        return (byte) switch (shape) {
            case Shape.Sphere _ -> SPHERE;
            case Shape.Cone _ -> CONE;
            case Shape.Cylinder _ -> CYLINDER;
            case Shape.Plane _ -> PLANE;
        };
    }

    private void store(int s, Transform m) {
        double[] rows = {m.m00(), m.m01(), m.m02(), m.t0(), m.m10(), m.m11(), m.m12(), m.t1(), m.m20(), m.m21(), m.m22(), m.t2()};
        System.arraycopy(rows, 0, inverse, 12 * s, 12);
    }

    /** The distance along the ray to shape {@code s}, or {@code +∞}. */
    double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        double[] m = inverse;
        int i = 12 * s;
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        return switch (kind[s]) {
            case SPHERE -> Solids.sphere(px, py, pz, vx, vy, vz);
            case CONE -> Solids.cone(px, py, pz, vx, vy, vz);
            case CYLINDER -> Solids.cylinder(px, py, pz, vx, vy, vz);
            default -> Solids.plane(px, py, pz, vx, vy, vz);
        };
    }
}

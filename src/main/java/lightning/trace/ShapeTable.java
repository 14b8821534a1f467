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

    /** The error of a way to a light as a share of the coordinates of its ends ({@link #off}). */
    static final double WAY = 0x1p-47;

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

    /** How far a point that was put on the shape may lie off it because shape and camera are rounded, scene units. */
    private final double[] off;
    /** How long a step of at most 1 along each axis of the scene can be in own units. */
    private final double[] rate;
    /** Whether the eye lies on the shape. */
    private final boolean[] underEye;
    /** How far the shape reaches from its place, scene units along an axis. */
    private final double[] size;
    /** More than the |x| + |y| + |z| of any point of a shape. */
    final double reach;

    /** @param materialOf the material index of each shape */
    ShapeTable(List<PlacedShape> shapes, int[] materialOf, Vec3 camera) {
        count = shapes.size();
        kind = new byte[count];
        material = materialOf;
        inverse = new double[12 * count];
        error = new double[count];
        bounds = new double[6 * count];
        slack = new double[count];
        off = new double[count];
        rate = new double[count];
        size = new double[count];
        underEye = new boolean[count];
        double farthest = 0;
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
            farthest = Math.max(farthest, reach);
            off(s, shapes.get(s), render, camera);
            underEye[s] = gap(s, 0, 0, 0) <= off[s];
        }
        reach = 4 * farthest;
    }

    /**
     * The bound on how far a point x that was put on the shape lies off the surface that rays meet, scene units.
     *
     * <p>Its own point is B·(x − place). A number of B is off by what {@code PlacementError} tells, times a distance within the
     * shape; the place by the same. Maximum norms, u = 2⁻⁵³: x and the camera are decimals made doubles and subtracted, u·(2|x|
     * + |camera|), the place u·|place|; mapping takes 4u·|x| + 4u·|place|, and for the eye, x = 0, only 3u·|place|. For the eye that
     * is all, with 4u in own units for the surface's formula, where 1 is no more than the shape's size in the scene.
     *
     * <p>A way from p to a light at x has errors of its own: 6u·|x| + u·|place| are left from above; 13u·|p| + 8u·|place| + 5u·|x| in
     * its map, and 8 units in the last place of its length in what {@link Solids} finds, 16u·(|p| + |place|) and 16u in own units.
     * As |place| ≤ |x| + size, all of it is less than 64u of |x|, |p| and the size.
     */
    private void off(int s, PlacedShape shape, Transform render, Vec3 camera) {
        Vec3 place = new Vec3(render.t0(), render.t1(), render.t2());
        int b = 6 * s;
        size[s] = Math.max(new Vec3(bounds[b], bounds[b + 1], bounds[b + 2]).minus(place).maxAbs(),
                new Vec3(bounds[b + 3], bounds[b + 4], bounds[b + 5]).minus(place).maxAbs());
        Transform back = shape.directionsBack().absolute();
        Transform error = shape.error().directionsBack();
        double x = back.m00() + back.m01() + back.m02();
        double y = back.m10() + back.m11() + back.m12();
        double z = back.m20() + back.m21() + back.m22();
        double turned = Math.max(Math.max((error.m00() + error.m01() + error.m02()) / x, (error.m10() + error.m11() + error.m12()) / y),
                (error.m20() + error.m21() + error.m22()) / z);
        rate[s] = new Vec3(x, y, z).length();
        off[s] = turned * size[s] + shape.error().place() + 0x1p-51 * (size[s] + place.maxAbs() + camera.maxAbs());
    }

    /**
     * How far a light that was put on a shape may lie off it, scene units.
     *
     * @param far the sum of |x| + |y| + |z| at both ends of a way to it, render space
     */
    double offLight(int s, double far) {
        return off[s] + WAY * (size[s] + far);
    }

    /** How far the eye may lie off a shape on which it was put, scene units. */
    double offEye(int s) {
        return off[s];
    }

    /** How long a step of at most 1 along each axis of the scene can be in the shape's own units. */
    double rate(int s) {
        return rate[s];
    }

    /**
     * How far a point in render space lies off the surface of a shape at least, scene units: from the patch on each axis
     * by itself; from a solid by its own distance, which changes by no more than a point moves, over how long a step of the
     * scene can be in it.
     */
    double gap(int s, double x, double y, double z) {
        double[] m = inverse;
        int i = 12 * s;
        double px = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        double py = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        double pz = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        double ring = Math.sqrt(px * px + pz * pz);
        return switch (kind[s]) {
            case SPHERE -> Math.abs(Math.sqrt(px * px + py * py + pz * pz) - 1) / rate[s];
            case CONE -> Math.min(Math.max(Math.abs(ring - (1 - py)) * Math.sqrt(0.5), -py), Math.max(Math.abs(py), ring - 1)) / rate[s];
            case CYLINDER -> Math.min(Math.max(Math.abs(ring - 1), Math.max(-py, py - 1)),
                    Math.max(Math.min(Math.abs(py), Math.abs(1 - py)), ring - 1)) / rate[s];
            default -> Math.max(Math.abs(py) / (Math.abs(m[i + 4]) + Math.abs(m[i + 5]) + Math.abs(m[i + 6])),
                    Math.max((Math.abs(px) - 0.5) / (Math.abs(m[i]) + Math.abs(m[i + 1]) + Math.abs(m[i + 2])),
                            (Math.abs(pz) - 0.5) / (Math.abs(m[i + 8]) + Math.abs(m[i + 9]) + Math.abs(m[i + 10]))));
        };
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

    /** Whether the eye lies on shape {@code s}: it then does not hide from the eye what is before it. */
    boolean isUnderEye(int s) {
        return underEye[s];
    }

    /** The distance along the ray to shape {@code s}, or {@code +∞}; a ray from the origin of render space is the eye's. */
    double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(s, ox, oy, oz, dx, dy, dz, underEye[s] && ox == 0 && oy == 0 && oz == 0 ? Touch.START : Touch.NEITHER);
    }

    /** The distance along a way of which an end may lie on shape {@code s}, or {@code +∞}. */
    double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz, Touch touch) {
        double[] m = inverse;
        int i = 12 * s;
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        if (touch != Touch.NEITHER) {
            double off = touch == Touch.START ? offEye(s) : offLight(s, Math.abs(ox + dx) + Math.abs(oy + dy) + Math.abs(oz + dz)
                    + Math.abs(ox) + Math.abs(oy) + Math.abs(oz));
            // The tip that a way cuts off an edge or an apex is at most four times as long as its end lies off the surface.
            double margin = 2 * 4 * rate[s] * off / Math.sqrt(vx * vx + vy * vy + vz * vz);
            return switch (kind[s]) {
                case SPHERE -> Solids.sphere(px, py, pz, vx, vy, vz, touch, margin);
                case CONE -> Solids.cone(px, py, pz, vx, vy, vz, touch, margin);
                case CYLINDER -> Solids.cylinder(px, py, pz, vx, vy, vz, touch, margin);
                default -> Solids.MISS;
            };
        }
        return switch (kind[s]) {
            case SPHERE -> Solids.sphere(px, py, pz, vx, vy, vz);
            case CONE -> Solids.cone(px, py, pz, vx, vy, vz);
            case CYLINDER -> Solids.cylinder(px, py, pz, vx, vy, vz);
            default -> Solids.plane(px, py, pz, vx, vy, vz);
        };
    }
}

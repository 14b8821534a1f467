package lightning.format.exchange.assembly;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.node.Mesh;

/** Bounding box of all added geometry. */
public final class Bounds {
    /** Bounds of every canonical solid: from −1 to 1. */
    public static final Bounds UNIT_CUBE = new Bounds(1);

    private final double[] min = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] max = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    Bounds() {}

    private Bounds(double size) {
        add(new Vec3(size, size, size));
        add(new Vec3(-size, -size, -size));
    }

    /** Returns the bounds of a mesh in its own space. */
    static Bounds of(Mesh mesh) {
        var bounds = new Bounds();
        float[] p = mesh.positions();
        for (int i = 0; i < p.length; i += 3) {
            bounds.add(new Vec3(p[i], p[i + 1], p[i + 2]));
        }
        return bounds;
    }

    /** Adds a transformed box. */
    public void add(Bounds other, Transform transform) {
        if (!other.isEmpty()) {
            for (int corner = 0; corner < 8; corner++) {
                add(transform.transformPoint(
                        new Vec3((corner & 1) == 0 ? other.min[0] : other.max[0], (corner & 2) == 0 ? other.min[1] : other.max[1],
                                (corner & 4) == 0 ? other.min[2] : other.max[2])));
            }
        }
    }

    private void add(Vec3 p) {
        double[] coordinates = {p.x(), p.y(), p.z()};
        for (int axis = 0; axis < 3; axis++) {
            min[axis] = Math.min(min[axis], coordinates[axis]);
            max[axis] = Math.max(max[axis], coordinates[axis]);
        }
    }

    private boolean isEmpty() {
        return !(min[0] <= max[0]);
    }

    /** Returns the lowest corner; the origin if the box is empty. */
    Vec3 min() {
        return isEmpty() ? Vec3.ZERO : new Vec3(min[0], min[1], min[2]);
    }

    /** Returns the highest corner; the origin if the box is empty. */
    Vec3 max() {
        return isEmpty() ? Vec3.ZERO : new Vec3(max[0], max[1], max[2]);
    }

    public Vec3 center() {
        return isEmpty() ? Vec3.ZERO : new Vec3((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
    }

    /** Returns half the diagonal, or 1 if the box is empty. */
    public double radius() {
        double radius = isEmpty() ? 0 : new Vec3(max[0] - min[0], max[1] - min[1], max[2] - min[2]).length() / 2;
        return radius > 0 ? radius : 1;
    }
}

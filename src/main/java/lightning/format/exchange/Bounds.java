package lightning.format.exchange;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Mesh;

/** The box around what was placed so far. */
final class Bounds {
    /** No canonical solid is larger than its box from −1 to 1. */
    static final Bounds SOLID = new Bounds(1);

    private final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    Bounds() {}

    private Bounds(double size) {
        add(new Vec3(size, size, size));
        add(new Vec3(-size, -size, -size));
    }

    /** A mesh in its own space. */
    static Bounds of(Mesh mesh) {
        var bounds = new Bounds();
        float[] p = mesh.positions();
        for (int i = 0; i < p.length; i += 3) {
            bounds.add(new Vec3(p[i], p[i + 1], p[i + 2]));
        }
        return bounds;
    }

    /** A box that a map brings here. */
    void add(Bounds other, Transform map) {
        if (!other.isEmpty()) {
            for (int corner = 0; corner < 8; corner++) {
                add(map.point(new Vec3((corner & 1) == 0 ? other.low[0] : other.high[0], (corner & 2) == 0 ? other.low[1] : other.high[1],
                        (corner & 4) == 0 ? other.low[2] : other.high[2])));
            }
        }
    }

    private void add(Vec3 p) {
        double[] at = {p.x(), p.y(), p.z()};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], at[axis]);
            high[axis] = Math.max(high[axis], at[axis]);
        }
    }

    private boolean isEmpty() {
        return !(low[0] <= high[0]);
    }

    Vec3 middle() {
        return isEmpty() ? Vec3.ZERO : new Vec3((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
    }

    /** Half the diagonal; 1 where there is none. */
    double radius() {
        double radius = isEmpty() ? 0 : new Vec3(high[0] - low[0], high[1] - low[1], high[2] - low[2]).length() / 2;
        return radius > 0 ? radius : 1;
    }
}

package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/** Conversion between render space and a primitive's local space, in which its solid is canonical. */
public final class LocalSpace {
    private LocalSpace() {}

    /** Converts a point from render space to a primitive's local space. */
    public static Vec3 toLocal(PrimitiveTable primitives, int s, Vec3 p) {
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        return new Vec3(m[i] * p.x() + m[i + 1] * p.y() + m[i + 2] * p.z() + m[i + 3],
                m[i + 4] * p.x() + m[i + 5] * p.y() + m[i + 6] * p.z() + m[i + 7],
                m[i + 8] * p.x() + m[i + 9] * p.y() + m[i + 10] * p.z() + m[i + 11]);
    }

    /** Converts a point from a primitive's local space to render space, by Cramer's rule. */
    public static Vec3 toRender(PrimitiveTable primitives, int s, Vec3 local) {
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        Vec3 x = new Vec3(m[i], m[i + 4], m[i + 8]);
        Vec3 y = new Vec3(m[i + 1], m[i + 5], m[i + 9]);
        Vec3 z = new Vec3(m[i + 2], m[i + 6], m[i + 10]);
        Vec3 p = local.minus(new Vec3(m[i + 3], m[i + 7], m[i + 11]));
        double volume = x.dot(y.cross(z));
        return new Vec3(p.dot(y.cross(z)) / volume, x.dot(p.cross(z)) / volume, x.dot(y.cross(p)) / volume);
    }
}

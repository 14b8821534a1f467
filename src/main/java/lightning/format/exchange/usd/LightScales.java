package lightning.format.exchange.usd;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/** Factors by which the transforms of lights scale their sizes. */
final class LightScales {
    private LightScales() {}

    /** Returns the lengths of the axes of a transform. */
    static Vec3 of(Transform m) {
        return UsdNumbers.rounded(new Vec3(m.transformVector(new Vec3(1, 0, 0)).length(), m.transformVector(Vec3.Y).length(),
                m.transformVector(new Vec3(0, 0, 1)).length()));
    }

    /** Returns the factor of a sphere's radius. */
    static double sphere(Vec3 scale) {
        return (scale.x() + scale.y() + scale.z()) / 3;
    }

    /** Returns the factor of a disk's radius. */
    static double disk(Vec3 scale) {
        return (scale.x() + scale.y()) / 2;
    }

    /** Returns the factor of a cylinder's radius; its length is along x. */
    static double tube(Vec3 scale) {
        return (scale.y() + scale.z()) / 2;
    }
}

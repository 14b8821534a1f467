package lightning.render.shading.layer;

import lightning.base.math.Vec3;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.trace.tree.PointBox;

/** Conservative test of a spot light's cone against a bounding box: if it misses the box, no point needs a test. */
final class ConeCulling {
    /** Exceeds the rounding errors of the cosines, both here and for a point. */
    private static final double MARGIN = 1e-9;
    /** Rounding error of a coordinate difference, in ulp of the largest coordinate. */
    private static final int ROUNDINGS = 4;

    private ConeCulling() {}

    /**
     * Returns whether {@link LightingEquation#insideCone} may hold for a point of the box. False is certain, true is not.
     *
     * <p>Seen from the light, the bounding sphere of the box lies within an angle β of its center's direction, where sin β is its
     * radius over its distance. Let θ be the angle between that direction and the axis. Every point of the sphere is at least θ − β
     * off the axis, so it is outside if cos(θ − β) is less than the cosine of the cone's half-angle. A sphere that contains the
     * light or touches the axis counts as reached. A sample of an area light at offset c sees point p as the center sees p − c, so
     * the sphere grows by the largest c.
     */
    static boolean canReach(LightSource source, PointBox box) {
        Vec3 position = source.position();
        double x = (box.low(0) + (double) box.high(0)) / 2 - position.x();
        double y = (box.low(1) + (double) box.high(1)) / 2 - position.y();
        double z = (box.low(2) + (double) box.high(2)) / 2 - position.z();
        double distance = Math.sqrt(x * x + y * y + z * z);
        double extent = source.isArea() ? (1 + MARGIN) * source.extent() : 0;
        double sinBeta = (boundingRadius(box) + extent + ROUNDINGS * Math.ulp(maxCoordinate(box, position))) / distance;
        if (!(sinBeta < 1)) {
            return true;
        }
        Vec3 axis = source.axis();
        double cosTheta = (x * axis.x() + y * axis.y() + z * axis.z()) / distance;
        double cosBeta = Math.sqrt(1 - sinBeta * sinBeta);
        if (!(cosTheta < cosBeta)) {
            return true;
        }
        double sinTheta = Math.sqrt(Math.max(0, 1 - cosTheta * cosTheta));
        return !(cosTheta * cosBeta + sinTheta * sinBeta < source.cosAngle() - MARGIN);
    }

    private static double boundingRadius(PointBox box) {
        double x = box.high(0) - (double) box.low(0);
        double y = box.high(1) - (double) box.low(1);
        double z = box.high(2) - (double) box.low(2);
        return (1 + MARGIN) * Math.sqrt(x * x + y * y + z * z) / 2;
    }

    private static double maxCoordinate(PointBox box, Vec3 position) {
        double largest = position.maxAbs();
        for (int axis = 0; axis < 3; axis++) {
            largest = Math.max(largest, Math.max(Math.abs(box.low(axis)), Math.abs(box.high(axis))));
        }
        return largest;
    }
}

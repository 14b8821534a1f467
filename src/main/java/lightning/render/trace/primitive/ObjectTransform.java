package lightning.render.trace.primitive;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.PlacedShape;

/** Transforms between a shape's local space and render space, with an error bound of the inverse. */
final class ObjectTransform {
    /** Transform from local space to render space. */
    final Transform toRenderSpace;
    /** Local origin in render space. */
    final Vec3 renderOrigin;
    final Transform inverse;
    private final PlacedShape shape;

    ObjectTransform(PlacedShape shape, Vec3 camera) {
        this.shape = shape;
        toRenderSpace = toRenderSpace(shape.toWorld(), camera);
        renderOrigin = new Vec3(toRenderSpace.t0(), toRenderSpace.t1(), toRenderSpace.t2());
        inverse = inverse(shape.directionsToLocal(), renderOrigin);
    }

    /** Returns the error bound of an element of the inverse transform of directions, relative to its row. */
    double inverseRelativeError() {
        Vec3 rowSums = rowSums(shape.directionsToLocal().absolute());
        Vec3 rowErrors = rowSums(shape.error().directionsToLocal());
        return Math.max(Math.max(rowErrors.x() / rowSums.x(), rowErrors.y() / rowSums.y()), rowErrors.z() / rowSums.z());
    }

    /** Returns the row sums of a transform without its translation; all elements are non-negative. */
    private static Vec3 rowSums(Transform m) {
        return new Vec3(m.m00() + m.m01() + m.m02(), m.m10() + m.m11() + m.m12(), m.m20() + m.m21() + m.m22());
    }

    /** Converts a transform to the scene into one to render space, with the camera as origin. */
    private static Transform toRenderSpace(Transform m, Vec3 camera) {
        return new Transform(m.m00(), m.m01(), m.m02(), m.t0() - camera.x(), m.m10(), m.m11(), m.m12(), m.t1() - camera.y(),
                m.m20(), m.m21(), m.m22(), m.t2() - camera.z());
    }

    /** Combines the inverse transform of directions with the translation that moves the shape's position to the origin. */
    private static Transform inverse(Transform directionsToLocal, Vec3 place) {
        Vec3 origin = directionsToLocal.transformVector(place);
        return new Transform(directionsToLocal.m00(), directionsToLocal.m01(), directionsToLocal.m02(), -origin.x(),
                directionsToLocal.m10(), directionsToLocal.m11(), directionsToLocal.m12(), -origin.y(),
                directionsToLocal.m20(), directionsToLocal.m21(), directionsToLocal.m22(), -origin.z());
    }

    /** Writes the inverse row by row to {@code to[i … i + 11]}. */
    void storeInverse(double[] to, int i) {
        to[i] = inverse.m00();
        to[i + 1] = inverse.m01();
        to[i + 2] = inverse.m02();
        to[i + 3] = inverse.t0();
        to[i + 4] = inverse.m10();
        to[i + 5] = inverse.m11();
        to[i + 6] = inverse.m12();
        to[i + 7] = inverse.t1();
        to[i + 8] = inverse.m20();
        to[i + 9] = inverse.m21();
        to[i + 10] = inverse.m22();
        to[i + 11] = inverse.t2();
    }
}

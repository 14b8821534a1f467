package lightning.trace;

import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.scene.PlacedShape;

/** Where primitives stand in the scene and how exact that is, as plain columns: what all cameras see alike. */
final class PrimitivePlaces {
    /** How long a step of at most 1 along each axis of the scene can be in a primitive's own units. */
    final double[] rate;

    /** The maps from the primitives' own spaces to the scene, {@code double[12 * count]} row by row. */
    private final double[] toScene;
    /** How far a number of the map of directions back may be off, as a share of the row that it is in. */
    private final double[] turned;
    /** How far a primitive's place may be off, scene units. */
    private final double[] moved;

    PrimitivePlaces(int count) {
        rate = new double[count];
        toScene = new double[12 * count];
        turned = new double[count];
        moved = new double[count];
    }

    void put(int s, PlacedShape shape) {
        store(shape.toWorld(), toScene, 12 * s);
        Transform back = shape.directionsBack().absolute();
        Transform error = shape.error().directionsBack();
        double x = back.m00() + back.m01() + back.m02();
        double y = back.m10() + back.m11() + back.m12();
        double z = back.m20() + back.m21() + back.m22();
        turned[s] = Math.max(Math.max((error.m00() + error.m01() + error.m02()) / x, (error.m10() + error.m11() + error.m12()) / y),
                (error.m20() + error.m21() + error.m22()) / z);
        rate[s] = new Vec3(x, y, z).length();
        moved[s] = shape.error().place();
    }

    /** The map from a primitive's own space to that whose origin is the camera. */
    Transform toRender(int s, Vec3 camera) {
        double[] m = toScene;
        int i = 12 * s;
        return new Transform(m[i], m[i + 1], m[i + 2], m[i + 3] - camera.x(),
                m[i + 4], m[i + 5], m[i + 6], m[i + 7] - camera.y(), m[i + 8], m[i + 9], m[i + 10], m[i + 11] - camera.z());
    }

    /** How far a point may lie off a primitive because its placement is rounded, scene units. */
    double error(int s, double size) {
        return turned[s] * size + moved[s];
    }

    /** Writes a map row by row to {@code to[i … i + 11]}. */
    static void store(Transform m, double[] to, int i) {
        to[i] = m.m00();
        to[i + 1] = m.m01();
        to[i + 2] = m.m02();
        to[i + 3] = m.t0();
        to[i + 4] = m.m10();
        to[i + 5] = m.m11();
        to[i + 6] = m.m12();
        to[i + 7] = m.t1();
        to[i + 8] = m.m20();
        to[i + 9] = m.m21();
        to[i + 10] = m.m22();
        to[i + 11] = m.t2();
    }
}

package lightning.trace;

import lightning.math.Transform;

/** The smallest axis-aligned box around a placed canonical solid, in double precision. */
final class ShapeBounds {
    private ShapeBounds() {}

    /** Writes min x y z, max x y z to {@code box[at …]}. */
    static void of(int kind, Transform m, double[] box, int at) {
        axis(kind, m.m00(), m.m01(), m.m02(), m.t0(), box, at);
        axis(kind, m.m10(), m.m11(), m.m12(), m.t1(), box, at + 1);
        axis(kind, m.m20(), m.m21(), m.m22(), m.t2(), box, at + 2);
    }

    /** One axis: the extent of {@code mx·x + my·y + mz·z + t} over the solid. */
    private static void axis(int kind, double mx, double my, double mz, double t, double[] box, int at) {
        double disc = Math.sqrt(mx * mx + mz * mz);
        double top = t + my;
        double low;
        double high;
        switch (kind) {
            case ShapeTable.SPHERE -> {
                double radius = Math.sqrt(mx * mx + my * my + mz * mz);
                low = t - radius;
                high = t + radius;
            }
            case ShapeTable.CYLINDER -> {
                low = Math.min(t, top) - disc;
                high = Math.max(t, top) + disc;
            }
            case ShapeTable.CONE -> {
                low = Math.min(t - disc, top);
                high = Math.max(t + disc, top);
            }
            default -> {
                double half = 0.5 * (Math.abs(mx) + Math.abs(mz));
                low = t - half;
                high = t + half;
            }
        }
        box[at] = low;
        box[at + 3] = high;
    }
}

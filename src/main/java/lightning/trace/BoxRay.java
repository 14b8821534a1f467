package lightning.trace;

/** One ray to be tested against padded boxes, in double. */
final class BoxRay {
    /** Finite, so that a ray within a box's plane makes no NaN. */
    private static final double STEEPEST = 0x1p900;

    private final double ox;
    private final double oy;
    private final double oz;
    private final double inverseX;
    private final double inverseY;
    private final double inverseZ;

    BoxRay(Ray ray) {
        ox = ray.origin().x();
        oy = ray.origin().y();
        oz = ray.origin().z();
        inverseX = inverse(ray.direction().x());
        inverseY = inverse(ray.direction().y());
        inverseZ = inverse(ray.direction().z());
    }

    private static double inverse(double d) {
        return Math.clamp(1 / d, -STEEPEST, STEEPEST);
    }

    /** Whether the ray goes towards greater coordinates on the axis. */
    boolean forwards(int axis) {
        return (axis == 0 ? inverseX : axis == 1 ? inverseY : inverseZ) > 0;
    }

    /** Whether the ray may meet the box {@code boxes[at … at + 5]} at a distance up to {@code limit}. */
    boolean hits(float[] boxes, int at, double limit) {
        double x0 = (boxes[at] - ox) * inverseX;
        double x1 = (boxes[at + 3] - ox) * inverseX;
        double y0 = (boxes[at + 1] - oy) * inverseY;
        double y1 = (boxes[at + 4] - oy) * inverseY;
        double z0 = (boxes[at + 2] - oz) * inverseZ;
        double z1 = (boxes[at + 5] - oz) * inverseZ;
        double in = Math.max(Math.max(Math.min(x0, x1), Math.min(y0, y1)), Math.max(Math.min(z0, z1), 0));
        double out = Math.min(Math.min(Math.max(x0, x1), Math.max(y0, y1)), Math.min(Math.max(z0, z1), limit));
        return in <= out;
    }
}

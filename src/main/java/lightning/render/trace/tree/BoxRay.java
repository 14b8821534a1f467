package lightning.render.trace.tree;

/** Ray in double precision for tests against padded boxes. Reused. */
public final class BoxRay {
    /** Finite, so that a ray within a box's plane produces no NaN. */
    private static final double MAX_INVERSE = 0x1p900;

    private double ox;
    private double oy;
    private double oz;
    private double inverseX;
    private double inverseY;
    private double inverseZ;

    /** Sets the ray. */
    public void setRay(double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        ox = originX;
        oy = originY;
        oz = originZ;
        inverseX = inverse(directionX);
        inverseY = inverse(directionY);
        inverseZ = inverse(directionZ);
    }

    private static double inverse(double d) {
        double inverse = 1 / d;
        return inverse < -MAX_INVERSE ? -MAX_INVERSE : inverse > MAX_INVERSE ? MAX_INVERSE : inverse;
    }

    /** Returns whether the ray has a positive direction on the axis. */
    boolean isForward(int axis) {
        return (axis == 0 ? inverseX : axis == 1 ? inverseY : inverseZ) > 0;
    }

    /** Returns whether the ray may hit the box {@code boxes[at … at + 5]} at a distance up to {@code limit}. */
    public boolean hits(float[] boxes, int at, double limit) {
        double in = 0;
        double out = limit;
        double a = (boxes[at] - ox) * inverseX;
        double b = (boxes[at + 3] - ox) * inverseX;
        in = min(a, b) > in ? min(a, b) : in;
        out = max(a, b) < out ? max(a, b) : out;
        a = (boxes[at + 1] - oy) * inverseY;
        b = (boxes[at + 4] - oy) * inverseY;
        in = min(a, b) > in ? min(a, b) : in;
        out = max(a, b) < out ? max(a, b) : out;
        a = (boxes[at + 2] - oz) * inverseZ;
        b = (boxes[at + 5] - oz) * inverseZ;
        in = min(a, b) > in ? min(a, b) : in;
        out = max(a, b) < out ? max(a, b) : out;
        return in <= out;
    }

    /** Math.min without its order of ±0, which is irrelevant here, and without NaN, which cannot occur. */
    private static double min(double a, double b) {
        return a < b ? a : b;
    }

    private static double max(double a, double b) {
        return a < b ? b : a;
    }
}

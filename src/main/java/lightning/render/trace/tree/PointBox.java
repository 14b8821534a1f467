package lightning.render.trace.tree;

/** Axis-aligned bounds of points in render space. */
public final class PointBox {
    private final float[] low = new float[3];
    private final float[] high = new float[3];

    public void set(int axis, float min, float max) {
        low[axis] = min;
        high[axis] = max;
    }

    /** Sets the bounds of one point. */
    public void set(float x, float y, float z) {
        set(0, x, x);
        set(1, y, y);
        set(2, z, z);
    }

    /** Returns the minimum on axis 0, 1 or 2. */
    public float low(int axis) {
        return low[axis];
    }

    /** Returns the maximum on axis 0, 1 or 2. */
    public float high(int axis) {
        return high[axis];
    }
}

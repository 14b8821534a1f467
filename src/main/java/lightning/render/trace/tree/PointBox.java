package lightning.render.trace.tree;

/** The smallest box, along the axes of render space, that holds some points. */
public final class PointBox {
    private final float[] low = new float[3];
    private final float[] high = new float[3];

    public void set(int axis, float min, float max) {
        low[axis] = min;
        high[axis] = max;
    }

    /** The lower side across axis 0, 1 or 2. */
    public float low(int axis) {
        return low[axis];
    }

    /** The upper side across axis 0, 1 or 2. */
    public float high(int axis) {
        return high[axis];
    }
}

package lightning.trace;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** The smallest box, along the axes of render space, that holds some points. */
public final class PointBox {
    private static final VectorSpecies<Float> LANES = FloatVector.SPECIES_PREFERRED;

    private final float[] low = new float[3];
    private final float[] high = new float[3];

    /** The box of points {@code 0 … count − 1}, at least one. */
    PointBox(float[] x, float[] y, float[] z, int count) {
        column(0, x, count);
        column(1, y, count);
        column(2, z, count);
    }

    private void column(int axis, float[] v, int count) {
        FloatVector least = FloatVector.broadcast(LANES, v[0]);
        FloatVector most = least;
        int i = 0;
        for (; i + LANES.length() <= count; i += LANES.length()) {
            FloatVector x = FloatVector.fromArray(LANES, v, i);
            least = least.min(x);
            most = most.max(x);
        }
        low[axis] = least.reduceLanes(VectorOperators.MIN);
        high[axis] = most.reduceLanes(VectorOperators.MAX);
        for (; i < count; i++) {
            low[axis] = Math.min(low[axis], v[i]);
            high[axis] = Math.max(high[axis], v[i]);
        }
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

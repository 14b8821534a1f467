package lightning.render.trace.solid;

import jdk.incubator.vector.FloatVector;

/** Small batch of rays, one per lane. */
public class LaneRays {
    /** Capacity: the number of float lanes of this CPU. */
    public static final int WIDTH = FloatVector.SPECIES_PREFERRED.length();

    /** Origins and directions (any length), render space; {@code double[WIDTH]} each. */
    public final double[] ox = new double[WIDTH];
    public final double[] oy = new double[WIDTH];
    public final double[] oz = new double[WIDTH];
    public final double[] dx = new double[WIDTH];
    public final double[] dy = new double[WIDTH];
    public final double[] dz = new double[WIDTH];
}

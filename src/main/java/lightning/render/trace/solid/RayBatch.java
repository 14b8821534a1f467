package lightning.render.trace.solid;

import jdk.incubator.vector.FloatVector;

/** A handful of rays, one lane each. */
public class RayBatch {
    /** How many rays fit: the float lanes of this machine. */
    public static final int WIDTH = FloatVector.SPECIES_PREFERRED.length();

    /** Origins and directions (any length), render space; {@code double[WIDTH]} each. */
    public final double[] ox = new double[WIDTH];
    public final double[] oy = new double[WIDTH];
    public final double[] oz = new double[WIDTH];
    public final double[] dx = new double[WIDTH];
    public final double[] dy = new double[WIDTH];
    public final double[] dz = new double[WIDTH];
}

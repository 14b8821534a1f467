package lightning.trace;

/**
 * A handful of rays that travel together, one lane each, and what they met. Reused for packet after
 * packet; not shared between threads.
 */
public final class RayPacket {
    /** How many rays fit: the float lanes of this machine. */
    public static final int WIDTH = jdk.incubator.vector.FloatVector.SPECIES_PREFERRED.length();

    /** Origins and directions (any length), render space; {@code double[WIDTH]} each. */
    public final double[] ox = new double[WIDTH];
    public final double[] oy = new double[WIDTH];
    public final double[] oz = new double[WIDTH];
    public final double[] dx = new double[WIDTH];
    public final double[] dy = new double[WIDTH];
    public final double[] dz = new double[WIDTH];
    /** Shapes at this distance or beyond do not block; only {@link PacketTracer#blocked} asks. */
    public final double[] limit = new double[WIDTH];
    /** Where the ways end at distance 1, if they end at a light; only {@link PacketTracer#blocked} asks. */
    public WayEnd end = WayEnd.OPEN;

    /** The distance of the nearest hit, {@code +∞} for a miss. */
    public final double[] t = new double[WIDTH];
    /** The shape of the nearest hit, −1 for a miss. */
    public final int[] shape = new int[WIDTH];
}

package lightning.trace;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;

/**
 * A packet's rays in the space of one shape: the lanes' form of the first half of
 * {@link ShapeTable#distance}. The second half, one class for each solid, reads them from here.
 *
 * <p>All lane code works on a range of lanes {@code from … to − 1}, a multiple of {@link #LANES}, and
 * goes from array to array: methods that hand vectors to each other allocate when they are too big
 * to be inlined.
 */
final class OwnRays {
    static final VectorSpecies<Double> SPECIES = DoubleVector.SPECIES_PREFERRED;
    /** How many doubles one vector holds. */
    static final int LANES = SPECIES.length();

    final double[] ox = new double[RayPacket.WIDTH];
    final double[] oy = new double[RayPacket.WIDTH];
    final double[] oz = new double[RayPacket.WIDTH];
    final double[] dx = new double[RayPacket.WIDTH];
    final double[] dy = new double[RayPacket.WIDTH];
    final double[] dz = new double[RayPacket.WIDTH];
    /** What the solids answer: distances, or {@code +∞}. */
    final double[] t = new double[RayPacket.WIDTH];

    /** Maps the packet's rays into the space of shape {@code s}. */
    void enter(double[] inverse, int s, RayPacket p, int from, int to) {
        row(inverse, 12 * s, p, ox, dx, from, to);
        row(inverse, 12 * s + 4, p, oy, dy, from, to);
        row(inverse, 12 * s + 8, p, oz, dz, from, to);
    }

    private static void row(double[] m, int i, RayPacket p, double[] o, double[] d, int from, int to) {
        double mx = m[i];
        double my = m[i + 1];
        double mz = m[i + 2];
        double mt = m[i + 3];
        for (int h = from; h < to; h += LANES) {
            DoubleVector.fromArray(SPECIES, p.ox, h).mul(mx)
                    .add(DoubleVector.fromArray(SPECIES, p.oy, h).mul(my))
                    .add(DoubleVector.fromArray(SPECIES, p.oz, h).mul(mz))
                    .add(mt)
                    .intoArray(o, h);
            DoubleVector.fromArray(SPECIES, p.dx, h).mul(mx)
                    .add(DoubleVector.fromArray(SPECIES, p.dy, h).mul(my))
                    .add(DoubleVector.fromArray(SPECIES, p.dz, h).mul(mz))
                    .intoArray(d, h);
        }
    }
}

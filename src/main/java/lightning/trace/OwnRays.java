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
        // All read before the first store, after which the compiler would read them again.
        int i = 12 * s;
        double m00 = inverse[i];
        double m01 = inverse[i + 1];
        double m02 = inverse[i + 2];
        double t0 = inverse[i + 3];
        double m10 = inverse[i + 4];
        double m11 = inverse[i + 5];
        double m12 = inverse[i + 6];
        double t1 = inverse[i + 7];
        double m20 = inverse[i + 8];
        double m21 = inverse[i + 9];
        double m22 = inverse[i + 10];
        double t2 = inverse[i + 11];
        for (int h = from; h < to; h += LANES) {
            DoubleVector x = DoubleVector.fromArray(SPECIES, p.ox, h);
            DoubleVector y = DoubleVector.fromArray(SPECIES, p.oy, h);
            DoubleVector z = DoubleVector.fromArray(SPECIES, p.oz, h);
            x.mul(m00).add(y.mul(m01)).add(z.mul(m02)).add(t0).intoArray(ox, h);
            x.mul(m10).add(y.mul(m11)).add(z.mul(m12)).add(t1).intoArray(oy, h);
            x.mul(m20).add(y.mul(m21)).add(z.mul(m22)).add(t2).intoArray(oz, h);
            x = DoubleVector.fromArray(SPECIES, p.dx, h);
            y = DoubleVector.fromArray(SPECIES, p.dy, h);
            z = DoubleVector.fromArray(SPECIES, p.dz, h);
            x.mul(m00).add(y.mul(m01)).add(z.mul(m02)).intoArray(dx, h);
            x.mul(m10).add(y.mul(m11)).add(z.mul(m12)).intoArray(dy, h);
            x.mul(m20).add(y.mul(m21)).add(z.mul(m22)).intoArray(dz, h);
        }
    }
}

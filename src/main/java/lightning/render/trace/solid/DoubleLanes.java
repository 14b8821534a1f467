package lightning.render.trace.solid;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;

/**
 * Rays in lanes of doubles.
 *
 * <p>All lane code works on whole vectors, the lanes {@code from … to − 1} with both a multiple of
 * {@link #COUNT}, and goes from array to array. Not even a tiny helper may take or return vectors: kernels of this size are
 * inlined late, and a vector that crosses a call until then is boxed (measured: 192 bytes and a fifth of
 * the time per packet). That is why each solid spells out how a ray is mapped into its space.
 */
public final class DoubleLanes {
    public static final VectorSpecies<Double> SPECIES = DoubleVector.SPECIES_PREFERRED;
    /** How many doubles one vector holds: half as many as a packet has rays. */
    public static final int COUNT = SPECIES.length();

    private DoubleLanes() {}
}

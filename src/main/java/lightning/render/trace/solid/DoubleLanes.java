package lightning.render.trace.solid;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;

/**
 * Shape of double vectors that hold one ray per lane.
 *
 * <p>All lane code processes whole vectors, the lanes {@code from … to − 1} with both a multiple of {@link #COUNT}, from array
 * to array. No method, however small, may take or return vectors: kernels of this size are inlined late, and until then a
 * vector that crosses a call is boxed (measured: 192 bytes and a fifth of the time per packet). For this reason each solid
 * repeats the code that maps a ray into its space.
 */
public final class DoubleLanes {
    public static final VectorSpecies<Double> SPECIES = DoubleVector.SPECIES_PREFERRED;
    /** Doubles per vector: half as many as a packet has rays. */
    public static final int COUNT = SPECIES.length();

    private DoubleLanes() {}
}

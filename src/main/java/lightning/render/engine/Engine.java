package lightning.render.engine;

import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/**
 * Implementation of tracing, lighting terms and sums for the rows of a tile. All engines return the same bits.
 *
 * <p>Engines are selected per tile, so tiles of one image may come from several. Thread-safe; the objects it creates hold
 * scratch memory, one per thread.
 */
public interface Engine {
    /** Creates a tracer, which finds the hit rows of tiles. */
    Tracer tracer(Geometry geometry);

    /** Creates the kernel that computes a light's terms for rows. */
    TermKernel terms();

    /** Creates the kernel that composes rows. */
    SumKernel sums();
}

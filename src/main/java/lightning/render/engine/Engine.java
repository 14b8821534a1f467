package lightning.render.engine;

import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/**
 * What does the work on the rows of a tile, in one of several ways that give the same bits: finds what rays hit, fills a
 * light's rows, and composes them. Engines are asked for one tile at a time, so that tiles of one picture may come from
 * several. Shared between threads; what it gives holds scratch memory, one for each thread.
 */
public interface Engine {
    /** What finds the hit rows of tiles. */
    Tracer tracer(Geometry geometry);

    /** What fills a light's rows. */
    TermKernel terms();

    /** What composes rows. */
    SumKernel sums();
}

package lightning.render.engine.scalar;

import lightning.render.engine.Engine;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/**
 * The engine whose kernels are plain loops over rays and rows: the readable twin of the lanes, quick from the first tile of a
 * process on, and the only one where a machine has no lanes worth it.
 */
public record ScalarEngine() implements Engine {
    @Override
    public Tracer tracer(Geometry geometry) {
        return new ScalarTracer(geometry);
    }

    @Override
    public TermKernel terms() {
        return new ScalarTerms();
    }

    @Override
    public SumKernel sums() {
        return new ScalarSums();
    }
}

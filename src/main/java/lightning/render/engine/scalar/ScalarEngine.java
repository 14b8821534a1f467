package lightning.render.engine.scalar;

import lightning.render.engine.Engine;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/**
 * Engine with plain loops over rays and rows: the readable counterpart of the lanes. Fast from the first tile of a process on,
 * and the only engine on machines without useful lanes.
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

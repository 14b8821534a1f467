package lightning.engine.scalar;

import lightning.engine.Engine;
import lightning.shading.Sums;
import lightning.shading.Terms;
import lightning.trace.Geometry;
import lightning.trace.Tracer;

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
    public Terms terms() {
        return new ScalarTerms();
    }

    @Override
    public Sums sums() {
        return new ScalarSums();
    }
}

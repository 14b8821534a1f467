package lightning.render.engine.lanes;

import jdk.incubator.vector.FloatVector;
import lightning.render.engine.Engine;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/** Engine with vectorized kernels for rays and rows: the fastest once its code is compiled. */
public record LaneEngine() implements Engine {
    /**
     * Minimum floats per vector for which lanes pay off; with four, that is two doubles, a packet is hardly larger than a ray.
     */
    private static final int MIN_FLOAT_LANES = 8;

    /** Returns whether this CPU's vectors are wide enough; the vector module must be present. */
    public static boolean hasWideVectors() {
        return FloatVector.SPECIES_PREFERRED.length() >= MIN_FLOAT_LANES;
    }

    @Override
    public Tracer tracer(Geometry geometry) {
        return geometry.primitives().hasMeshes() ? new MeshLaneTracer(geometry) : new LaneTracer(geometry);
    }

    @Override
    public TermKernel terms() {
        return new LightLanes();
    }

    @Override
    public SumKernel sums() {
        return new SumLanes();
    }
}

package lightning.render.engine.lanes;

import jdk.incubator.vector.FloatVector;
import lightning.render.engine.Engine;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.trace.Geometry;
import lightning.render.trace.Tracer;

/** The engine whose kernels go over rays and rows in vector lanes: the fastest once its code is compiled. */
public record LaneEngine() implements Engine {
    /** Floats in a vector from which on lanes pay: of four, two doubles, a packet is hardly more than a ray. */
    private static final int MIN_FLOAT_LANES = 8;

    /** Whether this machine's vectors are wide enough to pay; the vector module must be there. */
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

package lightning.render.engine.lanes;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;

/** Vectors of doubles from columns of floats. */
final class ColumnLanes {
    static final VectorSpecies<Double> D = DoubleLanes.SPECIES;
    /** As many floats as a vector has doubles. */
    static final VectorSpecies<Float> F = VectorSpecies.of(float.class, VectorShape.forBitSize(D.vectorBitSize() / 2));

    private ColumnLanes() {}

    /** Returns the values of rows from {@code i} on, one in each lane. */
    static DoubleVector load(float[] column, int i) {
        return (DoubleVector) FloatVector.fromArray(F, column, i).castShape(D, 0);
    }
}

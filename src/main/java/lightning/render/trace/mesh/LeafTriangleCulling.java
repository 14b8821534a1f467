package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.LE;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;

/**
 * Culling of a leaf's triangles by the signs of {@link MeshRay} in floats, with a margin for all their errors. Proof of the
 * margin: docs/numerics.md, "Proof: leaf culling".
 */
final class LeafTriangleCulling {
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;

    private LeafTriangleCulling() {}

    /**
     * Returns the slots of a leaf whose triangles a line may hit.
     *
     * @param v the leaves' vertices; those of the first slot begin at {@code x}, {@code y} and {@code z}; the line runs along z
     * @param ox origin of the line in that order of axes; also {@code oy} and {@code oz}
     * @param shearX step of the line along x per step of 1 along z; also {@code shearY}
     * @param w width of the line
     * @param extent longest side of the leaf's box
     */
    static int candidateSlots(float[] v, int x, int y, int z, float ox, float oy, float oz, float shearX, float shearY, float w,
            float extent) {
        FloatVector sx = FloatVector.broadcast(EIGHT, -shearX);
        FloatVector sy = FloatVector.broadcast(EIGHT, -shearY);
        FloatVector az = FloatVector.fromArray(EIGHT, v, z).sub(oz);
        FloatVector ax = az.fma(sx, FloatVector.fromArray(EIGHT, v, x).sub(ox));
        FloatVector ay = az.fma(sy, FloatVector.fromArray(EIGHT, v, y).sub(oy));
        FloatVector bz = FloatVector.fromArray(EIGHT, v, MeshTree.CORNER_FLOATS + z).sub(oz);
        FloatVector bx = bz.fma(sx, FloatVector.fromArray(EIGHT, v, MeshTree.CORNER_FLOATS + x).sub(ox));
        FloatVector by = bz.fma(sy, FloatVector.fromArray(EIGHT, v, MeshTree.CORNER_FLOATS + y).sub(oy));
        FloatVector cz = FloatVector.fromArray(EIGHT, v, 2 * MeshTree.CORNER_FLOATS + z).sub(oz);
        FloatVector cx = cz.fma(sx, FloatVector.fromArray(EIGHT, v, 2 * MeshTree.CORNER_FLOATS + x).sub(ox));
        FloatVector cy = cz.fma(sy, FloatVector.fromArray(EIGHT, v, 2 * MeshTree.CORNER_FLOATS + y).sub(oy));
        FloatVector edgeA = cx.mul(by).sub(cy.mul(bx));
        FloatVector edgeB = ax.mul(cy).sub(ay.mul(cx));
        FloatVector edgeC = bx.mul(ay).sub(by.mul(ax));
        float margin = 7 * w * (extent + w) + Float.MIN_NORMAL;
        FloatVector max = FloatVector.broadcast(EIGHT, margin);
        FloatVector min = FloatVector.broadcast(EIGHT, -margin);
        VectorMask<Float> allAboveMin = edgeA.compare(GE, min).and(edgeB.compare(GE, min)).and(edgeC.compare(GE, min));
        VectorMask<Float> allBelowMax = edgeA.compare(LE, max).and(edgeB.compare(LE, max)).and(edgeC.compare(LE, max));
        return (int) allAboveMin.or(allBelowMax).toLong();
    }
}

package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.LE;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;

/**
 * Triangles of a leaf that a line of {@link MeshFloatLines} certainly does not meet: they are told by the signs of {@link MeshRay}, in floats,
 * with room for all that those may be off. With R, v, u, {@code loose} and w as there, let λ be the longest side of the box around the
 * triangle. A ray that meets it crosses that box, made wide by less than loose/4, so the sheared vertices lie within B = 2λ + w of 0. That
 * ray's signs are right for vertices off by 4u·R, products rounded by u; where the ray is off its line by loose/4 at the triangle, and runs
 * across it by at most 2⁻²⁶ of its length ({@link MeshLines#hasSkewedRays}), sheared vertices are off by loose/2 + 2⁻²⁵·λ. Moving and shearing in
 * floats are off by 7v·R: new origin v·R, twice, the two differences v·R each, the shear v·R, the fused sum 2v·R. A difference of products
 * of numbers within B that are off by ε is off by 4ε·B, and rounding makes it 3v·B² more, where λ ≤ 2R. All together, with 16v·R + loose ≤
 * w, less than 3w·B: 6w·λ + 3w², of which 7w·(λ + w) is more by all that reckoning it in floats takes away; the least normal float covers
 * underflow.
 */
final class LeafTriangleCulling {
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;

    private LeafTriangleCulling() {}

    /**
     * The slots of a leaf whose triangles a line may meet.
     *
     * @param v      the leaves' vertices, of which those of the first slot begin at {@code x}, {@code y} and {@code z}; the line goes along z
     * @param ox     where the line begins, in that order of axes, likewise {@code oy} and {@code oz}
     * @param shearX how far it goes along x for 1 along z, likewise {@code shearY}
     * @param w      how wide it is
     * @param extent the longest side of the leaf's box
     */
    static int candidateSlots(float[] v, int x, int y, int z, float ox, float oy, float oz, float shearX, float shearY, float w,
            float extent) {
        FloatVector sx = FloatVector.broadcast(EIGHT, -shearX);
        FloatVector sy = FloatVector.broadcast(EIGHT, -shearY);
        FloatVector az = FloatVector.fromArray(EIGHT, v, z).sub(oz);
        FloatVector ax = az.fma(sx, FloatVector.fromArray(EIGHT, v, x).sub(ox));
        FloatVector ay = az.fma(sy, FloatVector.fromArray(EIGHT, v, y).sub(oy));
        FloatVector bz = FloatVector.fromArray(EIGHT, v, MeshTree.VERTEX_FLOATS + z).sub(oz);
        FloatVector bx = bz.fma(sx, FloatVector.fromArray(EIGHT, v, MeshTree.VERTEX_FLOATS + x).sub(ox));
        FloatVector by = bz.fma(sy, FloatVector.fromArray(EIGHT, v, MeshTree.VERTEX_FLOATS + y).sub(oy));
        FloatVector cz = FloatVector.fromArray(EIGHT, v, 2 * MeshTree.VERTEX_FLOATS + z).sub(oz);
        FloatVector cx = cz.fma(sx, FloatVector.fromArray(EIGHT, v, 2 * MeshTree.VERTEX_FLOATS + x).sub(ox));
        FloatVector cy = cz.fma(sy, FloatVector.fromArray(EIGHT, v, 2 * MeshTree.VERTEX_FLOATS + y).sub(oy));
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

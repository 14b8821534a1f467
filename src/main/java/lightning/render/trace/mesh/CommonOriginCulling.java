package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.LE;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;

/**
 * Culling of a leaf's triangles for lines of {@link MeshFloatLines} with a common origin. Computes the values that depend only
 * on the origin once per leaf.
 *
 * <p>With A, B and C relative to the origin, {@link MeshRay}'s sign for the edge from C to B is that of d·(C × B) = d·(C × (B −
 * C)), where d is the line's step. A triangle is rejected only if a float sign exceeds {@link #margin}. Proof of the margin:
 * docs/numerics.md, "Proof: leaf culling with a common origin".
 */
final class CommonOriginCulling {
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    private static final int W = MeshTree.WIDTH;
    private static final int C = MeshTree.CORNER_FLOATS;
    private static final int X = MeshTree.AXIS_FLOATS;

    /** C × (B − C), A × (C − A) and B × (A − B) of the current leaf, x y z of each for all slots. */
    private final float[] normal = new float[9 * W];

    /** Sets the leaf whose vertices begin at {@code v[at]}, seen from a point. */
    void setLeaf(float[] v, int at, float ox, float oy, float oz) {
        float[] n = normal;
        FloatVector ax = FloatVector.fromArray(EIGHT, v, at).sub(ox);
        FloatVector ay = FloatVector.fromArray(EIGHT, v, at + X).sub(oy);
        FloatVector az = FloatVector.fromArray(EIGHT, v, at + 2 * X).sub(oz);
        FloatVector bx = FloatVector.fromArray(EIGHT, v, at + C).sub(ox);
        FloatVector by = FloatVector.fromArray(EIGHT, v, at + X + C).sub(oy);
        FloatVector bz = FloatVector.fromArray(EIGHT, v, at + 2 * X + C).sub(oz);
        FloatVector cx = FloatVector.fromArray(EIGHT, v, at + 2 * C).sub(ox);
        FloatVector cy = FloatVector.fromArray(EIGHT, v, at + X + 2 * C).sub(oy);
        FloatVector cz = FloatVector.fromArray(EIGHT, v, at + 2 * X + 2 * C).sub(oz);
        FloatVector ex = FloatVector.fromArray(EIGHT, v, at + C).sub(FloatVector.fromArray(EIGHT, v, at + 2 * C));
        FloatVector ey = FloatVector.fromArray(EIGHT, v, at + X + C).sub(FloatVector.fromArray(EIGHT, v, at + X + 2 * C));
        FloatVector ez = FloatVector.fromArray(EIGHT, v, at + 2 * X + C).sub(FloatVector.fromArray(EIGHT, v, at + 2 * X + 2 * C));
        cy.fma(ez, cz.mul(ey).neg()).intoArray(n, 0);
        cz.fma(ex, cx.mul(ez).neg()).intoArray(n, W);
        cx.fma(ey, cy.mul(ex).neg()).intoArray(n, 2 * W);
        ex = FloatVector.fromArray(EIGHT, v, at + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at));
        ey = FloatVector.fromArray(EIGHT, v, at + X + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at + X));
        ez = FloatVector.fromArray(EIGHT, v, at + 2 * X + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at + 2 * X));
        ay.fma(ez, az.mul(ey).neg()).intoArray(n, 3 * W);
        az.fma(ex, ax.mul(ez).neg()).intoArray(n, 4 * W);
        ax.fma(ey, ay.mul(ex).neg()).intoArray(n, 5 * W);
        ex = FloatVector.fromArray(EIGHT, v, at).sub(FloatVector.fromArray(EIGHT, v, at + C));
        ey = FloatVector.fromArray(EIGHT, v, at + X).sub(FloatVector.fromArray(EIGHT, v, at + X + C));
        ez = FloatVector.fromArray(EIGHT, v, at + 2 * X).sub(FloatVector.fromArray(EIGHT, v, at + 2 * X + C));
        by.fma(ez, bz.mul(ey).neg()).intoArray(n, 6 * W);
        bz.fma(ex, bx.mul(ez).neg()).intoArray(n, 7 * W);
        bx.fma(ey, by.mul(ex).neg()).intoArray(n, 8 * W);
    }

    /** Returns the maximum error of signs for lines of this width, in a leaf whose box has no side longer than {@code extent}. */
    static float margin(float w, float extent) {
        return 7 * w * (extent + w) + Float.MIN_NORMAL;
    }

    /** Returns the slots whose triangles a line with this step may hit. */
    int candidateSlots(float dx, float dy, float dz, float margin) {
        float[] n = normal;
        FloatVector x = FloatVector.broadcast(EIGHT, dx);
        FloatVector y = FloatVector.broadcast(EIGHT, dy);
        FloatVector z = FloatVector.broadcast(EIGHT, dz);
        FloatVector edgeA = x.fma(FloatVector.fromArray(EIGHT, n, 0),
                y.fma(FloatVector.fromArray(EIGHT, n, W), z.mul(FloatVector.fromArray(EIGHT, n, 2 * W))));
        FloatVector edgeB = x.fma(FloatVector.fromArray(EIGHT, n, 3 * W),
                y.fma(FloatVector.fromArray(EIGHT, n, 4 * W), z.mul(FloatVector.fromArray(EIGHT, n, 5 * W))));
        FloatVector edgeC = x.fma(FloatVector.fromArray(EIGHT, n, 6 * W),
                y.fma(FloatVector.fromArray(EIGHT, n, 7 * W), z.mul(FloatVector.fromArray(EIGHT, n, 8 * W))));
        FloatVector max = FloatVector.broadcast(EIGHT, margin);
        FloatVector min = FloatVector.broadcast(EIGHT, -margin);
        VectorMask<Float> allAboveMin = edgeA.compare(GE, min).and(edgeB.compare(GE, min)).and(edgeC.compare(GE, min));
        VectorMask<Float> allBelowMax = edgeA.compare(LE, max).and(edgeB.compare(LE, max)).and(edgeC.compare(LE, max));
        return (int) allAboveMin.or(allBelowMax).toLong();
    }
}

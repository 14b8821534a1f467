package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.LE;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;

/**
 * Triangles of a leaf that lines of {@link MeshFloatLines} from one point certainly do not meet: what all lines have in common is reckoned once
 * for a leaf. With A, B and C as seen from that point, the sign of {@link MeshRay} for the edge from C to B is that of d·(C × B) = d·(C × (B − C)), d
 * the line's step.
 *
 * <p>What these are off in floats, with R, v, u, {@code loose} and w as in {@link MeshFloatLines}, and λ the longest side of the leaf's box: C by 2v·R on
 * each axis, of which rounding the point is half; B − C by v·λ. So C × (B − C), which is at most 2R·λ, is off by 4v·R·λ for the one, 2v·R·λ for the
 * other and 3v·R·λ for its product and fused sum: 9v·R·λ. A step is at most 1 on each axis and off by less than 2v. Three products and their sum
 * are then off by 27v·R·λ, 12v·R·λ for the step and 12v·R·λ for rounding: 51v·R·λ. By how much the ray's signs may be off those of its line is told in
 * {@link LeafTriangleCulling}: sheared vertices, within B = 2λ + w of 0, are off by loose/2 + 2⁻²⁵·λ, which is at most loose/2 + v·R, and the sign by
 * four times their product; what the ray's own rounding adds, in u, is less than v·R·λ. That makes 2·loose·B + 4v·R·B. With 16v·R + loose ≤ w all
 * together is less than 60v·R·λ + 4·loose·λ + 3w², so less than 4w·λ + 3w², of which 7w·(λ + w) is more by all that reckoning it in floats takes away;
 * the least normal float covers underflow.
 */
final class CommonOriginCulling {
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    private static final int W = MeshTree.WIDTH;

    /** C × (B − C), A × (C − A) and B × (A − B) of the leaf that was taken, x y z of each in all slots. */
    private final float[] normal = new float[9 * W];

    /** Takes the leaf whose vertices begin at {@code v[at]}, as seen from a point. */
    void setLeaf(float[] v, int at, float ox, float oy, float oz) {
        float[] n = normal;
        FloatVector ax = FloatVector.fromArray(EIGHT, v, at).sub(ox);
        FloatVector ay = FloatVector.fromArray(EIGHT, v, at + W).sub(oy);
        FloatVector az = FloatVector.fromArray(EIGHT, v, at + 2 * W).sub(oz);
        FloatVector bx = FloatVector.fromArray(EIGHT, v, at + 3 * W).sub(ox);
        FloatVector by = FloatVector.fromArray(EIGHT, v, at + 4 * W).sub(oy);
        FloatVector bz = FloatVector.fromArray(EIGHT, v, at + 5 * W).sub(oz);
        FloatVector cx = FloatVector.fromArray(EIGHT, v, at + 6 * W).sub(ox);
        FloatVector cy = FloatVector.fromArray(EIGHT, v, at + 7 * W).sub(oy);
        FloatVector cz = FloatVector.fromArray(EIGHT, v, at + 8 * W).sub(oz);
        FloatVector ex = FloatVector.fromArray(EIGHT, v, at + 3 * W).sub(FloatVector.fromArray(EIGHT, v, at + 6 * W));
        FloatVector ey = FloatVector.fromArray(EIGHT, v, at + 4 * W).sub(FloatVector.fromArray(EIGHT, v, at + 7 * W));
        FloatVector ez = FloatVector.fromArray(EIGHT, v, at + 5 * W).sub(FloatVector.fromArray(EIGHT, v, at + 8 * W));
        cy.fma(ez, cz.mul(ey).neg()).intoArray(n, 0);
        cz.fma(ex, cx.mul(ez).neg()).intoArray(n, W);
        cx.fma(ey, cy.mul(ex).neg()).intoArray(n, 2 * W);
        ex = FloatVector.fromArray(EIGHT, v, at + 6 * W).sub(FloatVector.fromArray(EIGHT, v, at));
        ey = FloatVector.fromArray(EIGHT, v, at + 7 * W).sub(FloatVector.fromArray(EIGHT, v, at + W));
        ez = FloatVector.fromArray(EIGHT, v, at + 8 * W).sub(FloatVector.fromArray(EIGHT, v, at + 2 * W));
        ay.fma(ez, az.mul(ey).neg()).intoArray(n, 3 * W);
        az.fma(ex, ax.mul(ez).neg()).intoArray(n, 4 * W);
        ax.fma(ey, ay.mul(ex).neg()).intoArray(n, 5 * W);
        ex = FloatVector.fromArray(EIGHT, v, at).sub(FloatVector.fromArray(EIGHT, v, at + 3 * W));
        ey = FloatVector.fromArray(EIGHT, v, at + W).sub(FloatVector.fromArray(EIGHT, v, at + 4 * W));
        ez = FloatVector.fromArray(EIGHT, v, at + 2 * W).sub(FloatVector.fromArray(EIGHT, v, at + 5 * W));
        by.fma(ez, bz.mul(ey).neg()).intoArray(n, 6 * W);
        bz.fma(ex, bx.mul(ez).neg()).intoArray(n, 7 * W);
        bx.fma(ey, by.mul(ex).neg()).intoArray(n, 8 * W);
    }

    /** The most by which signs of lines that are this wide may be off, in a leaf whose box has no longer side than {@code extent}. */
    static float margin(float w, float extent) {
        return 7 * w * (extent + w) + Float.MIN_NORMAL;
    }

    /** The slots whose triangles a line may meet, by its step. */
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

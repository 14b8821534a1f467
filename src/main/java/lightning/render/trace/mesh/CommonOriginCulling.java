package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.XOR;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
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
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final int W = MeshTree.WIDTH;
    private static final int C = MeshTree.CORNER_FLOATS;
    private static final int X = MeshTree.AXIS_FLOATS;

    /** C × (B − C), A × (C − A) and B × (A − B) of the current leaf, x y z of each for all slots. */
    private final float[] normal = new float[9 * W];

    /** Slots whose triangles the origin may see edge-on. Signs of the others are positive for all lines that hit them. */
    private int twoSided;
    /** Lines of the latest {@link #candidateLines} that may hit more than one triangle. */
    int multipleLines;

    /** Sets the leaf whose vertices begin at {@code v[at]}, seen from a point. */
    void setLeaf(float[] v, int at, float ox, float oy, float oz, float minVolume) {
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
        FloatVector nx = cy.fma(ez, cz.mul(ey).neg());
        FloatVector ny = cz.fma(ex, cx.mul(ez).neg());
        FloatVector nz = cx.fma(ey, cy.mul(ex).neg());
        FloatVector volume = ax.fma(nx, ay.fma(ny, az.mul(nz)));
        IntVector sign = volume.reinterpretAsInts().and(Integer.MIN_VALUE);
        twoSided = ~(int) volume.abs().compare(GT, FloatVector.broadcast(EIGHT, minVolume)).toLong();
        nx.reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 0);
        ny.reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, W);
        nz.reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 2 * W);
        ex = FloatVector.fromArray(EIGHT, v, at + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at));
        ey = FloatVector.fromArray(EIGHT, v, at + X + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at + X));
        ez = FloatVector.fromArray(EIGHT, v, at + 2 * X + 2 * C).sub(FloatVector.fromArray(EIGHT, v, at + 2 * X));
        ay.fma(ez, az.mul(ey).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 3 * W);
        az.fma(ex, ax.mul(ez).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 4 * W);
        ax.fma(ey, ay.mul(ex).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 5 * W);
        ex = FloatVector.fromArray(EIGHT, v, at).sub(FloatVector.fromArray(EIGHT, v, at + C));
        ey = FloatVector.fromArray(EIGHT, v, at + X).sub(FloatVector.fromArray(EIGHT, v, at + X + C));
        ez = FloatVector.fromArray(EIGHT, v, at + 2 * X).sub(FloatVector.fromArray(EIGHT, v, at + 2 * X + C));
        by.fma(ez, bz.mul(ey).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 6 * W);
        bz.fma(ex, bx.mul(ez).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 7 * W);
        bx.fma(ey, by.mul(ex).neg()).reinterpretAsInts().lanewise(XOR, sign).reinterpretAsFloats().intoArray(n, 8 * W);
    }

    /** Returns the maximum error of signs for lines of this width, in a leaf whose box has no side longer than {@code extent}. */
    static float margin(float w, float extent) {
        return 7 * w * (extent + w) + Float.MIN_NORMAL;
    }

    /** Returns the volume of triangle and origin, times 6, above which the side is known that the origin sees. */
    static float minVolume(float w, float extent) {
        return 0x1p25f * w * w * (extent + w) + Float.MIN_NORMAL;
    }

    /** Returns the slots whose triangles a beam's lines may hit. */
    int candidateSlots(MeshBeam beam, float margin) {
        float[] n = normal;
        float[] center = beam.stepCenter;
        float[] extent = beam.stepExtent;
        int allAboveMin = -1;
        int allBelowMax = -1;
        for (int edge = 0; edge < 9 * W; edge += 3 * W) {
            FloatVector x = FloatVector.fromArray(EIGHT, n, edge);
            FloatVector y = FloatVector.fromArray(EIGHT, n, edge + W);
            FloatVector z = FloatVector.fromArray(EIGHT, n, edge + 2 * W);
            FloatVector sign = x.mul(center[0]).add(y.mul(center[1])).add(z.mul(center[2]));
            FloatVector spread = x.abs().mul(extent[0]).add(y.abs().mul(extent[1])).add(z.abs().mul(extent[2]));
            allAboveMin &= (int) sign.add(spread).compare(GE, FloatVector.broadcast(EIGHT, -margin)).toLong();
            allBelowMax &= (int) sign.sub(spread).compare(LE, FloatVector.broadcast(EIGHT, margin)).toLong();
        }
        return allAboveMin | allBelowMax;
    }

    /**
     * Tests the lines of the packet that starts at {@code h} against triangles.
     *
     * @param triangles slots to test, not 0
     * @param minLimitBits lines with a shorter limit are not tested
     * @param slots receives the slots of the triangles that each line may hit
     * @param firstSlot receives the first of them
     * @return lines that may hit a triangle; {@link #multipleLines} receives the lines that may hit more than one
     */
    int candidateLines(MeshFloatLines lines, int h, int triangles, float margin, int minLimitBits, int[] slots, int[] firstSlot) {
        float[] n = normal;
        FloatVector x = FloatVector.fromArray(FLOATS, lines.stepX, h);
        FloatVector y = FloatVector.fromArray(FLOATS, lines.stepY, h);
        FloatVector z = FloatVector.fromArray(FLOATS, lines.stepZ, h);
        FloatVector max = FloatVector.broadcast(FLOATS, margin);
        int active = (int) IntVector.fromArray(INTS, lines.limitBits, h).compare(GE, minLimitBits).toLong();
        IntVector set = IntVector.zero(INTS);
        IntVector first = set;
        int any = 0;
        int multiple = 0;
        // The first slot last, so that it stays.
        for (int left = triangles; left != 0;) {
            int s = Integer.SIZE - 1 - Integer.numberOfLeadingZeros(left);
            left ^= 1 << s;
            FloatVector edgeA = x.fma(FloatVector.broadcast(FLOATS, n[s]),
                    y.fma(FloatVector.broadcast(FLOATS, n[s + W]), z.fma(FloatVector.broadcast(FLOATS, n[s + 2 * W]), max)));
            FloatVector edgeB = x.fma(FloatVector.broadcast(FLOATS, n[s + 3 * W]),
                    y.fma(FloatVector.broadcast(FLOATS, n[s + 4 * W]), z.fma(FloatVector.broadcast(FLOATS, n[s + 5 * W]), max)));
            FloatVector edgeC = x.fma(FloatVector.broadcast(FLOATS, n[s + 6 * W]),
                    y.fma(FloatVector.broadcast(FLOATS, n[s + 7 * W]), z.fma(FloatVector.broadcast(FLOATS, n[s + 8 * W]), max)));
            VectorMask<Integer> hit = edgeA.reinterpretAsInts().or(edgeB.reinterpretAsInts()).or(edgeC.reinterpretAsInts()).compare(GE, 0);
            if ((twoSided >>> s & 1) != 0) {
                hit = hit.or(edgeA.sub(max).compare(LE, max).and(edgeB.sub(max).compare(LE, max)).and(edgeC.sub(max).compare(LE, max))
                        .cast(INTS));
            }
            set = set.blend(set.or(1 << s), hit);
            first = first.blend(s, hit);
            int bits = (int) hit.toLong();
            multiple |= any & bits;
            any |= bits;
        }
        set.intoArray(slots, h);
        first.intoArray(firstSlot, h);
        multipleLines = multiple & active;
        return any & active;
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

package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.F2D;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;

/**
 * Distances of eight adjacent rays to triangles of one leaf, each ray to a triangle of its own. Computes
 * {@link MeshRay#distance} operation by operation, so the bits are equal.
 */
final class LeafTriangleLanes {
    /** Rays per test. */
    static final int RAYS = 8;

    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> EIGHT_INTS = IntVector.SPECIES_256;
    private static final int W = MeshTree.WIDTH;
    private static final int V = 3 * W;

    /** Maximum distance, relative to the padding, whose product with a direction near 0 needs no clamping. */
    private static final double MAX_DISTANCE_SHARE = 0x1p800;

    private final MeshRayLanes rays;
    /** Slot of the triangle that each ray is tested with next. */
    final int[] slot;
    /** Distances, by ray. */
    final double[] distance;
    /** Corners of each ray's triangle: eight floats per axis, and three axes per corner. */
    final double[] vertex = new double[9 * W];
    /** Rays whose triangle has its last vertex at the first corner, and at the second. */
    private int lastIsFirst;
    private int lastIsSecond;
    private final double[] entry = new double[DoubleLanes.COUNT];
    private final double[] exit = new double[DoubleLanes.COUNT];

    LeafTriangleLanes(MeshRayLanes rays, int capacity) {
        this.rays = rays;
        slot = new int[capacity];
        distance = new double[capacity];
    }

    /**
     * Writes the distances of rays {@code h … h + 7} to triangles of a leaf.
     *
     * @param mask rays to test, one bit each; the distances of other rays are undefined
     */
    void computeDistances(MeshTree tree, int leaf, int h, int mask) {
        IntVector s = IntVector.fromArray(EIGHT_INTS, slot, h);
        IntVector last = s.selectFrom(IntVector.fromArray(EIGHT_INTS, tree.triangle, W * leaf)).and(3);
        lastIsFirst = (int) last.compare(EQ, 0).toLong();
        lastIsSecond = (int) last.compare(EQ, 1).toLong();
        for (int k = 0; k < 9; k++) {
            int at = MeshTree.LEAF_FLOATS * leaf + MeshTree.AXIS_FLOATS * (k % 3) + MeshTree.CORNER_FLOATS * (k / 3);
            FloatVector chosen = s.selectFrom(FloatVector.fromArray(EIGHT, tree.vertex, at).reinterpretAsInts()).reinterpretAsFloats();
            for (int part = 0; part < RAYS; part += DoubleLanes.COUNT) {
                ((DoubleVector) chosen.convertShape(F2D, SPECIES, part / DoubleLanes.COUNT)).intoArray(vertex, W * k + part);
            }
        }
        computeDistances(h, mask);
    }

    /** Writes the distances of rays {@code h … h + 7} of a set to triangles whose vertices are in {@link #vertex}. */
    void computeDistances(int h, int mask) {
        for (int part = 0; part < RAYS; part += DoubleLanes.COUNT) {
            int left = mask >>> part & -1 >>> -DoubleLanes.COUNT;
            if (left != 0) {
                computePart(h, part, left);
            }
        }
    }

    private void computePart(int h, int part, int mask) {
        DoubleVector absX = fromArray(SPECIES, rays.dx, h + part).abs();
        DoubleVector absY = fromArray(SPECIES, rays.dy, h + part).abs();
        DoubleVector absZ = fromArray(SPECIES, rays.dz, h + part).abs();
        int x = (int) absX.compare(GE, absY).and(absX.compare(GE, absZ)).toLong() & mask;
        int y = (int) absY.compare(GE, absZ).toLong() & mask & ~x;
        int z = mask & ~(x | y);
        int hit = 0;
        if (x != 0) {
            hit |= planeDistances(W, 2 * W, 0, rays.oy, rays.oz, rays.ox, rays.dy, rays.dz, rays.dx, h, part, x);
        }
        if (y != 0) {
            hit |= planeDistances(2 * W, 0, W, rays.oz, rays.ox, rays.oy, rays.dz, rays.dx, rays.dy, h, part, y);
        }
        if (z != 0) {
            hit |= planeDistances(0, W, 2 * W, rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, h, part, z);
        }
        if (hit != 0 && (hit & ~raysInsideBoxes(h, part)) != 0) {
            clampToBoxes(h, part, hit);
        }
    }

    /**
     * Computes {@link MeshRay#planeDistance} of rays whose directions have the largest component on the axis {@code z}; returns
     * the rays with a positive distance, the others have an infinite one.
     */
    private int planeDistances(int x, int y, int z, double[] originX, double[] originY, double[] originZ,
            double[] directionX, double[] directionY, double[] directionZ, int h, int part, int mask) {
        double[] v = vertex;
        int i = h + part;
        DoubleVector inverseDepth = broadcast(SPECIES, 1).div(fromArray(SPECIES, directionZ, i));
        DoubleVector shearX = fromArray(SPECIES, directionX, i).mul(inverseDepth);
        DoubleVector shearY = fromArray(SPECIES, directionY, i).mul(inverseDepth);
        DoubleVector ox = fromArray(SPECIES, originX, i);
        DoubleVector oy = fromArray(SPECIES, originY, i);
        DoubleVector oz = fromArray(SPECIES, originZ, i);
        DoubleVector az = fromArray(SPECIES, v, z + part).sub(oz);
        DoubleVector ax = fromArray(SPECIES, v, x + part).sub(ox).sub(shearX.mul(az));
        DoubleVector ay = fromArray(SPECIES, v, y + part).sub(oy).sub(shearY.mul(az));
        DoubleVector bz = fromArray(SPECIES, v, V + z + part).sub(oz);
        DoubleVector bx = fromArray(SPECIES, v, V + x + part).sub(ox).sub(shearX.mul(bz));
        DoubleVector by = fromArray(SPECIES, v, V + y + part).sub(oy).sub(shearY.mul(bz));
        DoubleVector cz = fromArray(SPECIES, v, 2 * V + z + part).sub(oz);
        DoubleVector cx = fromArray(SPECIES, v, 2 * V + x + part).sub(ox).sub(shearX.mul(cz));
        DoubleVector cy = fromArray(SPECIES, v, 2 * V + y + part).sub(oy).sub(shearY.mul(cz));
        DoubleVector weightA = cx.mul(by).sub(cy.mul(bx));
        DoubleVector weightB = ax.mul(cy).sub(ay.mul(cx));
        DoubleVector weightC = bx.mul(ay).sub(by.mul(ax));
        VectorMask<Double> inside = weightA.compare(GE, 0).and(weightB.compare(GE, 0)).and(weightC.compare(GE, 0))
                .or(weightA.compare(LE, 0).and(weightB.compare(LE, 0)).and(weightC.compare(LE, 0)));
        // Sums end with the last vertex; the order of the other two and the sign of all weights do not change the quotient.
        VectorMask<Double> first = VectorMask.fromLong(SPECIES, lastIsFirst >>> part);
        VectorMask<Double> second = VectorMask.fromLong(SPECIES, lastIsSecond >>> part);
        az = weightA.mul(az);
        bz = weightB.mul(bz);
        cz = weightC.mul(cz);
        DoubleVector t = az.blend(cz, first).add(bz.blend(cz, second)).add(cz.blend(az, first).blend(bz, second))
                .div(weightA.blend(weightC, first).add(weightB.blend(weightC, second))
                        .add(weightC.blend(weightA, first).blend(weightB, second)))
                .mul(inverseDepth);
        inside = inside.and(t.compare(GT, 0));
        fromArray(SPECIES, distance, i).blend(broadcast(SPECIES, MeshRay.MISS).blend(t, inside), VectorMask.fromLong(SPECIES, mask))
                .intoArray(distance, i);
        return (int) inside.toLong() & mask;
    }

    /**
     * Returns rays whose hits are inside the triangles' boxes by enough that clamping does not change their distances, without
     * a division. Proof: docs/numerics.md, "Proof: hits inside the triangle's box".
     */
    private int raysInsideBoxes(int h, int part) {
        DoubleVector t = fromArray(SPECIES, distance, h + part);
        DoubleVector pad = fromArray(SPECIES, rays.padding, h + part);
        int inside = (int) t.compare(LT, pad.mul(MAX_DISTANCE_SHARE)).toLong();
        pad = pad.mul(0.25);
        // One call in a loop: the compiler would not inline all of three.
        for (int axis = 0; axis < 3; axis++) {
            DoubleVector p = t.mul(fromArray(SPECIES, axis == 0 ? rays.dx : axis == 1 ? rays.dy : rays.dz, h + part))
                    .add(fromArray(SPECIES, axis == 0 ? rays.ox : axis == 1 ? rays.oy : rays.oz, h + part));
            DoubleVector a = fromArray(SPECIES, vertex, axis * W + part);
            DoubleVector b = fromArray(SPECIES, vertex, axis * W + V + part);
            DoubleVector c = fromArray(SPECIES, vertex, axis * W + 2 * V + part);
            DoubleVector low = p.add(pad);
            DoubleVector high = p.sub(pad);
            inside &= (int) (low.compare(GE, a).or(low.compare(GE, b)).or(low.compare(GE, c))).toLong()
                    & (int) (high.compare(LE, a).or(high.compare(LE, b)).or(high.compare(LE, c))).toLong();
        }
        return inside;
    }

    /** Clamps distances of the rays of {@code mask} as {@link MeshRay#clampToBox}; those of others become infinite. */
    private void clampToBoxes(int h, int part, int mask) {
        broadcast(SPECIES, 0).intoArray(entry, 0);
        broadcast(SPECIES, MeshRay.MISS).intoArray(exit, 0);
        // One call in a loop: the compiler would not inline all of three.
        for (int axis = 0; axis < 3; axis++) {
            narrowInterval(axis * W, axis == 0 ? rays.ox : axis == 1 ? rays.oy : rays.oz,
                    axis == 0 ? rays.dx : axis == 1 ? rays.dy : rays.dz, h, part);
        }
        DoubleVector enters = fromArray(SPECIES, entry, 0);
        DoubleVector leaves = fromArray(SPECIES, exit, 0);
        DoubleVector t = fromArray(SPECIES, distance, h + part);
        DoubleVector clamped = t.blend(leaves, t.compare(GT, leaves)).blend(enters, t.compare(LT, enters));
        VectorMask<Double> accepted = enters.compare(LE, leaves).and(clamped.compare(GT, 0)).and(VectorMask.fromLong(SPECIES, mask));
        broadcast(SPECIES, MeshRay.MISS).blend(clamped, accepted).intoArray(distance, h + part);
    }

    /**
     * Narrows the distances between which the padded rays cross the triangles' boxes by an axis. Signs of zeros do not change
     * the result, so blends need not order them.
     */
    private void narrowInterval(int axis, double[] origin, double[] direction, int h, int part) {
        DoubleVector a = fromArray(SPECIES, vertex, axis + part);
        DoubleVector b = fromArray(SPECIES, vertex, axis + V + part);
        DoubleVector c = fromArray(SPECIES, vertex, axis + 2 * V + part);
        DoubleVector min = min(min(a, b), c);
        DoubleVector max = max(max(a, b), c);
        DoubleVector inverse = broadcast(SPECIES, 1).div(fromArray(SPECIES, direction, h + part));
        inverse = inverse.blend(MeshRay.MAX_INVERSE, inverse.compare(GT, MeshRay.MAX_INVERSE)).blend(-MeshRay.MAX_INVERSE,
                inverse.compare(LT, -MeshRay.MAX_INVERSE));
        DoubleVector pad = fromArray(SPECIES, rays.padding, h + part);
        DoubleVector o = fromArray(SPECIES, origin, h + part);
        DoubleVector near = min.sub(o.add(pad)).mul(inverse);
        DoubleVector far = max.sub(o.sub(pad)).mul(inverse);
        VectorMask<Double> isForward = near.compare(LT, far);
        max(fromArray(SPECIES, entry, 0), far.blend(near, isForward)).intoArray(entry, 0);
        min(fromArray(SPECIES, exit, 0), near.blend(far, isForward)).intoArray(exit, 0);
    }

    private static DoubleVector min(DoubleVector a, DoubleVector b) {
        return a.blend(b, b.compare(LT, a));
    }

    private static DoubleVector max(DoubleVector a, DoubleVector b) {
        return a.blend(b, b.compare(GT, a));
    }
}

package lightning.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.F2D;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.NE;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.trace.solid.Lanes;
import lightning.trace.solid.Rays;

/**
 * The rays of a group in the space of a mesh, and how they meet the triangles of a leaf: {@link MeshRay} in lanes, operation by
 * operation. Reused; not shared between threads.
 */
final class MeshLanes {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));
    /** For each axis along which a ray is longest, the two others, as places of their coordinates in a leaf. */
    private static final int[] ACROSS = {MeshTree.WIDTH, 2 * MeshTree.WIDTH, 0};
    private static final int[] ALONG = {2 * MeshTree.WIDTH, 0, MeshTree.WIDTH};

    /** Origins and directions, and what {@link MeshRay} makes of them. */
    final double[] ox;
    final double[] oy;
    final double[] oz;
    final double[] dx;
    final double[] dy;
    final double[] dz;
    final double[] pad;
    final double[] inverseX;
    final double[] inverseY;
    final double[] inverseZ;
    /** {@link MeshRay}'s axis: 0, 1 or 2. */
    private final int[] axis;
    private final double[] shearX;
    private final double[] shearY;
    private final double[] perDepth;
    /** The first ray that was taken. */
    int first;
    /** Whether all rays that were taken begin at one point. */
    boolean common;
    /** The vertices of a leaf as seen from where a ray begins. */
    private final double[] moved = new double[MeshTree.LEAF];

    /** @param most rays, a multiple of a packet's */
    MeshLanes(int most) {
        ox = new double[most];
        oy = new double[most];
        oz = new double[most];
        dx = new double[most];
        dy = new double[most];
        dz = new double[most];
        pad = new double[most];
        inverseX = new double[most];
        inverseY = new double[most];
        inverseZ = new double[most];
        axis = new int[most];
        shearX = new double[most];
        shearY = new double[most];
        perDepth = new double[most];
    }

    /**
     * Takes the rays of a packet.
     *
     * @param m    the map to the mesh's space at {@code m[at …]}
     * @param mask which of them, not 0; what is made of the others is not to be read
     * @param to   the place of the first; at 0 a new group begins
     */
    void take(MeshTree tree, double[] m, int at, Rays p, int mask, int to) {
        if (to == 0) {
            common = true;
            first = Integer.numberOfTrailingZeros(mask);
        }
        for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
            map(m, at, p, h, to + h);
            prepare(tree, to + h);
        }
        for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
            common &= (apart(first, to + h) & mask >>> h) == 0;
        }
    }

    private void map(double[] m, int i, Rays p, int from, int to) {
        DoubleVector x = fromArray(SPECIES, p.ox, from);
        DoubleVector y = fromArray(SPECIES, p.oy, from);
        DoubleVector z = fromArray(SPECIES, p.oz, from);
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).add(m[i + 3]).intoArray(ox, to);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).add(m[i + 7]).intoArray(oy, to);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).add(m[i + 11]).intoArray(oz, to);
        x = fromArray(SPECIES, p.dx, from);
        y = fromArray(SPECIES, p.dy, from);
        z = fromArray(SPECIES, p.dz, from);
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).intoArray(dx, to);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).intoArray(dy, to);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).intoArray(dz, to);
    }

    private void prepare(MeshTree tree, int h) {
        // Numbers that are not negative have the order of their bits, which lanes compare faster.
        fromArray(SPECIES, ox, h).abs().reinterpretAsLongs().max(fromArray(SPECIES, oy, h).abs().reinterpretAsLongs())
                .max(fromArray(SPECIES, oz, h).abs().reinterpretAsLongs()).reinterpretAsDoubles()
                .add(tree.reach).mul(MeshRay.PAD).intoArray(pad, h);
        inverse(dx, inverseX, h);
        inverse(dy, inverseY, h);
        inverse(dz, inverseZ, h);
    }

    private static void inverse(double[] d, double[] to, int h) {
        DoubleVector i = broadcast(SPECIES, 1).div(fromArray(SPECIES, d, h));
        i.blend(MeshRay.STEEPEST, i.compare(GT, MeshRay.STEEPEST)).blend(-MeshRay.STEEPEST, i.compare(LT, -MeshRay.STEEPEST))
                .intoArray(to, h);
    }

    /** Gets the rays of the packet from {@code i} on ready for {@link #face} and {@link #signs}. */
    void ready(int i) {
        for (int h = i; h < i + Rays.WIDTH; h += Lanes.COUNT) {
            shear(h);
        }
    }

    private void shear(int h) {
        DoubleVector x = fromArray(SPECIES, dx, h);
        DoubleVector y = fromArray(SPECIES, dy, h);
        DoubleVector z = fromArray(SPECIES, dz, h);
        DoubleVector farX = x.abs();
        DoubleVector farY = y.abs();
        DoubleVector farZ = z.abs();
        VectorMask<Double> isX = farX.compare(GE, farY).and(farX.compare(GE, farZ));
        VectorMask<Double> isY = farY.compare(GE, farZ).andNot(isX);
        DoubleVector per = broadcast(SPECIES, 1).div(z.blend(y, isY).blend(x, isX));
        per.intoArray(perDepth, h);
        x.blend(z, isY).blend(y, isX).mul(per).intoArray(shearX, h);
        y.blend(x, isY).blend(z, isX).mul(per).intoArray(shearY, h);
        int longX = (int) isX.toLong();
        int longY = (int) isY.toLong();
        for (int i = 0; i < Lanes.COUNT; i++) {
            axis[h + i] = 2 - 2 * (longX >>> i & 1) - (longY >>> i & 1);
        }
    }

    /** Which rays from {@code h} on do not begin where ray {@code i} does. */
    private int apart(int i, int h) {
        return (int) fromArray(SPECIES, ox, h).compare(NE, ox[i]).or(fromArray(SPECIES, oy, h).compare(NE, oy[i]))
                .or(fromArray(SPECIES, oz, h).compare(NE, oz[i])).toLong();
    }

    /** Sees the vertices of a leaf from where ray {@code i} begins: what {@link #signs} is asked of until it is called again. */
    void face(float[] vertex, int leaf, int i) {
        double x = ox[i];
        double y = oy[i];
        double z = oz[i];
        int at = MeshTree.LEAF * leaf;
        for (int v = 0; v < MeshTree.LEAF; v += MeshTree.VERTEX) {
            for (int h = 0; h < MeshTree.WIDTH; h += Lanes.COUNT) {
                int k = v + h;
                ((DoubleVector) FloatVector.fromArray(HALF, vertex, at + k).convertShape(F2D, SPECIES, 0)).sub(x).intoArray(moved, k);
                k += MeshTree.WIDTH;
                ((DoubleVector) FloatVector.fromArray(HALF, vertex, at + k).convertShape(F2D, SPECIES, 0)).sub(y).intoArray(moved, k);
                k += MeshTree.WIDTH;
                ((DoubleVector) FloatVector.fromArray(HALF, vertex, at + k).convertShape(F2D, SPECIES, 0)).sub(z).intoArray(moved, k);
            }
        }
    }

    /** The slots of that leaf whose triangles ray {@code i} meets by the signs of {@link MeshRay#distance}; writes depths to {@code t}. */
    int signs(int i, double[] t) {
        double[] v = moved;
        int mask = 0;
        int z = MeshTree.WIDTH * axis[i];
        int x = ACROSS[axis[i]];
        int y = ALONG[axis[i]];
        double sx = shearX[i];
        double sy = shearY[i];
        for (int h = 0; h < MeshTree.WIDTH; h += Lanes.COUNT) {
            DoubleVector az = fromArray(SPECIES, v, z + h);
            DoubleVector ax = fromArray(SPECIES, v, x + h).sub(az.mul(sx));
            DoubleVector ay = fromArray(SPECIES, v, y + h).sub(az.mul(sy));
            DoubleVector bz = fromArray(SPECIES, v, MeshTree.VERTEX + z + h);
            DoubleVector bx = fromArray(SPECIES, v, MeshTree.VERTEX + x + h).sub(bz.mul(sx));
            DoubleVector by = fromArray(SPECIES, v, MeshTree.VERTEX + y + h).sub(bz.mul(sy));
            DoubleVector cz = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + z + h);
            DoubleVector cx = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + x + h).sub(cz.mul(sx));
            DoubleVector cy = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + y + h).sub(cz.mul(sy));
            DoubleVector atA = cx.mul(by).sub(cy.mul(bx));
            DoubleVector atB = ax.mul(cy).sub(ay.mul(cx));
            DoubleVector atC = bx.mul(ay).sub(by.mul(ax));
            VectorMask<Double> one = atA.compare(GE, 0).and(atB.compare(GE, 0)).and(atC.compare(GE, 0));
            VectorMask<Double> other = atA.compare(LE, 0).and(atB.compare(LE, 0)).and(atC.compare(LE, 0));
            int met = (int) one.or(other).toLong();
            if (met != 0) {
                atA.mul(az).add(atB.mul(bz)).add(atC.mul(cz)).div(atA.add(atB).add(atC)).mul(perDepth[i]).intoArray(t, h);
                mask |= met << h;
            }
        }
        return mask;
    }

    /** The distance of ray {@code i} to a triangle of a leaf whose depth is {@code t}: the end of {@link MeshRay#distance}. */
    double put(int i, double t, float[] v, int at) {
        return t > 0 ? MeshRay.put(t, v, at, at + MeshTree.VERTEX, at + 2 * MeshTree.VERTEX, MeshTree.WIDTH, ox[i], oy[i], oz[i], pad[i],
                inverseX[i], inverseY[i], inverseZ[i]) : MeshRay.MISS;
    }
}

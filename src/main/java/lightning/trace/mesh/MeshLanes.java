package lightning.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.trace.solid.Lanes;
import lightning.trace.solid.Rays;

/**
 * The rays of a packet in the space of a mesh: as doubles, by the operations of {@link MeshRay}, and as floats to be tested against
 * boxes. Reused; not shared between threads.
 *
 * <p><b>Boxes in floats.</b> Each ray begins anew at {@code since}, where it enters the box of the whole mesh, so that floats tell its
 * triangles apart from however far away it comes. No distance within the mesh is less, as it is computed by the same monotone
 * operations. Distances are counted from there in units of the direction's largest component, so that every inverse is from 1 to
 * {@link #STEEPEST} in absolute value. With R a bound on the mesh's |coordinates| plus those of the new origin and v = 2⁻²⁴: rounding that origin
 * takes v·R, the inverse 2v of a distance below 2R, its product with the origin v·R, the fused sum v·2R; together less than 8v·R,
 * that is 2⁻²¹·R. A ray flatter than 1 : 2⁶⁰ on an axis drifts by less than 2⁻⁵⁸·R. The new origin is off by less than
 * 4u·(|o| + R), u = 2⁻⁵³, and the ray was made wide by 16u·(|o| + R) already. The floats' ray is made wide by 2⁻²⁰·R + 2⁻⁴⁶·(|o| + R),
 * so that it crosses every box that holds a triangle which {@link MeshRay} meets, and no later than that is met.
 */
final class MeshLanes {
    static final int W = Rays.WIDTH;
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    private static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));
    private static final double STEEPEST = 0x1p60;
    /** More than the rounding of a distance to float. */
    private static final double UP = 1 + 0x1p-20;

    /** Origins and directions, and what {@link MeshRay} makes of them. */
    final double[] ox = new double[W];
    final double[] oy = new double[W];
    final double[] oz = new double[W];
    final double[] dx = new double[W];
    final double[] dy = new double[W];
    final double[] dz = new double[W];
    final double[] pad = new double[W];
    final double[] inverseX = new double[W];
    final double[] inverseY = new double[W];
    final double[] inverseZ = new double[W];
    /** {@link MeshRay}'s axes, as places of their coordinates in a leaf. */
    final int[] axisX = new int[W];
    final int[] axisY = new int[W];
    final int[] axisZ = new int[W];
    final double[] originX = new double[W];
    final double[] originY = new double[W];
    final double[] originZ = new double[W];
    final double[] shearX = new double[W];
    final double[] shearY = new double[W];
    final double[] perDepth = new double[W];

    /** Where each ray enters the mesh's box, and what counts as one from there. */
    final double[] since = new double[W];
    private final double[] unit = new double[W];
    /** The rays from there, in those units. */
    final float[] startX = new float[W];
    final float[] startY = new float[W];
    final float[] startZ = new float[W];
    final float[] stepX = new float[W];
    final float[] stepY = new float[W];
    final float[] stepZ = new float[W];
    final float[] wide = new float[W];
    /** The plane {@code x = b} is met at {@code b·steep + low}, seen from the wide ray's one side, and at {@code b·steep + high} from the other. */
    final float[] steepX = new float[W];
    final float[] steepY = new float[W];
    final float[] steepZ = new float[W];
    final float[] lowX = new float[W];
    final float[] lowY = new float[W];
    final float[] lowZ = new float[W];
    final float[] highX = new float[W];
    final float[] highY = new float[W];
    final float[] highZ = new float[W];
    /** How far each ray goes, as the bits of a float; negative for one that goes nowhere. */
    final int[] far = new int[W];

    /**
     * Takes the rays of a packet.
     *
     * @param m      the map to the mesh's space at {@code m[at …]}
     * @param mask   which of them
     * @param limits how far each goes
     * @return those that reach the mesh's box
     */
    int enter(MeshTree tree, double[] m, int at, Rays p, int mask, double[] limits) {
        int met = 0;
        for (int h = 0; h < W; h += Lanes.COUNT) {
            if ((mask >>> h & -1 >>> -Lanes.COUNT) != 0) {
                map(m, at, p, h);
                prepare(tree, h);
                met |= clip(tree, limits, h) << h;
            }
        }
        met &= mask;
        for (int i = 0; i < W; i++) {
            if ((met >>> i & 1) != 0) {
                shear(i);
            } else {
                far[i] = -1;
            }
        }
        for (int h = 0; h < W; h += Lanes.COUNT) {
            if ((met >>> h & -1 >>> -Lanes.COUNT) != 0) {
                begin(tree, h);
                axis(startX, steepX, lowX, highX, h);
                axis(startY, steepY, lowY, highY, h);
                axis(startZ, steepZ, lowZ, highZ, h);
            }
        }
        for (int left = met; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            limit(i, limits[i]);
        }
        return met;
    }

    private void map(double[] m, int i, Rays p, int h) {
        DoubleVector x = fromArray(SPECIES, p.ox, h);
        DoubleVector y = fromArray(SPECIES, p.oy, h);
        DoubleVector z = fromArray(SPECIES, p.oz, h);
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).add(m[i + 3]).intoArray(ox, h);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).add(m[i + 7]).intoArray(oy, h);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).add(m[i + 11]).intoArray(oz, h);
        x = fromArray(SPECIES, p.dx, h);
        y = fromArray(SPECIES, p.dy, h);
        z = fromArray(SPECIES, p.dz, h);
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).intoArray(dx, h);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).intoArray(dy, h);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).intoArray(dz, h);
    }

    private void prepare(MeshTree tree, int h) {
        fromArray(SPECIES, ox, h).abs().max(fromArray(SPECIES, oy, h).abs()).max(fromArray(SPECIES, oz, h).abs())
                .add(tree.reach).mul(MeshRay.PAD).intoArray(pad, h);
        inverse(dx, inverseX, h);
        inverse(dy, inverseY, h);
        inverse(dz, inverseZ, h);
        fromArray(SPECIES, dx, h).abs().max(fromArray(SPECIES, dy, h).abs()).max(fromArray(SPECIES, dz, h).abs()).intoArray(unit, h);
    }

    private static void inverse(double[] d, double[] to, int h) {
        DoubleVector i = broadcast(SPECIES, 1).div(fromArray(SPECIES, d, h));
        i.blend(MeshRay.STEEPEST, i.compare(GT, MeshRay.STEEPEST)).blend(-MeshRay.STEEPEST, i.compare(LT, -MeshRay.STEEPEST))
                .intoArray(to, h);
    }

    /** Finds where rays enter the box of the whole mesh, by the operations of {@link MeshRay#enters}; which do. */
    private int clip(MeshTree tree, double[] limits, int h) {
        float[] b = tree.bounds;
        DoubleVector wide = fromArray(SPECIES, pad, h);
        DoubleVector inverse = fromArray(SPECIES, inverseX, h);
        DoubleVector o = fromArray(SPECIES, ox, h);
        DoubleVector p = broadcast(SPECIES, b[0]).sub(o.add(wide)).mul(inverse);
        DoubleVector q = broadcast(SPECIES, b[3]).sub(o.sub(wide)).mul(inverse);
        DoubleVector in = p.min(q).max(0);
        DoubleVector out = p.max(q).min(fromArray(SPECIES, limits, h));
        inverse = fromArray(SPECIES, inverseY, h);
        o = fromArray(SPECIES, oy, h);
        p = broadcast(SPECIES, b[1]).sub(o.add(wide)).mul(inverse);
        q = broadcast(SPECIES, b[4]).sub(o.sub(wide)).mul(inverse);
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        inverse = fromArray(SPECIES, inverseZ, h);
        o = fromArray(SPECIES, oz, h);
        p = broadcast(SPECIES, b[2]).sub(o.add(wide)).mul(inverse);
        q = broadcast(SPECIES, b[5]).sub(o.sub(wide)).mul(inverse);
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        in.intoArray(since, h);
        return (int) in.compare(LE, out).toLong();
    }

    private void shear(int i) {
        double x = Math.abs(dx[i]);
        double y = Math.abs(dy[i]);
        double z = Math.abs(dz[i]);
        if (x >= y && x >= z) {
            shear(i, 1, 2, 0, dy[i], dz[i], dx[i], oy[i], oz[i], ox[i]);
        } else if (y >= z) {
            shear(i, 2, 0, 1, dz[i], dx[i], dy[i], oz[i], ox[i], oy[i]);
        } else {
            shear(i, 0, 1, 2, dx[i], dy[i], dz[i], ox[i], oy[i], oz[i]);
        }
    }

    private void shear(int i, int ax, int ay, int az, double x, double y, double z, double px, double py, double pz) {
        axisX[i] = MeshTree.WIDTH * ax;
        axisY[i] = MeshTree.WIDTH * ay;
        axisZ[i] = MeshTree.WIDTH * az;
        originX[i] = px;
        originY[i] = py;
        originZ[i] = pz;
        double per = 1 / z;
        perDepth[i] = per;
        shearX[i] = x * per;
        shearY[i] = y * per;
    }

    private void begin(MeshTree tree, int h) {
        DoubleVector t = fromArray(SPECIES, since, h);
        DoubleVector one = fromArray(SPECIES, unit, h);
        DoubleVector x = fromArray(SPECIES, dx, h);
        DoubleVector o = fromArray(SPECIES, ox, h);
        DoubleVector far = o.abs();
        DoubleVector at = x.mul(t).add(o);
        DoubleVector most = at.abs();
        ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startX, h);
        ((FloatVector) x.div(one).convertShape(D2F, HALF, 0)).intoArray(stepX, h);
        x = fromArray(SPECIES, dy, h);
        o = fromArray(SPECIES, oy, h);
        far = far.max(o.abs());
        at = x.mul(t).add(o);
        most = most.max(at.abs());
        ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startY, h);
        ((FloatVector) x.div(one).convertShape(D2F, HALF, 0)).intoArray(stepY, h);
        x = fromArray(SPECIES, dz, h);
        o = fromArray(SPECIES, oz, h);
        far = far.max(o.abs());
        at = x.mul(t).add(o);
        most = most.max(at.abs());
        ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startZ, h);
        ((FloatVector) x.div(one).convertShape(D2F, HALF, 0)).intoArray(stepZ, h);
        ((FloatVector) most.add(tree.reach).mul(0x1p-20).add(far.add(most).add(tree.reach).mul(0x1p-46)).convertShape(D2F, HALF, 0))
                .intoArray(wide, h);
        FloatVector.fromArray(HALF, stepX, h).intoArray(steepX, h);
        FloatVector.fromArray(HALF, stepY, h).intoArray(steepY, h);
        FloatVector.fromArray(HALF, stepZ, h).intoArray(steepZ, h);
    }

    /** Replaces steps by their inverses. */
    private void axis(float[] start, float[] steep, float[] low, float[] high, int h) {
        FloatVector i = FloatVector.broadcast(HALF, 1).div(FloatVector.fromArray(HALF, steep, h));
        i = i.blend((float) STEEPEST, i.compare(GT, (float) STEEPEST)).blend((float) -STEEPEST, i.compare(LT, (float) -STEEPEST));
        i.intoArray(steep, h);
        FloatVector o = FloatVector.fromArray(HALF, start, h);
        FloatVector pads = FloatVector.fromArray(HALF, wide, h);
        o.add(pads).neg().mul(i).intoArray(low, h);
        o.sub(pads).neg().mul(i).intoArray(high, h);
    }

    /** Lets ray {@code i} go no farther than a distance. */
    void limit(int i, double distance) {
        far[i] = Float.floatToRawIntBits((float) ((distance - since[i]) * unit[i] * UP));
    }

    /** The slots of a leaf whose triangles ray {@code i} meets by the signs of {@link MeshRay#distance}; writes depths to {@code t}. */
    int signs(double[] v, int i, double[] t) {
        int mask = 0;
        int x = axisX[i];
        int y = axisY[i];
        int z = axisZ[i];
        double px = originX[i];
        double py = originY[i];
        double pz = originZ[i];
        double sx = shearX[i];
        double sy = shearY[i];
        for (int h = 0; h < MeshTree.WIDTH; h += Lanes.COUNT) {
            DoubleVector az = fromArray(SPECIES, v, z + h).sub(pz);
            DoubleVector ax = fromArray(SPECIES, v, x + h).sub(px).sub(az.mul(sx));
            DoubleVector ay = fromArray(SPECIES, v, y + h).sub(py).sub(az.mul(sy));
            DoubleVector bz = fromArray(SPECIES, v, MeshTree.VERTEX + z + h).sub(pz);
            DoubleVector bx = fromArray(SPECIES, v, MeshTree.VERTEX + x + h).sub(px).sub(bz.mul(sx));
            DoubleVector by = fromArray(SPECIES, v, MeshTree.VERTEX + y + h).sub(py).sub(bz.mul(sy));
            DoubleVector cz = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + z + h).sub(pz);
            DoubleVector cx = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + x + h).sub(px).sub(cz.mul(sx));
            DoubleVector cy = fromArray(SPECIES, v, 2 * MeshTree.VERTEX + y + h).sub(py).sub(cz.mul(sy));
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

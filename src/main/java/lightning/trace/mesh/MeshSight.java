package lightning.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.MAX;
import static jdk.incubator.vector.VectorOperators.MIN;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.trace.solid.Lanes;
import lightning.trace.solid.Rays;

/**
 * The rays of a group as floats, to be tested against boxes: what may be met. Reused; not shared between threads.
 *
 * <p><b>From which end.</b> Ways that all end at one point, as ways to a light do, are seen from there: as lines from that point,
 * backwards. A line passes c + s·g; the ray passes it at o + t·d with s = t, or backwards s = 1 − t, g = o − c. Backwards the two differ by
 * t times what o + d is off from c, which is measured, and the rounding of g, below u·(|o| + |c|), u = 2⁻⁵³.
 *
 * <p><b>What a line must cross.</b> {@link MeshRay} meets a triangle at a distance at which the ray is within 16u·(|o| + r) + 6u·(|o| + r) of the
 * triangle's box, r a bound on the mesh's coordinates. So the line is, at the s of that distance, within 2⁻⁴⁸·(|o| + |c| + r) plus what was measured of
 * that box: it is made wide by {@code loose}, four times as much.
 *
 * <p><b>Where it begins.</b> So that floats tell triangles apart however far away a line comes from, it begins anew where the first line of
 * the group enters the box of the whole mesh, made wide: at {@code depth} along the direction's largest component, the same for
 * all, which keeps lines of one point in one narrow frustum. Computing that is off by less than 8u·(|c| + r), which is within {@code loose}. Distances are
 * counted from there in units of that component, so that every inverse is from 1 to {@link #STEEPEST} in absolute value.
 *
 * <p><b>Floats.</b> With R a bound on the mesh's |coordinates| plus those of the new origin and v = 2⁻²⁴: rounding that origin takes
 * v·R, the inverse 2v of a distance below 2R, its product with the origin v·R, the fused sum v·2R; together less than 8v·R, that is 2⁻²¹·R. A line
 * flatter than 1 : 2⁶⁰ on an axis drifts by less than 2⁻⁵⁸·R. The new origin is off by less than 4u·(|c| + R). The floats' line is made wide by
 * 2⁻²⁰·R + {@code loose}, so that it crosses every box that holds a triangle which {@link MeshRay} meets, and no later than that is met.
 */
final class MeshSight {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    private static final VectorSpecies<Float> HALF = MeshLanes.HALF;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    private static final double STEEPEST = 0x1p60;
    /** A line that is shorter has no inverse that {@link MeshRay} knows. */
    private static final double SHORTEST = 1 / MeshRay.STEEPEST;
    /** More than the rounding of a distance to float. */
    private static final double UP = 1 + 0x1p-20;
    /** Eight times the padding of a {@link MeshRay}. */
    private static final double LOOSE = 0x1p-46;
    /** Less than 1 by more than depths are rounded. */
    private static final double BEFORE = 1 - 0x1p-48;
    /** Ways whose ends lie farther apart than this share of their size end at different points. */
    private static final double SAME = 0x1p-40;

    private final MeshLanes rays;
    /** Where lines come from, where they go, and the inverse of that, by axes: of rays seen forwards, and of such seen from their ends. */
    private final double[][][] forwards;
    private final double[][][] backwards;
    private double[][] from;
    private double[][] go;
    private double[][] inverse;
    /** How far rays may be off their lines, beside rounding. */
    private double off;
    private final double[] loose;
    /** Where each line begins anew; its largest component, in absolute value, and the inverse of that. */
    private final double[] since;
    private final double[] unit;
    private final double[] perUnit;
    /** Those lines. */
    final float[] startX;
    final float[] startY;
    final float[] startZ;
    final float[] stepX;
    final float[] stepY;
    final float[] stepZ;
    final float[] wide;
    /** The plane {@code x = b} is met at {@code b·steep + low}, seen from the wide line's one side, and at {@code b·steep + high} from the other. */
    private final float[] steepX;
    private final float[] steepY;
    private final float[] steepZ;
    private final float[] lowX;
    private final float[] lowY;
    private final float[] lowZ;
    private final float[] highX;
    private final float[] highY;
    private final float[] highZ;
    /** How far each line goes, as the bits of a float; negative for one that goes nowhere. */
    final int[] far;
    /** Where line {@link #children} enters each child, as the bits of floats. */
    final int[] in = new int[MeshTree.WIDTH];

    MeshSight(MeshLanes rays, int most) {
        this.rays = rays;
        forwards = new double[][][] {{rays.ox, rays.oy, rays.oz}, {rays.dx, rays.dy, rays.dz},
            {rays.inverseX, rays.inverseY, rays.inverseZ}};
        backwards = new double[3][3][most];
        loose = new double[most];
        since = new double[most];
        unit = new double[most];
        perUnit = new double[most];
        startX = new float[most];
        startY = new float[most];
        startZ = new float[most];
        stepX = new float[most];
        stepY = new float[most];
        stepZ = new float[most];
        wide = new float[most];
        steepX = new float[most];
        steepY = new float[most];
        steepZ = new float[most];
        lowX = new float[most];
        lowY = new float[most];
        lowZ = new float[most];
        highX = new float[most];
        highY = new float[most];
        highZ = new float[most];
        far = new int[most];
    }

    /**
     * Looks at the rays that were taken.
     *
     * @param open   those of each packet, one bit for each; gets those that are seen as lines that may reach the mesh's box
     * @param brief  gets those of each packet that are too short to be seen as lines: ways to a light at a row's very point
     * @param limits how far each goes
     * @param any    whether it is enough to know that something is met
     */
    void enter(MeshTree tree, int[] open, int[] brief, int packets, double[] limits, boolean any) {
        boolean back = any && endTogether(open, packets, limits);
        double[][][] lines = back ? backwards : forwards;
        from = lines[0];
        go = lines[1];
        inverse = lines[2];
        if (back) {
            for (int k = 0; k < 3; k++) {
                turn(k, packets);
            }
        } else {
            off = 0;
        }
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < packets; k++) {
            int met = 0;
            int seen = 0;
            for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
                met |= clip(tree, limits, back, k * Rays.WIDTH + h) << h;
                seen |= (int) fromArray(SPECIES, unit, k * Rays.WIDTH + h).compare(GE, SHORTEST).toLong() << h;
            }
            brief[k] = open[k] & ~seen;
            open[k] &= met & seen;
            if (open[k] != 0) {
                depth = Math.min(depth, depth(k * Rays.WIDTH, open[k]));
            }
        }
        depth *= BEFORE;
        for (int k = 0; k < packets; k++) {
            if (open[k] != 0) {
                begin(tree, depth, k * Rays.WIDTH);
                steep(startX, steepX, lowX, highX, k * Rays.WIDTH);
                steep(startY, steepY, lowY, highY, k * Rays.WIDTH);
                steep(startZ, steepZ, lowZ, highZ, k * Rays.WIDTH);
            }
            reach(limits, back, k * Rays.WIDTH, open[k]);
        }
    }

    /** The least depth at which rays of a packet enter. */
    private double depth(int packet, int open) {
        DoubleVector least = broadcast(SPECIES, Double.POSITIVE_INFINITY);
        for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
            DoubleVector in = fromArray(SPECIES, since, packet + h).mul(fromArray(SPECIES, unit, packet + h));
            least = least.blend(in, in.compare(LT, least).and(VectorMask.fromLong(SPECIES, open >>> h)));
        }
        return least.reduceLanes(MIN);
    }

    /** Writes how far the lines of a packet go. */
    private void reach(double[] limits, boolean back, int packet, int open) {
        for (int h = packet; open != 0 && h < packet + Rays.WIDTH; h += Lanes.COUNT) {
            DoubleVector distance = back ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h);
            ((FloatVector) distance.sub(fromArray(SPECIES, since, h)).mul(fromArray(SPECIES, unit, h)).mul(UP).convertShape(D2F, HALF, 0))
                    .reinterpretAsInts().intoArray(far, h);
        }
        for (int closed = ~open & -1 >>> -Rays.WIDTH; closed != 0; closed &= closed - 1) {
            far[packet + Integer.numberOfTrailingZeros(closed)] = -1;
        }
    }

    /** Whether all rays end at one point, at distance 1 or before; writes {@link #off}. */
    private boolean endTogether(int[] open, int packets, double[] limits) {
        int first = rays.first;
        double x = rays.ox[first] + rays.dx[first];
        double y = rays.oy[first] + rays.dy[first];
        double z = rays.oz[first] + rays.dz[first];
        DoubleVector most = broadcast(SPECIES, 0);
        for (int i = 0; i < packets * Rays.WIDTH; i += Lanes.COUNT) {
            VectorMask<Double> live = VectorMask.fromLong(SPECIES, open[i / Rays.WIDTH] >>> i % Rays.WIDTH);
            if (fromArray(SPECIES, limits, i).compare(GT, 1).and(live).anyTrue()) {
                return false;
            }
            DoubleVector apart = fromArray(SPECIES, rays.ox, i).add(fromArray(SPECIES, rays.dx, i)).sub(x).abs()
                    .max(fromArray(SPECIES, rays.oy, i).add(fromArray(SPECIES, rays.dy, i)).sub(y).abs())
                    .max(fromArray(SPECIES, rays.oz, i).add(fromArray(SPECIES, rays.dz, i)).sub(z).abs());
            most = most.blend(apart, apart.compare(GT, most).and(live));
        }
        off = most.reduceLanes(MAX);
        backwards[0][0][0] = x;
        backwards[0][1][0] = y;
        backwards[0][2][0] = z;
        return off <= SAME * (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) + rays.pad[first] / MeshRay.PAD);
    }

    /** Makes lines from the common end, on one axis. */
    private void turn(int axis, int packets) {
        double end = from[axis][0];
        double[] origin = forwards[0][axis];
        for (int i = 0; i < packets * Rays.WIDTH; i += Lanes.COUNT) {
            broadcast(SPECIES, end).intoArray(from[axis], i);
            DoubleVector g = fromArray(SPECIES, origin, i).sub(end);
            g.intoArray(go[axis], i);
            DoubleVector per = broadcast(SPECIES, 1).div(g);
            per.blend(MeshRay.STEEPEST, per.compare(GT, MeshRay.STEEPEST)).blend(-MeshRay.STEEPEST, per.compare(LT, -MeshRay.STEEPEST))
                    .intoArray(inverse[axis], i);
        }
    }

    /** Finds where lines enter the box of the whole mesh; which do. */
    private int clip(MeshTree tree, double[] limits, boolean back, int h) {
        float[] b = tree.bounds;
        DoubleVector x = fromArray(SPECIES, from[0], h);
        DoubleVector y = fromArray(SPECIES, from[1], h);
        DoubleVector z = fromArray(SPECIES, from[2], h);
        DoubleVector room = x.abs().reinterpretAsLongs().max(y.abs().reinterpretAsLongs()).max(z.abs().reinterpretAsLongs())
                .reinterpretAsDoubles().add(tree.reach).mul(LOOSE).add(fromArray(SPECIES, rays.pad, h).mul(LOOSE / MeshRay.PAD)).add(off);
        room.intoArray(loose, h);
        DoubleVector i = fromArray(SPECIES, inverse[0], h);
        LongVector p = broadcast(SPECIES, b[0]).sub(x.add(room)).mul(i).reinterpretAsLongs();
        LongVector q = broadcast(SPECIES, b[3]).sub(x.sub(room)).mul(i).reinterpretAsLongs();
        LongVector in = p.min(q).max(0);
        LongVector out = p.max(q).min((back ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h)).reinterpretAsLongs());
        DoubleVector least = i.abs();
        i = fromArray(SPECIES, inverse[1], h);
        p = broadcast(SPECIES, b[1]).sub(y.add(room)).mul(i).reinterpretAsLongs();
        q = broadcast(SPECIES, b[4]).sub(y.sub(room)).mul(i).reinterpretAsLongs();
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        LongVector per = least.reinterpretAsLongs().min(i.abs().reinterpretAsLongs());
        i = fromArray(SPECIES, inverse[2], h);
        p = broadcast(SPECIES, b[2]).sub(z.add(room)).mul(i).reinterpretAsLongs();
        q = broadcast(SPECIES, b[5]).sub(z.sub(room)).mul(i).reinterpretAsLongs();
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        per.min(i.abs().reinterpretAsLongs()).reinterpretAsDoubles().intoArray(perUnit, h);
        in.reinterpretAsDoubles().intoArray(since, h);
        fromArray(SPECIES, go[0], h).abs().reinterpretAsLongs().max(fromArray(SPECIES, go[1], h).abs().reinterpretAsLongs())
                .max(fromArray(SPECIES, go[2], h).abs().reinterpretAsLongs()).reinterpretAsDoubles().intoArray(unit, h);
        return (int) in.compare(LE, out).toLong();
    }

    private void begin(MeshTree tree, double depth, int packet) {
        for (int h = packet; h < packet + Rays.WIDTH; h += Lanes.COUNT) {
            DoubleVector per = fromArray(SPECIES, perUnit, h);
            DoubleVector one = fromArray(SPECIES, unit, h);
            DoubleVector t = per.mul(depth);
            t.intoArray(since, h);
            DoubleVector g = fromArray(SPECIES, go[0], h);
            DoubleVector at = g.mul(t).add(fromArray(SPECIES, from[0], h));
            DoubleVector most = at.abs();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startX, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepX, h);
            ((FloatVector) fromArray(SPECIES, inverse[0], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepX, h);
            g = fromArray(SPECIES, go[1], h);
            at = g.mul(t).add(fromArray(SPECIES, from[1], h));
            most = most.reinterpretAsLongs().max(at.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startY, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepY, h);
            ((FloatVector) fromArray(SPECIES, inverse[1], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepY, h);
            g = fromArray(SPECIES, go[2], h);
            at = g.mul(t).add(fromArray(SPECIES, from[2], h));
            most = most.reinterpretAsLongs().max(at.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startZ, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepZ, h);
            ((FloatVector) fromArray(SPECIES, inverse[2], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepZ, h);
            ((FloatVector) most.add(tree.reach).mul(0x1p-20).add(fromArray(SPECIES, loose, h)).convertShape(D2F, HALF, 0))
                    .intoArray(wide, h);
        }
    }

    private void steep(float[] start, float[] steep, float[] low, float[] high, int h) {
        FloatVector i = FloatVector.fromArray(FLOATS, steep, h);
        i = i.blend((float) STEEPEST, i.compare(GT, (float) STEEPEST)).blend((float) -STEEPEST, i.compare(LT, (float) -STEEPEST));
        i.intoArray(steep, h);
        FloatVector o = FloatVector.fromArray(FLOATS, start, h);
        FloatVector room = FloatVector.fromArray(FLOATS, wide, h);
        o.add(room).neg().mul(i).intoArray(low, h);
        o.sub(room).neg().mul(i).intoArray(high, h);
    }

    /** Lets ray {@code i} go no farther than a distance; only of rays seen forwards. */
    void limit(int i, double distance) {
        far[i] = Float.floatToRawIntBits((float) ((distance - since[i]) * unit[i] * UP));
    }

    /** How far any of the rays {@code i … end − 1} still goes. */
    int reach(int i, int end) {
        IntVector most = IntVector.fromArray(INTS, far, i);
        for (int h = i + Rays.WIDTH; h < end; h += Rays.WIDTH) {
            most = most.max(IntVector.fromArray(INTS, far, h));
        }
        return most.reduceLanes(MAX);
    }

    /** Which rays of the packet from {@code h} on may meet the box at {@code b[i]}. */
    int enters(float[] b, int i, int h) {
        FloatVector steep = FloatVector.fromArray(FLOATS, steepX, h);
        IntVector p = steep.fma(FloatVector.broadcast(FLOATS, b[i]), FloatVector.fromArray(FLOATS, lowX, h)).reinterpretAsInts();
        IntVector q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 8]), FloatVector.fromArray(FLOATS, highX, h)).reinterpretAsInts();
        IntVector enters = p.min(q).max(0);
        IntVector leaves = p.max(q).min(IntVector.fromArray(INTS, far, h));
        steep = FloatVector.fromArray(FLOATS, steepY, h);
        p = steep.fma(FloatVector.broadcast(FLOATS, b[i + 16]), FloatVector.fromArray(FLOATS, lowY, h)).reinterpretAsInts();
        q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 24]), FloatVector.fromArray(FLOATS, highY, h)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        steep = FloatVector.fromArray(FLOATS, steepZ, h);
        p = steep.fma(FloatVector.broadcast(FLOATS, b[i + 32]), FloatVector.fromArray(FLOATS, lowZ, h)).reinterpretAsInts();
        q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 40]), FloatVector.fromArray(FLOATS, highZ, h)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        return (int) enters.compare(LE, leaves).toLong();
    }

    /** Which children of a node ray {@code i} may meet; writes {@link #in}. */
    int children(float[] b, int node, int i) {
        int at = MeshTree.NODE * node;
        float sx = steepX[i];
        float sy = steepY[i];
        float sz = steepZ[i];
        // Whether it comes to the lesser or to the greater side first.
        int x = sx > 0 ? at : at + 8;
        int y = sy > 0 ? at + 16 : at + 24;
        int z = sz > 0 ? at + 32 : at + 40;
        FloatVector steep = FloatVector.broadcast(EIGHT, sx);
        IntVector enters = FloatVector.fromArray(EIGHT, b, x).fma(steep, FloatVector.broadcast(EIGHT, sx > 0 ? lowX[i] : highX[i]))
                .reinterpretAsInts().max(0);
        IntVector leaves = FloatVector.fromArray(EIGHT, b, 2 * at + 8 - x)
                .fma(steep, FloatVector.broadcast(EIGHT, sx > 0 ? highX[i] : lowX[i])).reinterpretAsInts().min(far[i]);
        steep = FloatVector.broadcast(EIGHT, sy);
        enters = enters.max(FloatVector.fromArray(EIGHT, b, y).fma(steep, FloatVector.broadcast(EIGHT, sy > 0 ? lowY[i] : highY[i]))
                .reinterpretAsInts());
        leaves = leaves.min(FloatVector.fromArray(EIGHT, b, 2 * at + 40 - y)
                .fma(steep, FloatVector.broadcast(EIGHT, sy > 0 ? highY[i] : lowY[i])).reinterpretAsInts());
        steep = FloatVector.broadcast(EIGHT, sz);
        enters = enters.max(FloatVector.fromArray(EIGHT, b, z).fma(steep, FloatVector.broadcast(EIGHT, sz > 0 ? lowZ[i] : highZ[i]))
                .reinterpretAsInts());
        leaves = leaves.min(FloatVector.fromArray(EIGHT, b, 2 * at + 72 - z)
                .fma(steep, FloatVector.broadcast(EIGHT, sz > 0 ? highZ[i] : lowZ[i])).reinterpretAsInts());
        enters.intoArray(in, 0);
        return (int) enters.compare(LE, leaves).toLong();
    }
}

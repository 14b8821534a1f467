package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.MAX;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.Lanes;
import lightning.render.trace.solid.Rays;

/**
 * The lines of a group ({@link MeshLines}) as floats, to be tested against boxes: what may be met. Reused; not shared between threads.
 *
 * <p><b>Floats.</b> With R a bound on the mesh's |coordinates| plus those of the new origin and v = 2⁻²⁴: rounding that origin takes
 * v·R, the inverse 2v of a distance below 2R, its product with the origin v·R, the fused sum v·2R; together less than 8v·R, that is 2⁻²¹·R. A line
 * flatter than 1 : 2⁶⁰ on an axis drifts by less than 2⁻⁵⁸·R. The new origin is off by less than 4u·(|c| + R), u and c as those of the lines. The floats' line is made wide by
 * 2⁻²⁰·R + {@code loose} = w, so that it crosses every box that holds a triangle which {@link MeshRay} meets, and no later than that is met.
 */
final class MeshSight {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    private static final VectorSpecies<Float> HALF = MeshLanes.HALF;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    /** No line is flatter on an axis than 1 to this. */
    static final double STEEPEST = 0x1p60;
    /** More than the rounding of a distance to float. */
    private static final double UP = 1 + 0x1p-20;

    /** Wider lines may have products that are no floats: those of coordinates up to 1e18 are. */
    private static final float WIDEST = 1e11f;
    private static final int ALL = -1 >>> -MeshTree.WIDTH;

    private final MeshLines lines;
    /** Where each line begins anew, in doubles. */
    private final double[] since;
    private final double[] unit;
    /** The lines in floats. */
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
    /** Whether all lines come from one point, begin there, are as wide, and run along their rays. */
    boolean fan;
    /** How far each line goes, as the bits of a float; negative for one that goes nowhere. */
    final int[] far;
    /** Where line {@link #children} enters each child, as the bits of floats. */
    final int[] in = new int[MeshTree.WIDTH];

    MeshSight(MeshLanes rays, int most) {
        lines = new MeshLines(rays, most);
        since = lines.since;
        unit = lines.unit;
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
        double depth = lines.enter(tree, open, brief, packets, limits, any);
        fan = false;
        if (lines.fan) {
            spread(tree, open, packets, limits);
            return;
        }
        for (int k = 0; k < packets; k++) {
            if (open[k] != 0) {
                begin(tree, depth, k * Rays.WIDTH);
                steep(startX, steepX, lowX, highX, k * Rays.WIDTH);
                steep(startY, steepY, lowY, highY, k * Rays.WIDTH);
                steep(startZ, steepZ, lowZ, highZ, k * Rays.WIDTH);
            }
            reach(limits, k * Rays.WIDTH, open[k]);
        }
    }

    /** Looks at lines from one point, which begin there. */
    private void spread(MeshTree tree, int[] open, int packets, double[] limits) {
        float room = (float) ((lines.distance() + tree.reach) * 0x1p-20 + lines.loose[0]);
        int end = packets * Rays.WIDTH;
        Arrays.fill(startX, 0, end, (float) lines.from[0][lines.first()]);
        Arrays.fill(startY, 0, end, (float) lines.from[1][lines.first()]);
        Arrays.fill(startZ, 0, end, (float) lines.from[2][lines.first()]);
        Arrays.fill(wide, 0, end, room);
        Arrays.fill(since, 0, end, 0);
        for (int k = 0; k < packets; k++) {
            if (open[k] != 0) {
                step(lines.go[0], lines.inverse[0], stepX, steepX, k * Rays.WIDTH);
                step(lines.go[1], lines.inverse[1], stepY, steepY, k * Rays.WIDTH);
                step(lines.go[2], lines.inverse[2], stepZ, steepZ, k * Rays.WIDTH);
                steep(startX, steepX, lowX, highX, k * Rays.WIDTH);
                steep(startY, steepY, lowY, highY, k * Rays.WIDTH);
                steep(startZ, steepZ, lowZ, highZ, k * Rays.WIDTH);
            }
            reach(limits, k * Rays.WIDTH, open[k]);
        }
        fan = !lines.tilted && room < WIDEST;
    }

    private void step(double[] go, double[] inverse, float[] step, float[] steep, int packet) {
        for (int h = packet; h < packet + Rays.WIDTH; h += Lanes.COUNT) {
            ((FloatVector) fromArray(SPECIES, go, h).mul(fromArray(SPECIES, lines.perUnit, h)).convertShape(D2F, HALF, 0)).intoArray(step,
                    h);
            ((FloatVector) fromArray(SPECIES, inverse, h).mul(fromArray(SPECIES, unit, h)).convertShape(D2F, HALF, 0)).intoArray(steep, h);
        }
    }

    /** Writes how far the lines of a packet go. */
    private void reach(double[] limits, int packet, int open) {
        for (int h = packet; open != 0 && h < packet + Rays.WIDTH; h += Lanes.COUNT) {
            DoubleVector distance = lines.back ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h);
            ((FloatVector) distance.sub(fromArray(SPECIES, since, h)).mul(fromArray(SPECIES, unit, h)).mul(UP).convertShape(D2F, HALF, 0))
                    .reinterpretAsInts().intoArray(far, h);
        }
        for (int closed = ~open & -1 >>> -Rays.WIDTH; closed != 0; closed &= closed - 1) {
            far[packet + Integer.numberOfTrailingZeros(closed)] = -1;
        }
    }

    private void begin(MeshTree tree, double depth, int packet) {
        for (int h = packet; h < packet + Rays.WIDTH; h += Lanes.COUNT) {
            DoubleVector per = fromArray(SPECIES, lines.perUnit, h);
            DoubleVector one = fromArray(SPECIES, unit, h);
            DoubleVector t = per.mul(depth);
            t.intoArray(since, h);
            DoubleVector g = fromArray(SPECIES, lines.go[0], h);
            DoubleVector at = g.mul(t).add(fromArray(SPECIES, lines.from[0], h));
            DoubleVector most = at.abs();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startX, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepX, h);
            ((FloatVector) fromArray(SPECIES, lines.inverse[0], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepX, h);
            g = fromArray(SPECIES, lines.go[1], h);
            at = g.mul(t).add(fromArray(SPECIES, lines.from[1], h));
            most = most.reinterpretAsLongs().max(at.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startY, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepY, h);
            ((FloatVector) fromArray(SPECIES, lines.inverse[1], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepY, h);
            g = fromArray(SPECIES, lines.go[2], h);
            at = g.mul(t).add(fromArray(SPECIES, lines.from[2], h));
            most = most.reinterpretAsLongs().max(at.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) at.convertShape(D2F, HALF, 0)).intoArray(startZ, h);
            ((FloatVector) g.mul(per).convertShape(D2F, HALF, 0)).intoArray(stepZ, h);
            ((FloatVector) fromArray(SPECIES, lines.inverse[2], h).mul(one).convertShape(D2F, HALF, 0)).intoArray(steepZ, h);
            ((FloatVector) most.add(tree.reach).mul(0x1p-20).add(fromArray(SPECIES, lines.loose, h)).convertShape(D2F, HALF, 0))
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

    /** Which rays of a set among those of the packets {@code from … end − 1} may meet the box at {@code b[i]}. */
    long enters(float[] b, int i, long set, int from, int end) {
        long enter = 0;
        for (int h = from; h < end; h += Rays.WIDTH) {
            if ((set >>> h & -1 >>> -Rays.WIDTH) != 0) {
                enter |= (long) enters(b, i, h) << h;
            }
        }
        return enter & set;
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

    /** The slots of a leaf whose triangles ray {@code i} may meet, where it is open; {@code extent} is the longest side of the leaf's box. */
    int meets(float[] v, int leaf, float extent, int i) {
        float w = wide[i];
        if (!(w < WIDEST) || lines.tilted) {
            return ALL;
        }
        float dx = stepX[i];
        float dy = stepY[i];
        float dz = stepZ[i];
        int at = MeshTree.LEAF * leaf;
        if (Math.abs(dz) == 1) {
            return LeafTriangles.meets(v, at, at + 8, at + 16, startX[i], startY[i], startZ[i], dx * dz, dy * dz, w, extent);
        }
        return Math.abs(dx) == 1 ? LeafTriangles.meets(v, at + 8, at + 16, at, startY[i], startZ[i], startX[i], dy * dx, dz * dx, w, extent)
                : LeafTriangles.meets(v, at + 16, at, at + 8, startZ[i], startX[i], startY[i], dz * dy, dx * dy, w, extent);
    }
}

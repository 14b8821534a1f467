package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.MAX;
import static jdk.incubator.vector.VectorOperators.MIN;
import static jdk.incubator.vector.VectorOperators.NE;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.Lanes;
import lightning.render.trace.solid.Rays;

/**
 * The rays of a group as lines: from which end each is seen, and where it begins anew. Reused; not shared between threads.
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
 * counted from there in units of that component, so that every inverse is from 1 to {@link MeshSight#STEEPEST} in absolute value. Lines of one point that is
 * near enough to the mesh begin there ({@link #fan}), which spares this and leaves them the point in common.
 */
final class MeshLines {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    /** A line that is shorter has no inverse that {@link MeshRay} knows. */
    private static final double SHORTEST = 1 / MeshRay.STEEPEST;
    /** Eight times the padding of a {@link MeshRay}. */
    private static final double LOOSE = 0x1p-46;
    /** Less than 1 by more than depths are rounded. */
    private static final double BEFORE = 1 - 0x1p-48;
    /** Ways whose ends lie farther apart than this share of their size end at different points. */
    private static final double SAME = 0x1p-40;
    /** A line so many times as long as it is loose runs along its ray: both ends are less than half as far off. */
    private static final double STRAIGHT = 0x1p28;

    /** Points farther from the mesh than so many times its largest coordinate are too far for floats. */
    private static final double NEAR = 4;

    private final MeshLanes rays;
    private final double[][][] forwards;
    private final double[][][] backwards;
    /** Where lines come from, where they go, and the inverse of that, by axes. */
    double[][] from;
    double[][] go;
    double[][] inverse;
    /** Whether rays are seen from their ends, which is at distance 1. */
    boolean back;
    /** Whether all lines come from one point that is near to the mesh, and begin there. */
    boolean fan;
    /** How far rays may be off their lines, beside rounding. */
    private double off;
    /** Whether some ray may run across its line by more than 2⁻²⁶ of its length. */
    boolean tilted;
    /** How wide a line must be made. */
    final double[] loose;
    /** Where each line enters the mesh's box, then where it begins anew; its largest component, in absolute value, and the inverse of that. */
    final double[] since;
    final double[] unit;
    final double[] perUnit;

    MeshLines(MeshLanes rays, int most) {
        this.rays = rays;
        forwards = new double[][][] {{rays.ox, rays.oy, rays.oz}, {rays.dx, rays.dy, rays.dz},
            {rays.inverseX, rays.inverseY, rays.inverseZ}};
        backwards = new double[3][3][most];
        loose = new double[most];
        since = new double[most];
        unit = new double[most];
        perUnit = new double[most];
    }

    /**
     * Makes lines of the rays that were taken.
     *
     * @param open   those of each packet, one bit for each; gets those that are seen as lines that may reach the mesh's box
     * @param brief  gets those of each packet that are too short to be seen as lines: ways to a light at a row's very point
     * @param limits how far each goes
     * @param any    whether it is enough to know that something is met
     * @return the depth along the largest component at which all begin anew
     */
    double enter(MeshTree tree, int[] open, int[] brief, int packets, double[] limits, boolean any) {
        back = any && endTogether(open, packets, limits);
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
        fan = (back || beginTogether(open, packets)) && isNear(tree);
        tilted = false;
        if (fan) {
            spread(tree, open, brief, packets);
            return 0;
        }
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < packets; k++) {
            int met = 0;
            int seen = 0;
            for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
                met |= clip(tree, limits, k * Rays.WIDTH + h) << h;
                seen |= (int) fromArray(SPECIES, unit, k * Rays.WIDTH + h).compare(GE, SHORTEST).toLong() << h;
            }
            brief[k] = open[k] & ~seen;
            open[k] &= met & seen;
            if (open[k] != 0) {
                depth = Math.min(depth, depth(k * Rays.WIDTH, open[k]));
                tilted |= back && tilted(k * Rays.WIDTH, open[k]);
            }
        }
        return depth * BEFORE;
    }

    /** Takes lines that begin at one point as they are, all as loose as the loosest. */
    private void spread(MeshTree tree, int[] open, int[] brief, int packets) {
        DoubleVector pad = broadcast(SPECIES, 0);
        for (int i = 0; i < packets * Rays.WIDTH; i += Lanes.COUNT) {
            DoubleVector p = fromArray(SPECIES, rays.pad, i);
            pad = pad.blend(p, p.compare(GT, pad).and(VectorMask.fromLong(SPECIES, open[i / Rays.WIDTH] >>> i % Rays.WIDTH)));
        }
        double most = (distance() + tree.reach) * LOOSE + pad.reduceLanes(MAX) * (LOOSE / MeshRay.PAD) + off;
        Arrays.fill(loose, 0, packets * Rays.WIDTH, most);
        for (int k = 0; k < packets; k++) {
            int seen = 0;
            int straight = 0;
            for (int i = 0; i < Rays.WIDTH; i += Lanes.COUNT) {
                int h = k * Rays.WIDTH + i;
                DoubleVector length = fromArray(SPECIES, go[0], h).abs();
                DoubleVector other = fromArray(SPECIES, go[1], h).abs();
                length = length.reinterpretAsLongs().max(other.reinterpretAsLongs()).reinterpretAsDoubles();
                other = fromArray(SPECIES, go[2], h).abs();
                length = length.reinterpretAsLongs().max(other.reinterpretAsLongs()).reinterpretAsDoubles();
                length.intoArray(unit, h);
                broadcast(SPECIES, 1).div(length).intoArray(perUnit, h);
                seen |= (int) length.compare(GE, SHORTEST).toLong() << i;
                straight |= (int) length.compare(GE, most * STRAIGHT).toLong() << i;
            }
            brief[k] = open[k] & ~seen;
            open[k] &= seen;
            tilted |= back && (open[k] & ~straight) != 0;
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

    private boolean tilted(int packet, int open) {
        int tilted = 0;
        for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
            tilted |= (int) fromArray(SPECIES, unit, packet + h).compare(LT, fromArray(SPECIES, loose, packet + h).mul(STRAIGHT))
                    .toLong() << h;
        }
        return (tilted & open) != 0;
    }

    /** Whether all rays begin at one point. */
    private boolean beginTogether(int[] open, int packets) {
        double x = rays.ox[rays.first];
        double y = rays.oy[rays.first];
        double z = rays.oz[rays.first];
        for (int i = 0; i < packets * Rays.WIDTH; i += Lanes.COUNT) {
            VectorMask<Double> apart = fromArray(SPECIES, rays.ox, i).compare(NE, x).or(fromArray(SPECIES, rays.oy, i).compare(NE, y))
                    .or(fromArray(SPECIES, rays.oz, i).compare(NE, z));
            if ((apart.toLong() & open[i / Rays.WIDTH] >>> i % Rays.WIDTH) != 0) {
                return false;
            }
        }
        return true;
    }

    /** Where the first line is. */
    int first() {
        return back ? 0 : rays.first;
    }

    private boolean isNear(MeshTree tree) {
        return distance() <= NEAR * tree.reach;
    }

    /** The largest coordinate of the point where the first line is, in absolute value. */
    double distance() {
        int i = first();
        return Math.max(Math.abs(from[0][i]), Math.max(Math.abs(from[1][i]), Math.abs(from[2][i])));
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
    private int clip(MeshTree tree, double[] limits, int h) {
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
}

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
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.RayBatch;

/**
 * The rays of a group as lines: from which end each is seen, and where it begins anew. Reused; not shared between threads.
 *
 * <p><b>From which end.</b> Ways that all end at one point, as ways to a light do, are seen from there: as lines from that point,
 * backwards. A line passes c + s·g; the ray passes it at o + t·d with s = t, or backwards s = 1 − t, g = o − c. Backwards the two differ by
 * t times what o + d is off from c, which is measured, and the rounding of g, below u·(|o| + |c|), u = 2⁻⁵³.
 *
 * <p><b>What a line must cross.</b> {@link MeshRay} meets a triangle at a distance at which the ray is within 16u·(|o| + r) + 6u·(|o| + r) of the
 * triangle's box, r a bound on the mesh's coordinates. So the line is, at the s of that distance, within 2⁻⁴⁸·(|o| + |c| + r) plus what was measured of
 * that box: it is made wide by {@code tolerance}, four times as much.
 *
 * <p><b>Where it begins.</b> So that floats tell triangles apart however far away a line comes from, it begins anew where the first line of
 * the group enters the box of the whole mesh, made wide: at {@code entryDepth} along the direction's largest component, the same for
 * all, which keeps lines of one point in one narrow frustum. Computing that is off by less than 8u·(|c| + r), which is within {@code tolerance}. Distances are
 * counted from there in units of that component, so that every inverse is from 1 to {@link MeshFloatLines#MAX_INVERSE} in absolute value. Lines of one point that is
 * near enough to the mesh begin there ({@link #hasSharedStart}), which spares this and leaves them the point in common.
 */
final class MeshLines {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    /** A line that is shorter has no inverse that {@link MeshRay} knows. */
    private static final double MIN_LENGTH = 1 / MeshRay.MAX_INVERSE;
    /** Eight times the padding of a {@link MeshRay}. */
    private static final double TOLERANCE_SHARE = 0x1p-46;
    /** Less than 1 by more than depths are rounded. */
    private static final double START_FACTOR = 1 - 0x1p-48;
    /** Ways whose ends lie farther apart than this share of their size end at different points. */
    private static final double COMMON_END_SHARE = 0x1p-40;
    /** A line so many times as long as it is loose runs along its ray: both ends are less than half as far off. */
    private static final double MIN_STRAIGHT_RATIO = 0x1p28;

    /** Points farther from the mesh than so many times its largest coordinate are too far for floats. */
    private static final double MAX_ORIGIN_RATIO = 4;

    private final MeshRayLanes rays;
    private final double[][][] forwardLines;
    private final double[][][] reversedLines;
    /** Where lines come from, where they go, and the inverse of that, by axes. */
    double[][] origins;
    double[][] directions;
    double[][] inverseDirections;
    /** Whether rays are seen from their ends, which is at distance 1. */
    boolean reversed;
    /** Whether all lines come from one point that is near to the mesh, and begin there. */
    boolean hasSharedStart;
    /** How far rays may be off their lines, beside rounding. */
    private double endSpread;
    /** Whether some ray may run across its line by more than 2⁻²⁶ of its length. */
    boolean hasSkewedRays;
    /** How wide a line must be made. */
    final double[] tolerance;
    /** Where each line enters the mesh's box, then where it begins anew; its largest component, in absolute value, and the inverse of that. */
    final double[] startDistance;
    final double[] maxComponent;
    final double[] inverseMaxComponent;

    MeshLines(MeshRayLanes rays, int capacity) {
        this.rays = rays;
        forwardLines = new double[][][] {{rays.ox, rays.oy, rays.oz}, {rays.dx, rays.dy, rays.dz},
            {rays.inverseX, rays.inverseY, rays.inverseZ}};
        reversedLines = new double[3][3][capacity];
        tolerance = new double[capacity];
        startDistance = new double[capacity];
        maxComponent = new double[capacity];
        inverseMaxComponent = new double[capacity];
    }

    /**
     * Makes lines of the rays that were taken.
     *
     * @param active   those of each packet, one bit for each; gets those that are seen as lines that may reach the mesh's box
     * @param tooShort  gets those of each packet that are too short to be seen as lines: ways to a light at a row's very point
     * @param limits how far each goes
     * @param anyHit    whether it is enough to know that something is met
     * @return the depth along the largest component at which all begin anew
     */
    double setRays(MeshTree tree, int[] active, int[] tooShort, int packets, double[] limits, boolean anyHit) {
        reversed = anyHit && hasCommonEnd(active, packets, limits);
        double[][][] lines = reversed ? reversedLines : forwardLines;
        origins = lines[0];
        directions = lines[1];
        inverseDirections = lines[2];
        if (reversed) {
            for (int k = 0; k < 3; k++) {
                reverseAxis(k, packets);
            }
        } else {
            endSpread = 0;
        }
        hasSharedStart = (reversed || hasCommonOrigin(active, packets)) && isNear(tree);
        hasSkewedRays = false;
        if (hasSharedStart) {
            setSharedStart(tree, active, tooShort, packets);
            return 0;
        }
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < packets; k++) {
            int entering = 0;
            int longEnough = 0;
            for (int h = 0; h < RayBatch.WIDTH; h += DoubleLanes.COUNT) {
                entering |= clip(tree, limits, k * RayBatch.WIDTH + h) << h;
                longEnough |= (int) fromArray(SPECIES, maxComponent, k * RayBatch.WIDTH + h).compare(GE, MIN_LENGTH).toLong() << h;
            }
            tooShort[k] = active[k] & ~longEnough;
            active[k] &= entering & longEnough;
            if (active[k] != 0) {
                depth = Math.min(depth, entryDepth(k * RayBatch.WIDTH, active[k]));
                hasSkewedRays |= reversed && hasSkewedRays(k * RayBatch.WIDTH, active[k]);
            }
        }
        return depth * START_FACTOR;
    }

    /** Takes lines that begin at one point as they are, all as loose as the loosest. */
    private void setSharedStart(MeshTree tree, int[] active, int[] tooShort, int packets) {
        DoubleVector pad = broadcast(SPECIES, 0);
        for (int i = 0; i < packets * RayBatch.WIDTH; i += DoubleLanes.COUNT) {
            DoubleVector p = fromArray(SPECIES, rays.padding, i);
            pad = pad.blend(p, p.compare(GT, pad).and(VectorMask.fromLong(SPECIES, active[i / RayBatch.WIDTH] >>> i % RayBatch.WIDTH)));
        }
        double maxTolerance = (startCoordinate() + tree.maxCoordinate) * TOLERANCE_SHARE
                + pad.reduceLanes(MAX) * (TOLERANCE_SHARE / MeshRay.PADDING_SHARE) + endSpread;
        Arrays.fill(tolerance, 0, packets * RayBatch.WIDTH, maxTolerance);
        for (int k = 0; k < packets; k++) {
            int longEnough = 0;
            int straight = 0;
            for (int i = 0; i < RayBatch.WIDTH; i += DoubleLanes.COUNT) {
                int h = k * RayBatch.WIDTH + i;
                DoubleVector length = fromArray(SPECIES, directions[0], h).abs();
                DoubleVector other = fromArray(SPECIES, directions[1], h).abs();
                length = length.reinterpretAsLongs().max(other.reinterpretAsLongs()).reinterpretAsDoubles();
                other = fromArray(SPECIES, directions[2], h).abs();
                length = length.reinterpretAsLongs().max(other.reinterpretAsLongs()).reinterpretAsDoubles();
                length.intoArray(maxComponent, h);
                broadcast(SPECIES, 1).div(length).intoArray(inverseMaxComponent, h);
                longEnough |= (int) length.compare(GE, MIN_LENGTH).toLong() << i;
                straight |= (int) length.compare(GE, maxTolerance * MIN_STRAIGHT_RATIO).toLong() << i;
            }
            tooShort[k] = active[k] & ~longEnough;
            active[k] &= longEnough;
            hasSkewedRays |= reversed && (active[k] & ~straight) != 0;
        }
    }

    /** The least depth at which rays of a packet enter. */
    private double entryDepth(int packet, int active) {
        DoubleVector minDepth = broadcast(SPECIES, Double.POSITIVE_INFINITY);
        for (int h = 0; h < RayBatch.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector in = fromArray(SPECIES, startDistance, packet + h).mul(fromArray(SPECIES, maxComponent, packet + h));
            minDepth = minDepth.blend(in, in.compare(LT, minDepth).and(VectorMask.fromLong(SPECIES, active >>> h)));
        }
        return minDepth.reduceLanes(MIN);
    }

    private boolean hasSkewedRays(int packet, int active) {
        int skewed = 0;
        for (int h = 0; h < RayBatch.WIDTH; h += DoubleLanes.COUNT) {
            skewed |= (int) fromArray(SPECIES, maxComponent, packet + h)
                    .compare(LT, fromArray(SPECIES, tolerance, packet + h).mul(MIN_STRAIGHT_RATIO))
                    .toLong() << h;
        }
        return (skewed & active) != 0;
    }

    /** Whether all rays begin at one point. */
    private boolean hasCommonOrigin(int[] active, int packets) {
        double x = rays.ox[rays.first];
        double y = rays.oy[rays.first];
        double z = rays.oz[rays.first];
        for (int i = 0; i < packets * RayBatch.WIDTH; i += DoubleLanes.COUNT) {
            VectorMask<Double> different = fromArray(SPECIES, rays.ox, i).compare(NE, x).or(fromArray(SPECIES, rays.oy, i).compare(NE, y))
                    .or(fromArray(SPECIES, rays.oz, i).compare(NE, z));
            if ((different.toLong() & active[i / RayBatch.WIDTH] >>> i % RayBatch.WIDTH) != 0) {
                return false;
            }
        }
        return true;
    }

    /** Where the first line is. */
    int firstLine() {
        return reversed ? 0 : rays.first;
    }

    private boolean isNear(MeshTree tree) {
        return startCoordinate() <= MAX_ORIGIN_RATIO * tree.maxCoordinate;
    }

    /** The largest coordinate of the point where the first line is, in absolute value. */
    double startCoordinate() {
        int i = firstLine();
        return Math.max(Math.abs(origins[0][i]), Math.max(Math.abs(origins[1][i]), Math.abs(origins[2][i])));
    }

    /** Whether all rays end at one point, at distance 1 or before; writes {@link #endSpread}. */
    private boolean hasCommonEnd(int[] active, int packets, double[] limits) {
        int first = rays.first;
        double x = rays.ox[first] + rays.dx[first];
        double y = rays.oy[first] + rays.dy[first];
        double z = rays.oz[first] + rays.dz[first];
        DoubleVector maxDistance = broadcast(SPECIES, 0);
        for (int i = 0; i < packets * RayBatch.WIDTH; i += DoubleLanes.COUNT) {
            VectorMask<Double> activeLanes = VectorMask.fromLong(SPECIES, active[i / RayBatch.WIDTH] >>> i % RayBatch.WIDTH);
            if (fromArray(SPECIES, limits, i).compare(GT, 1).and(activeLanes).anyTrue()) {
                return false;
            }
            DoubleVector endDistance = fromArray(SPECIES, rays.ox, i).add(fromArray(SPECIES, rays.dx, i)).sub(x).abs()
                    .max(fromArray(SPECIES, rays.oy, i).add(fromArray(SPECIES, rays.dy, i)).sub(y).abs())
                    .max(fromArray(SPECIES, rays.oz, i).add(fromArray(SPECIES, rays.dz, i)).sub(z).abs());
            maxDistance = maxDistance.blend(endDistance, endDistance.compare(GT, maxDistance).and(activeLanes));
        }
        endSpread = maxDistance.reduceLanes(MAX);
        reversedLines[0][0][0] = x;
        reversedLines[0][1][0] = y;
        reversedLines[0][2][0] = z;
        return endSpread <= COMMON_END_SHARE
                * (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) + rays.padding[first] / MeshRay.PADDING_SHARE);
    }

    /** Makes lines from the common end, on one axis. */
    private void reverseAxis(int axis, int packets) {
        double end = origins[axis][0];
        double[] origin = forwardLines[0][axis];
        for (int i = 0; i < packets * RayBatch.WIDTH; i += DoubleLanes.COUNT) {
            broadcast(SPECIES, end).intoArray(origins[axis], i);
            DoubleVector g = fromArray(SPECIES, origin, i).sub(end);
            g.intoArray(directions[axis], i);
            DoubleVector inverseLength = broadcast(SPECIES, 1).div(g);
            inverseLength.blend(MeshRay.MAX_INVERSE, inverseLength.compare(GT, MeshRay.MAX_INVERSE))
                    .blend(-MeshRay.MAX_INVERSE, inverseLength.compare(LT, -MeshRay.MAX_INVERSE))
                    .intoArray(inverseDirections[axis], i);
        }
    }

    /** Finds where lines enter the box of the whole mesh; which do. */
    private int clip(MeshTree tree, double[] limits, int h) {
        float[] b = tree.bounds;
        DoubleVector x = fromArray(SPECIES, origins[0], h);
        DoubleVector y = fromArray(SPECIES, origins[1], h);
        DoubleVector z = fromArray(SPECIES, origins[2], h);
        DoubleVector padding = x.abs().reinterpretAsLongs().max(y.abs().reinterpretAsLongs()).max(z.abs().reinterpretAsLongs())
                .reinterpretAsDoubles().add(tree.maxCoordinate).mul(TOLERANCE_SHARE)
                .add(fromArray(SPECIES, rays.padding, h).mul(TOLERANCE_SHARE / MeshRay.PADDING_SHARE)).add(endSpread);
        padding.intoArray(tolerance, h);
        DoubleVector i = fromArray(SPECIES, inverseDirections[0], h);
        LongVector p = broadcast(SPECIES, b[0]).sub(x.add(padding)).mul(i).reinterpretAsLongs();
        LongVector q = broadcast(SPECIES, b[3]).sub(x.sub(padding)).mul(i).reinterpretAsLongs();
        LongVector in = p.min(q).max(0);
        LongVector out = p.max(q).min((reversed ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h)).reinterpretAsLongs());
        DoubleVector minInverse = i.abs();
        i = fromArray(SPECIES, inverseDirections[1], h);
        p = broadcast(SPECIES, b[1]).sub(y.add(padding)).mul(i).reinterpretAsLongs();
        q = broadcast(SPECIES, b[4]).sub(y.sub(padding)).mul(i).reinterpretAsLongs();
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        LongVector inverseLength = minInverse.reinterpretAsLongs().min(i.abs().reinterpretAsLongs());
        i = fromArray(SPECIES, inverseDirections[2], h);
        p = broadcast(SPECIES, b[2]).sub(z.add(padding)).mul(i).reinterpretAsLongs();
        q = broadcast(SPECIES, b[5]).sub(z.sub(padding)).mul(i).reinterpretAsLongs();
        in = in.max(p.min(q));
        out = out.min(p.max(q));
        inverseLength.min(i.abs().reinterpretAsLongs()).reinterpretAsDoubles().intoArray(inverseMaxComponent, h);
        in.reinterpretAsDoubles().intoArray(startDistance, h);
        fromArray(SPECIES, directions[0], h).abs().reinterpretAsLongs().max(fromArray(SPECIES, directions[1], h).abs().reinterpretAsLongs())
                .max(fromArray(SPECIES, directions[2], h).abs().reinterpretAsLongs()).reinterpretAsDoubles().intoArray(maxComponent, h);
        return (int) in.compare(LE, out).toLong();
    }
}

package lightning.render.trace.mesh;

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
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.Initializer;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.LaneRays;

/**
 * Rays of a group as lines with a chosen end and a new start. Reused; not thread-safe.
 *
 * <p><b>Direction.</b> Rays that all end at one point, as shadow rays do, are reversed: they become lines from that point. A
 * line passes through c + s·g; the ray passes there at o + t·d with s = t, or s = 1 − t and g = o − c if reversed. In reversed
 * lines the two differ by t times the measured error of o + d from c, and by the rounding of g, below u·(|o| + |c|), u = 2⁻⁵³.
 *
 * <p><b>Width.</b> {@link MeshRay} hits a triangle at a distance at which the ray is within 16u·(|o| + r) + 6u·(|o| + r) of the
 * triangle's box, where r bounds the mesh's coordinates. So the line at the corresponding s is within 2⁻⁴⁸·(|o| + |c| + r) plus
 * the measured error of that box. It is padded by {@code tolerance}, four times as much.
 *
 * <p><b>Start.</b> Each line starts where the first line of the group enters the padded box of the whole mesh, so that float
 * tests stay precise for distant origins. All lines start at the same {@code entryDepth} along the largest component of the
 * direction, which keeps lines from one point in one narrow frustum. The error of this is less than 8u·(|c| + r), which is
 * within {@code tolerance}. Distances are counted from there in units of that component, so every inverse is from 1 to
 * {@link MeshFloatLines#MAX_INVERSE} in absolute value. Lines from one point near the mesh start at that point
 * ({@link #hasSharedStart}), which avoids this work and preserves their common origin.
 */
final class MeshLines {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    /** Minimum length of a line; shorter ones have no inverse in {@link MeshRay}'s range. */
    private static final double MIN_LENGTH = 1 / MeshRay.MAX_INVERSE;
    /** Eight times the padding of a {@link MeshRay}. */
    private static final double TOLERANCE_SHARE = 0x1p-46;
    /** Less than 1 by more than the rounding of depths. */
    private static final double START_FACTOR = 1 - 0x1p-48;
    /** Maximum distance between the ends of shadow rays, relative to their size, for a common end. */
    private static final double COMMON_END_SHARE = 0x1p-40;
    /**
     * Minimum ratio of length to error for a line that runs along its ray: the errors at both ends are less than half as large.
     */
    private static final double MIN_STRAIGHT_RATIO = 0x1p28;

    /**
     * Maximum distance of a common origin relative to the mesh's largest coordinate; more distant ones exceed the precision of
     * floats.
     */
    private static final double MAX_ORIGIN_RATIO = 4;

    private final MeshRayLanes rays;
    private final double[][][] forwardLines;
    private final double[][][] reversedLines;
    /** Origins, directions, and inverse directions of the lines, by axis; no inverses with a shared start. */
    double[][] origins;
    double[][] directions;
    double[][] inverseDirections;
    /** True if lines start at the ends of the rays, at distance 1. */
    boolean reversed;
    /** True if all lines start at one common point near the mesh. */
    boolean hasSharedStart;
    /** Tolerance of all lines with a shared start. */
    double sharedTolerance;
    /** Maximum distance of the rays from their lines, without rounding. */
    private double endSpread;
    /** True if a ray may deviate from its line's direction by more than 2⁻²⁶ of its length. */
    boolean hasSkewedRays;
    /** Padding of each line without a shared start. */
    final double[] tolerance;
    /**
     * Entry distance of each line into the mesh's box, later its new start; its largest absolute component, and the inverse of
     * that.
     */
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
     * Converts the rays of the group to lines.
     *
     * @param active rays of each packet, one bit each; receives the lines that may reach the mesh's box
     * @param tooShort receives the rays of each packet that are too short for lines: shadow rays to a light at the row's
     *     position
     * @param limits maximum distance of each ray
     * @param anyHit true if any hit suffices
     * @return common start depth along the largest component
     */
    @Initializer
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
        hasSharedStart = (reversed || rays.hasCommonOrigin) && isNear(tree);
        hasSkewedRays = false;
        if (hasSharedStart) {
            sharedTolerance = sharedTolerance(tree, active, packets);
            return 0;
        }
        if (reversed) {
            for (int k = 0; k < 3; k++) {
                invertAxis(k, packets);
            }
        } else {
            rays.computeInverses(packets);
        }
        double depth = Double.POSITIVE_INFINITY;
        for (int k = 0; k < packets; k++) {
            int entering = 0;
            int longEnough = 0;
            for (int h = 0; h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
                entering |= clip(tree, limits, k * LaneRays.WIDTH + h) << h;
                longEnough |= (int) fromArray(SPECIES, maxComponent, k * LaneRays.WIDTH + h).compare(GE, MIN_LENGTH).toLong() << h;
            }
            tooShort[k] = active[k] & ~longEnough;
            active[k] &= entering & longEnough;
            if (active[k] != 0) {
                depth = Math.min(depth, entryDepth(k * LaneRays.WIDTH, active[k]));
                hasSkewedRays |= reversed && hasSkewedRays(k * LaneRays.WIDTH, active[k]);
            }
        }
        return depth * START_FACTOR;
    }

    /** Returns the largest error of lines from a common origin, which are used unchanged. */
    private double sharedTolerance(MeshTree tree, int[] active, int packets) {
        double pad = rays.padding[rays.first];
        if (reversed) {
            DoubleVector max = broadcast(SPECIES, 0);
            for (int i = 0; i < packets * LaneRays.WIDTH; i += DoubleLanes.COUNT) {
                DoubleVector p = fromArray(SPECIES, rays.padding, i);
                max = max.blend(p, p.compare(GT, max).and(VectorMask.fromLong(SPECIES, active[i / LaneRays.WIDTH] >>> i % LaneRays.WIDTH)));
            }
            pad = max.reduceLanes(MAX);
        }
        return (startCoordinate() + tree.maxCoordinate) * TOLERANCE_SHARE + pad * (TOLERANCE_SHARE / MeshRay.PADDING_SHARE) + endSpread;
    }

    /**
     * Computes float steps of the lines of a packet from a common origin; writes {@link #maxComponent}.
     *
     * @param active rays of each packet, one bit each; receives the lines that are long enough
     * @param tooShort receives the others
     */
    void computeSteps(int k, int[] active, int[] tooShort, float[] stepX, float[] stepY, float[] stepZ) {
        int longEnough = 0;
        int straight = 0;
        for (int i = 0; i < LaneRays.WIDTH; i += DoubleLanes.COUNT) {
            int h = k * LaneRays.WIDTH + i;
            DoubleVector x = fromArray(SPECIES, directions[0], h);
            DoubleVector y = fromArray(SPECIES, directions[1], h);
            DoubleVector z = fromArray(SPECIES, directions[2], h);
            DoubleVector length = x.abs().reinterpretAsLongs().max(y.abs().reinterpretAsLongs()).max(z.abs().reinterpretAsLongs())
                    .reinterpretAsDoubles();
            length.intoArray(maxComponent, h);
            DoubleVector inverse = broadcast(SPECIES, 1).div(length);
            ((FloatVector) x.mul(inverse).convertShape(D2F, MeshRayLanes.HALF, 0)).intoArray(stepX, h);
            ((FloatVector) y.mul(inverse).convertShape(D2F, MeshRayLanes.HALF, 0)).intoArray(stepY, h);
            ((FloatVector) z.mul(inverse).convertShape(D2F, MeshRayLanes.HALF, 0)).intoArray(stepZ, h);
            longEnough |= (int) length.compare(GE, MIN_LENGTH).toLong() << i;
            straight |= (int) length.compare(GE, sharedTolerance * MIN_STRAIGHT_RATIO).toLong() << i;
        }
        tooShort[k] = active[k] & ~longEnough;
        active[k] &= longEnough;
        hasSkewedRays |= reversed && (active[k] & ~straight) != 0;
    }

    /** Returns the smallest entry depth of a packet's rays. */
    private double entryDepth(int packet, int active) {
        DoubleVector minDepth = broadcast(SPECIES, Double.POSITIVE_INFINITY);
        for (int h = 0; h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector in = fromArray(SPECIES, startDistance, packet + h).mul(fromArray(SPECIES, maxComponent, packet + h));
            minDepth = minDepth.blend(in, in.compare(LT, minDepth).and(VectorMask.fromLong(SPECIES, active >>> h)));
        }
        return minDepth.reduceLanes(MIN);
    }

    private boolean hasSkewedRays(int packet, int active) {
        int skewed = 0;
        for (int h = 0; h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            skewed |= (int) fromArray(SPECIES, maxComponent, packet + h)
                    .compare(LT, fromArray(SPECIES, tolerance, packet + h).mul(MIN_STRAIGHT_RATIO))
                    .toLong() << h;
        }
        return (skewed & active) != 0;
    }

    /** Returns the index of the first line. */
    int firstLine() {
        return reversed ? 0 : rays.first;
    }

    private boolean isNear(MeshTree tree) {
        return startCoordinate() <= MAX_ORIGIN_RATIO * tree.maxCoordinate;
    }

    /** Returns the largest absolute coordinate of the first line's origin. */
    double startCoordinate() {
        int i = firstLine();
        return Math.max(Math.abs(origins[0][i]), Math.max(Math.abs(origins[1][i]), Math.abs(origins[2][i])));
    }

    /** Returns whether all rays end at one point, at distance 1 or less; writes {@link #endSpread}. */
    private boolean hasCommonEnd(int[] active, int packets, double[] limits) {
        int first = rays.first;
        double x = rays.ox[first] + rays.dx[first];
        double y = rays.oy[first] + rays.dy[first];
        double z = rays.oz[first] + rays.dz[first];
        DoubleVector maxDistance = broadcast(SPECIES, 0);
        for (int i = 0; i < packets * LaneRays.WIDTH; i += DoubleLanes.COUNT) {
            VectorMask<Double> activeLanes = VectorMask.fromLong(SPECIES, active[i / LaneRays.WIDTH] >>> i % LaneRays.WIDTH);
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

    /** Reverses lines on one axis so that they start at the common end. */
    private void reverseAxis(int axis, int packets) {
        double end = origins[axis][0];
        double[] origin = forwardLines[0][axis];
        for (int i = 0; i < packets * LaneRays.WIDTH; i += DoubleLanes.COUNT) {
            broadcast(SPECIES, end).intoArray(origins[axis], i);
            fromArray(SPECIES, origin, i).sub(end).intoArray(directions[axis], i);
        }
    }

    private void invertAxis(int axis, int packets) {
        for (int i = 0; i < packets * LaneRays.WIDTH; i += DoubleLanes.COUNT) {
            DoubleVector inverseLength = broadcast(SPECIES, 1).div(fromArray(SPECIES, directions[axis], i));
            inverseLength.blend(MeshRay.MAX_INVERSE, inverseLength.compare(GT, MeshRay.MAX_INVERSE))
                    .blend(-MeshRay.MAX_INVERSE, inverseLength.compare(LT, -MeshRay.MAX_INVERSE))
                    .intoArray(inverseDirections[axis], i);
        }
    }

    /** Clips lines to the box of the whole mesh; returns the lines that enter it. */
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

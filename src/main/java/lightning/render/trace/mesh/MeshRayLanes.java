package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.NE;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.LaneRays;

/** Lane version of {@link MeshRay} for the rays of a group, operation by operation. Reused; not thread-safe. */
final class MeshRayLanes {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final int X = MeshTree.AXIS_FLOATS;
    static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));

    /** Origins, directions, and the values that {@link MeshRay} derives from them. */
    final double[] ox;
    final double[] oy;
    final double[] oz;
    final double[] dx;
    final double[] dy;
    final double[] dz;
    final double[] padding;
    /** Inverse directions, after {@link #computeInverses}. */
    final double[] inverseX;
    final double[] inverseY;
    final double[] inverseZ;
    /** First ray of the group. */
    int first;
    /** Its origin before the transform. */
    private double firstX;
    private double firstY;
    private double firstZ;
    /** True if all rays of the group start at one point. */
    boolean hasCommonOrigin;

    /** @param capacity number of rays, a multiple of a packet's */
    MeshRayLanes(int capacity) {
        ox = new double[capacity];
        oy = new double[capacity];
        oz = new double[capacity];
        dx = new double[capacity];
        dy = new double[capacity];
        dz = new double[capacity];
        padding = new double[capacity];
        inverseX = new double[capacity];
        inverseY = new double[capacity];
        inverseZ = new double[capacity];
    }

    /**
     * Sets the rays of a packet.
     *
     * @param m transform to the mesh's space at {@code m[at …]}
     * @param mask rays of the packet, not 0; values of other rays are undefined
     * @param to index of the first ray; 0 starts a new group
     */
    void addPacket(MeshTree tree, double[] m, int at, LaneRays p, int mask, int to) {
        if (to == 0) {
            first = Integer.numberOfTrailingZeros(mask);
            hasCommonOrigin = true;
        }
        boolean sameOrigin = to > 0 && hasCommonOrigin && startsAtFirst(p, mask);
        for (int h = 0; h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            if (sameOrigin) {
                repeatOrigin(to + h);
            } else {
                transformOrigins(tree, m, at, p, h, to + h);
            }
            transformDirections(m, at, p, h, to + h);
        }
        if (to == 0) {
            firstX = p.ox[first];
            firstY = p.oy[first];
            firstZ = p.oz[first];
        }
        if (sameOrigin) {
            return;
        }
        for (int h = 0; hasCommonOrigin && h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            VectorMask<Double> different = fromArray(SPECIES, ox, to + h).compare(NE, ox[first])
                    .or(fromArray(SPECIES, oy, to + h).compare(NE, oy[first])).or(fromArray(SPECIES, oz, to + h).compare(NE, oz[first]));
            hasCommonOrigin = (different.toLong() & mask >>> h) == 0;
        }
    }

    /** Returns whether rays of a packet start where the first ray of the group does, before the transform. */
    private boolean startsAtFirst(LaneRays p, int mask) {
        int different = 0;
        for (int h = 0; h < LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            different |= (int) fromArray(SPECIES, p.ox, h).compare(NE, firstX).or(fromArray(SPECIES, p.oy, h).compare(NE, firstY))
                    .or(fromArray(SPECIES, p.oz, h).compare(NE, firstZ)).toLong() << h;
        }
        return (different & mask) == 0;
    }

    private void repeatOrigin(int to) {
        broadcast(SPECIES, ox[first]).intoArray(ox, to);
        broadcast(SPECIES, oy[first]).intoArray(oy, to);
        broadcast(SPECIES, oz[first]).intoArray(oz, to);
        broadcast(SPECIES, padding[first]).intoArray(padding, to);
    }

    private void transformOrigins(MeshTree tree, double[] m, int i, LaneRays p, int from, int to) {
        DoubleVector x = fromArray(SPECIES, p.ox, from);
        DoubleVector y = fromArray(SPECIES, p.oy, from);
        DoubleVector z = fromArray(SPECIES, p.oz, from);
        DoubleVector tx = x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).add(m[i + 3]);
        DoubleVector ty = x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).add(m[i + 7]);
        DoubleVector tz = x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).add(m[i + 11]);
        tx.intoArray(ox, to);
        ty.intoArray(oy, to);
        tz.intoArray(oz, to);
        // Non-negative doubles are ordered like their bits, which lanes compare faster.
        tx.abs().reinterpretAsLongs().max(ty.abs().reinterpretAsLongs()).max(tz.abs().reinterpretAsLongs()).reinterpretAsDoubles()
                .add(tree.maxCoordinate).mul(MeshRay.PADDING_SHARE).intoArray(padding, to);
    }

    private void transformDirections(double[] m, int i, LaneRays p, int from, int to) {
        DoubleVector x = fromArray(SPECIES, p.dx, from);
        DoubleVector y = fromArray(SPECIES, p.dy, from);
        DoubleVector z = fromArray(SPECIES, p.dz, from);
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).intoArray(dx, to);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).intoArray(dy, to);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).intoArray(dz, to);
    }

    /** Computes the inverse directions of the first packets. */
    void computeInverses(int packets) {
        for (int h = 0; h < packets * LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            inverse(dx, inverseX, h);
            inverse(dy, inverseY, h);
            inverse(dz, inverseZ, h);
        }
    }

    private static void inverse(double[] d, double[] to, int h) {
        DoubleVector i = broadcast(SPECIES, 1).div(fromArray(SPECIES, d, h));
        i.blend(MeshRay.MAX_INVERSE, i.compare(GT, MeshRay.MAX_INVERSE)).blend(-MeshRay.MAX_INVERSE, i.compare(LT, -MeshRay.MAX_INVERSE))
                .intoArray(to, h);
    }

    /**
     * Returns the distance of ray {@code i} to a triangle of a leaf, as {@link MeshRay#distance}. The first coordinates of its
     * vertices are {@code v[a]}, {@code v[b]} and {@code v[c]}.
     */
    double distance(int i, float[] v, int a, int b, int c) {
        double x = dx[i];
        double y = dy[i];
        double z = dz[i];
        double absX = Math.abs(x);
        double absY = Math.abs(y);
        double absZ = Math.abs(z);
        double t;
        if (absX >= absY && absX >= absZ) {
            double inverseDepth = 1 / x;
            t = MeshRay.planeDistance(v, a, b, c, X, 2 * X, 0, oy[i], oz[i], ox[i], y * inverseDepth, z * inverseDepth, inverseDepth);
        } else if (absY >= absZ) {
            double inverseDepth = 1 / y;
            t = MeshRay.planeDistance(v, a, b, c, 2 * X, 0, X, oz[i], ox[i], oy[i], z * inverseDepth, x * inverseDepth, inverseDepth);
        } else {
            double inverseDepth = 1 / z;
            t = MeshRay.planeDistance(v, a, b, c, 0, X, 2 * X, ox[i], oy[i], oz[i], x * inverseDepth, y * inverseDepth, inverseDepth);
        }
        return t > 0 ? MeshRay.clampToBox(t, v, a, b, c, X, ox[i], oy[i], oz[i], padding[i], MeshRay.inverse(x), MeshRay.inverse(y),
                MeshRay.inverse(z)) : MeshRay.MISS;
    }
}

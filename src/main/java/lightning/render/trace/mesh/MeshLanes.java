package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.Lanes;
import lightning.render.trace.solid.Rays;

/**
 * The rays of a group in the space of a mesh, and how they meet the triangles of a leaf: {@link MeshRay} in lanes, operation by
 * operation. Reused; not shared between threads.
 */
final class MeshLanes {
    private static final VectorSpecies<Double> SPECIES = Lanes.SPECIES;
    private static final int W = MeshTree.WIDTH;
    static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));

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
    /** The first ray that was taken. */
    int first;

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
            first = Integer.numberOfTrailingZeros(mask);
        }
        for (int h = 0; h < Rays.WIDTH; h += Lanes.COUNT) {
            map(m, at, p, h, to + h);
            prepare(tree, to + h);
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

    /** The distance of ray {@code i} to the triangle of a leaf whose first coordinate is {@code v[at]}: {@link MeshRay#distance}. */
    double distance(int i, float[] v, int at) {
        double x = dx[i];
        double y = dy[i];
        double z = dz[i];
        double absX = Math.abs(x);
        double absY = Math.abs(y);
        double absZ = Math.abs(z);
        int b = at + MeshTree.VERTEX;
        int c = b + MeshTree.VERTEX;
        double t;
        if (absX >= absY && absX >= absZ) {
            double per = 1 / x;
            t = MeshRay.depth(v, at, b, c, W, 2 * W, 0, oy[i], oz[i], ox[i], y * per, z * per, per);
        } else if (absY >= absZ) {
            double per = 1 / y;
            t = MeshRay.depth(v, at, b, c, 2 * W, 0, W, oz[i], ox[i], oy[i], z * per, x * per, per);
        } else {
            double per = 1 / z;
            t = MeshRay.depth(v, at, b, c, 0, W, 2 * W, ox[i], oy[i], oz[i], x * per, y * per, per);
        }
        return t > 0 ? MeshRay.put(t, v, at, b, c, W, ox[i], oy[i], oz[i], pad[i], inverseX[i], inverseY[i], inverseZ[i])
                : MeshRay.MISS;
    }
}

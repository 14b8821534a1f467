package lightning.render.engine.lanes;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.PointLanes;
import lightning.render.trace.solid.SolidGeometryLanes;

/**
 * Lane version of {@link SurfaceHit#compute}, operation by operation. Processes the lanes of a packet by primitive, usually one
 * or two per packet.
 */
final class SurfaceHitLanes {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final VectorShape HALF_SHAPE = VectorShape.forBitSize(SPECIES.vectorBitSize() / 2);
    private static final VectorSpecies<Float> FLOATS = VectorSpecies.of(float.class, HALF_SHAPE);
    private static final VectorSpecies<Integer> INTS = VectorSpecies.of(int.class, HALF_SHAPE);
    private static final DoubleVector ONE = broadcast(SPECIES, 1);

    private final PrimitiveTable primitives;
    private final double[] x = new double[RayPacket.WIDTH];
    private final double[] y = new double[RayPacket.WIDTH];
    private final double[] z = new double[RayPacket.WIDTH];
    private final PointLanes points = new PointLanes();
    private final SurfaceHit surface = new SurfaceHit();

    SurfaceHitLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Returns one bit for each of the first {@code laneCount} lanes that hit a shape. */
    private static int hitMask(RayPacket p, int laneCount) {
        int mask = 0;
        for (int i = 0; i < laneCount; i++) {
            mask |= (p.primitive[i] >>> 31 ^ 1) << i;
        }
        return mask;
    }

    /** Computes the surfaces for those of the first {@code laneCount} lanes that hit a shape. */
    void compute(RayPacket p, int laneCount, SurfacePacket out) {
        computeHitPoints(p);
        int left = hitMask(p, laneCount);
        while (left != 0) {
            int s = p.primitive[Integer.numberOfTrailingZeros(left)];
            for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
                VectorMask<Integer> same = IntVector.fromArray(INTS, p.primitive, h).compare(EQ, s);
                int mask = (int) same.toLong();
                if (mask != 0 && (primitives.mesh(s) != null || primitives.bumpMapping(s) != null)) {
                    computeScalar(p, s, h, mask & left >>> h, out);
                    left &= ~(mask << h);
                } else if (mask != 0) {
                    left &= ~(mask << h);
                    transformToLocal(s, h);
                    SolidGeometryLanes.outwardNormals(primitives.kind(s), primitives.data, primitives.dataStart[s], points, h);
                    storeSurfaces(p, s, h, mask, out);
                }
            }
        }
    }

    /** Computes only the local points of the lanes that hit a primitive: {@link SurfacePacket#localX} to {@code localZ}. */
    void computeLocalPoints(RayPacket p, int laneCount, SurfacePacket out) {
        computeHitPoints(p);
        int left = hitMask(p, laneCount);
        while (left != 0) {
            int s = p.primitive[Integer.numberOfTrailingZeros(left)];
            for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
                VectorMask<Integer> same = IntVector.fromArray(INTS, p.primitive, h).compare(EQ, s);
                left &= ~((int) same.toLong() << h);
                if (same.anyTrue()) {
                    transformToLocal(s, h);
                    storeLocalPoints(h, same.cast(SPECIES), out);
                }
            }
        }
    }

    /** Computes the surfaces of a mesh, or of a primitive with bump mapping, lane by lane. */
    private void computeScalar(RayPacket p, int s, int h, int lanes, SurfacePacket out) {
        surface.lifts = !p.startsAtFacets;
        for (int left = lanes; left != 0; left &= left - 1) {
            int i = h + Integer.numberOfTrailingZeros(left);
            surface.compute(primitives, s, p.part[i], p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], p.t[i]);
            out.localX[i] = surface.localX;
            out.localY[i] = surface.localY;
            out.localZ[i] = surface.localZ;
            out.px[i] = surface.px;
            out.py[i] = surface.py;
            out.pz[i] = surface.pz;
            out.nx[i] = surface.nx;
            out.ny[i] = surface.ny;
            out.nz[i] = surface.nz;
        }
    }

    private void computeHitPoints(RayPacket p) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector t = fromArray(SPECIES, p.t, h);
            fromArray(SPECIES, p.ox, h).add(t.mul(fromArray(SPECIES, p.dx, h))).intoArray(x, h);
            fromArray(SPECIES, p.oy, h).add(t.mul(fromArray(SPECIES, p.dy, h))).intoArray(y, h);
            fromArray(SPECIES, p.oz, h).add(t.mul(fromArray(SPECIES, p.dz, h))).intoArray(z, h);
        }
    }

    private void transformToLocal(int s, int h) {
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        DoubleVector px = fromArray(SPECIES, x, h);
        DoubleVector py = fromArray(SPECIES, y, h);
        DoubleVector pz = fromArray(SPECIES, z, h);
        px.mul(m[i]).add(py.mul(m[i + 1])).add(pz.mul(m[i + 2])).add(m[i + 3]).intoArray(points.localX, h);
        px.mul(m[i + 4]).add(py.mul(m[i + 5])).add(pz.mul(m[i + 6])).add(m[i + 7]).intoArray(points.localY, h);
        px.mul(m[i + 8]).add(py.mul(m[i + 9])).add(pz.mul(m[i + 10])).add(m[i + 11]).intoArray(points.localZ, h);
    }

    private void storeSurfaces(RayPacket p, int s, int h, int lanes, SurfacePacket out) {
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        DoubleVector vx = fromArray(SPECIES, points.outwardX, h);
        DoubleVector vy = fromArray(SPECIES, points.outwardY, h);
        DoubleVector vz = fromArray(SPECIES, points.outwardZ, h);
        DoubleVector bx = vx.mul(m[i]).add(vy.mul(m[i + 4])).add(vz.mul(m[i + 8]));
        DoubleVector by = vx.mul(m[i + 1]).add(vy.mul(m[i + 5])).add(vz.mul(m[i + 9]));
        DoubleVector bz = vx.mul(m[i + 2]).add(vy.mul(m[i + 6])).add(vz.mul(m[i + 10]));
        DoubleVector square = bx.mul(bx).add(by.mul(by)).add(bz.mul(bz));
        VectorMask<Double> degenerate = square.compare(GT, 0).not();
        if (degenerate.anyTrue()) {
            bx = bx.blend(fromArray(SPECIES, p.dx, h).neg(), degenerate);
            by = by.blend(fromArray(SPECIES, p.dy, h).neg(), degenerate);
            bz = bz.blend(fromArray(SPECIES, p.dz, h).neg(), degenerate);
            square = bx.mul(bx).add(by.mul(by)).add(bz.mul(bz));
        }
        DoubleVector length = square.sqrt();
        VectorMask<Double> backFacing = bx.mul(fromArray(SPECIES, p.dx, h))
                .add(by.mul(fromArray(SPECIES, p.dy, h)))
                .add(bz.mul(fromArray(SPECIES, p.dz, h)))
                .compare(GT, 0);
        DoubleVector unit = ONE.div(length.blend(length.neg(), backFacing));
        bx = bx.mul(unit);
        by = by.mul(unit);
        bz = bz.mul(unit);
        DoubleVector px = fromArray(SPECIES, x, h);
        DoubleVector py = fromArray(SPECIES, y, h);
        DoubleVector pz = fromArray(SPECIES, z, h);
        DoubleVector origin =
                fromArray(SPECIES, p.ox, h).abs().add(fromArray(SPECIES, p.oy, h).abs()).add(fromArray(SPECIES, p.oz, h).abs());
        DoubleVector offset = px.mul(bx).abs().add(py.mul(by).abs()).add(pz.mul(bz).abs()).mul(SurfaceHit.OFFSET)
                .add(origin.mul(SurfaceHit.HIT_ERROR).add(primitives.hitError[s]));
        VectorMask<Double> mask = VectorMask.fromLong(SPECIES, lanes);
        VectorMask<Float> floats = VectorMask.fromLong(FLOATS, lanes);
        storeLocalPoints(h, mask, out);
        ((FloatVector) px.add(bx.mul(offset)).convertShape(D2F, FLOATS, 0)).intoArray(out.px, h, floats);
        ((FloatVector) py.add(by.mul(offset)).convertShape(D2F, FLOATS, 0)).intoArray(out.py, h, floats);
        ((FloatVector) pz.add(bz.mul(offset)).convertShape(D2F, FLOATS, 0)).intoArray(out.pz, h, floats);
        ((FloatVector) bx.convertShape(D2F, FLOATS, 0)).intoArray(out.nx, h, floats);
        ((FloatVector) by.convertShape(D2F, FLOATS, 0)).intoArray(out.ny, h, floats);
        ((FloatVector) bz.convertShape(D2F, FLOATS, 0)).intoArray(out.nz, h, floats);
    }

    private void storeLocalPoints(int h, VectorMask<Double> mask, SurfacePacket out) {
        fromArray(SPECIES, points.localX, h).intoArray(out.localX, h, mask);
        fromArray(SPECIES, points.localY, h).intoArray(out.localY, h, mask);
        fromArray(SPECIES, points.localZ, h).intoArray(out.localZ, h, mask);
    }
}

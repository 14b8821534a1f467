package lightning.render.trace.mesh;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;

/**
 * Tests of a single ray on lanes. Proof that they find what the loops find: docs/numerics.md, "Proof: boxes in floats". Interpreted, they are a
 * hundred times as slow as the loops.
 */
final class SingleRayLanes extends MeshTests {
    private static final VectorSpecies<Float> BOXES = FloatVector.SPECIES_256;
    private static final VectorSpecies<Float> CORNERS =
            VectorSpecies.of(float.class, VectorShape.forBitSize(DoubleLanes.SPECIES.vectorBitSize() / 2));
    /** Coordinates and inverse steps of rays that floats can follow lie between the reciprocal of this and this; coordinates may be smaller. */
    private static final double MAX = 0x1p60;
    /** More than the relative error of four operations in floats, with rounding units of 2⁻²⁴. */
    private static final float MARGIN = 0x1p-21f;

    private final float[] entry = new float[MeshTree.WIDTH];
    private float nearX;
    private float nearY;
    private float nearZ;
    private float farX;
    private float farY;
    private float farZ;
    private float inverseX;
    private float inverseY;
    private float inverseZ;

    @Override
    boolean setRay(MeshRay ray, double maxCoordinate) {
        if (!(maxCoordinate <= MAX && isWithin(ray.nearX, ray.inverseX) && isWithin(ray.nearY, ray.inverseY)
                && isWithin(ray.nearZ, ray.inverseZ))) {
            return false;
        }
        nearX = rounded(ray.nearX, ray.inverseX > 0);
        nearY = rounded(ray.nearY, ray.inverseY > 0);
        nearZ = rounded(ray.nearZ, ray.inverseZ > 0);
        farX = rounded(ray.farX, ray.inverseX < 0);
        farY = rounded(ray.farY, ray.inverseY < 0);
        farZ = rounded(ray.farZ, ray.inverseZ < 0);
        inverseX = (float) ray.inverseX;
        inverseY = (float) ray.inverseY;
        inverseZ = (float) ray.inverseZ;
        return true;
    }

    private static boolean isWithin(double coordinate, double inverse) {
        return Math.abs(coordinate) <= MAX && Math.abs(inverse) <= MAX && Math.abs(inverse) >= 1 / MAX;
    }

    /** Returns the float next to a number, above or below it. */
    private static float rounded(double number, boolean up) {
        float f = (float) number;
        return up ? f < number ? Math.nextUp(f) : f : f > number ? Math.nextDown(f) : f;
    }

    @Override
    int entered(float[] box, int node, double limit) {
        int first = MeshTree.NODE_FLOATS * node;
        int x = inverseX > 0 ? first : first + 8;
        int y = inverseY > 0 ? first + 16 : first + 24;
        int z = inverseZ > 0 ? first + 32 : first + 40;
        FloatVector in = FloatVector.fromArray(BOXES, box, x).sub(nearX).mul(inverseX)
                .max(FloatVector.fromArray(BOXES, box, y).sub(nearY).mul(inverseY))
                .max(FloatVector.fromArray(BOXES, box, z).sub(nearZ).mul(inverseZ))
                .max(0f).mul(1 - MARGIN).sub(Float.MIN_NORMAL);
        FloatVector out = FloatVector.fromArray(BOXES, box, 2 * first + 8 - x).sub(farX).mul(inverseX)
                .min(FloatVector.fromArray(BOXES, box, 2 * first + 40 - y).sub(farY).mul(inverseY))
                .min(FloatVector.fromArray(BOXES, box, 2 * first + 72 - z).sub(farZ).mul(inverseZ))
                .min(rounded(limit, true)).mul(1 + MARGIN);
        in.intoArray(entry, 0);
        return (int) in.compare(VectorOperators.LE, out).toLong();
    }

    @Override
    float[] entries() {
        return entry;
    }

    @Override
    int hitSlots(MeshRay ray, float[] v, int at) {
        int slots = 0;
        for (int s = 0; s < MeshTree.WIDTH; s += DoubleLanes.COUNT) {
            slots |= hitSlotsFrom(v, at + s + MeshTree.AXIS_FLOATS * ray.axisX, at + s + MeshTree.AXIS_FLOATS * ray.axisY,
                    at + s + MeshTree.AXIS_FLOATS * ray.axisZ, ray) << s;
        }
        return slots;
    }

    private static int hitSlotsFrom(float[] v, int x, int y, int z, MeshRay ray) {
        DoubleVector az = ((DoubleVector) FloatVector.fromArray(CORNERS, v, z).convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0))
                .sub(ray.originZ);
        DoubleVector ax = ((DoubleVector) FloatVector.fromArray(CORNERS, v, x).convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0))
                .sub(ray.originX).sub(az.mul(ray.shearX));
        DoubleVector ay = ((DoubleVector) FloatVector.fromArray(CORNERS, v, y).convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0))
                .sub(ray.originY).sub(az.mul(ray.shearY));
        DoubleVector bz = ((DoubleVector) FloatVector.fromArray(CORNERS, v, z + MeshTree.CORNER_FLOATS).convertShape(VectorOperators.F2D,
                DoubleLanes.SPECIES, 0)).sub(ray.originZ);
        DoubleVector bx = ((DoubleVector) FloatVector.fromArray(CORNERS, v, x + MeshTree.CORNER_FLOATS).convertShape(VectorOperators.F2D,
                DoubleLanes.SPECIES, 0)).sub(ray.originX).sub(bz.mul(ray.shearX));
        DoubleVector by = ((DoubleVector) FloatVector.fromArray(CORNERS, v, y + MeshTree.CORNER_FLOATS).convertShape(VectorOperators.F2D,
                DoubleLanes.SPECIES, 0)).sub(ray.originY).sub(bz.mul(ray.shearY));
        DoubleVector cz = ((DoubleVector) FloatVector.fromArray(CORNERS, v, z + 2 * MeshTree.CORNER_FLOATS)
                .convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0)).sub(ray.originZ);
        DoubleVector cx = ((DoubleVector) FloatVector.fromArray(CORNERS, v, x + 2 * MeshTree.CORNER_FLOATS)
                .convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0)).sub(ray.originX).sub(cz.mul(ray.shearX));
        DoubleVector cy = ((DoubleVector) FloatVector.fromArray(CORNERS, v, y + 2 * MeshTree.CORNER_FLOATS)
                .convertShape(VectorOperators.F2D, DoubleLanes.SPECIES, 0)).sub(ray.originY).sub(cz.mul(ray.shearY));
        DoubleVector weightA = cx.mul(by).sub(cy.mul(bx));
        DoubleVector weightB = ax.mul(cy).sub(ay.mul(cx));
        DoubleVector weightC = bx.mul(ay).sub(by.mul(ax));
        // Of an empty slot, a weight is NaN, and so are both of these.
        DoubleVector smallest = weightA.min(weightB).min(weightC);
        DoubleVector largest = weightA.max(weightB).max(weightC);
        return (int) smallest.compare(VectorOperators.LT, 0).and(largest.compare(VectorOperators.GT, 0)).not().toLong();
    }
}

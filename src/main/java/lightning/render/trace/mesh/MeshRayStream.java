package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.NE;

import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.Initializer;
import lightning.render.trace.solid.LaneRays;

/**
 * Finds all hits of many rays on a mesh in one walk over its BVH (Barringer and Akenine-Möller 2014, Dynamic Ray Stream Traversal).
 * Each node receives the list of the rays that enter it, tests them against its eight boxes while these are in registers, and passes
 * on a list to each child. The rays need not be coherent. The hits have the bits of {@link MeshRayQuery#collectHits}. Holds scratch
 * memory: use one per thread.
 * <pre>{@code
 * stream.begin(solid, map, 0);
 * stream.addPacket(rays, mask, limits);
 * stream.findAllHits();
 * }</pre>
 */
public final class MeshRayStream {
    /** Maximum number of rays. */
    public static final int MAX_RAYS = 2048;

    private static final int RECORD = 16;
    private static final VectorSpecies<Float> BOXES = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> CHILDREN = IntVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;

    private final MeshRayLanes rays = new MeshRayLanes(MAX_RAYS);
    private final MeshFloatLines lines = new MeshFloatLines(rays, MAX_RAYS);
    private final double[] limit = new double[MAX_RAYS];
    /**
     * Lines in the order in which tests read them, {@link #RECORD} floats each: inverse steps, intercepts from one side and from the
     * other, limit as bits; origin in order of the line's axes, across, across and along; steps across; width.
     */
    private final float[] record = new float[RECORD * MAX_RAYS];
    /** Rays whose lines run along x, y and z. */
    private final int[][] raysByAxis = new int[3][MAX_RAYS];
    private final int[] rayCount = new int[3];
    private final RayTrianglePairs pairs = new RayTrianglePairs(rays, limit);
    /** Rays of each packet that may reach the mesh, and those too short for lines. */
    private final int[] activeMasks = new int[MAX_RAYS / LaneRays.WIDTH];
    private final int[] shortRays = new int[MAX_RAYS / LaneRays.WIDTH];
    /** Children of the current node that each ray of its list enters, and zeros for whole vectors. */
    private final int[] entered = new int[MAX_RAYS + INTS.length()];
    /** Triangles of the current leaf that each ray of its list may hit. */
    private final int[] leafSlots = new int[MAX_RAYS];
    /** Lists of rays, one after the other. */
    private int[] list = new int[16 * MAX_RAYS];
    /** Nodes to visit, with the start and the end of their lists. */
    private int[] stack = new int[64];
    private int[] stackStart = new int[64];
    private int[] stackEnd = new int[64];
    private MeshTree tree;
    private double[] map;
    private int mapAt;
    private int packets;

    /**
     * Starts with no rays.
     *
     * @param m transform to the mesh's space at {@code m[at …]}
     */
    @Initializer
    public void begin(MeshSolid solid, double[] m, int at) {
        tree = solid.tree;
        map = m;
        mapAt = at;
        packets = 0;
        if (stack.length < tree.stackSize) {
            stack = new int[tree.stackSize];
            stackStart = new int[tree.stackSize];
            stackEnd = new int[tree.stackSize];
        }
    }

    /**
     * Adds a packet.
     *
     * @param mask rays of the packet to trace, one bit each; not 0
     * @param limits maximum distance of each ray, {@code double[WIDTH]}
     */
    public void addPacket(LaneRays p, int mask, double[] limits) {
        int to = packets * LaneRays.WIDTH;
        rays.addPacket(tree, map, mapAt, p, mask, to);
        System.arraycopy(limits, 0, limit, to, LaneRays.WIDTH);
        activeMasks[packets++] = mask;
    }

    /** Finds all triangles that rays hit below their limits. */
    public void findAllHits() {
        pairs.clear();
        lines.setRays(tree, activeMasks, shortRays, packets, limit, false);
        lines.prepareBoxTests();
        Arrays.fill(rayCount, 0);
        for (int k = 0; k < packets; k++) {
            for (int left = activeMasks[k]; left != 0; left &= left - 1) {
                writeRecord(k * LaneRays.WIDTH + Integer.numberOfTrailingZeros(left));
            }
            for (int left = shortRays[k]; left != 0; left &= left - 1) {
                testAllLeaves(k * LaneRays.WIDTH + Integer.numberOfTrailingZeros(left));
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            if (rayCount[axis] > 0) {
                System.arraycopy(raysByAxis[axis], 0, list, 0, rayCount[axis]);
                traverse(rayCount[axis], axis);
            }
        }
        pairs.test();
    }

    private void writeRecord(int i) {
        float dx = lines.stepX[i];
        float dy = lines.stepY[i];
        float dz = lines.stepZ[i];
        float[] r = record;
        int at = RECORD * i;
        r[at] = lines.inverseStepX[i];
        r[at + 1] = lines.inverseStepY[i];
        r[at + 2] = lines.inverseStepZ[i];
        r[at + 3] = lines.lowX[i];
        r[at + 4] = lines.lowY[i];
        r[at + 5] = lines.lowZ[i];
        r[at + 6] = lines.highX[i];
        r[at + 7] = lines.highY[i];
        r[at + 8] = lines.highZ[i];
        r[at + 9] = Float.intBitsToFloat(lines.limitBits[i]);
        int axis = Math.abs(dz) == 1 ? 2 : Math.abs(dx) == 1 ? 0 : 1;
        float along = axis == 2 ? dz : axis == 0 ? dx : dy;
        r[at + 10] = axis == 2 ? lines.startX[i] : axis == 0 ? lines.startY[i] : lines.startZ[i];
        r[at + 11] = axis == 2 ? lines.startY[i] : axis == 0 ? lines.startZ[i] : lines.startX[i];
        r[at + 12] = axis == 2 ? lines.startZ[i] : axis == 0 ? lines.startX[i] : lines.startY[i];
        r[at + 13] = (axis == 2 ? dx : axis == 0 ? dy : dz) * along;
        r[at + 14] = (axis == 2 ? dy : axis == 0 ? dz : dx) * along;
        r[at + 15] = lines.lineWidth[i];
        raysByAxis[axis][rayCount[axis]++] = i;
    }

    /** Returns the number of hits of all rays, in any order. */
    public int hitCount() {
        return pairs.hitCount;
    }

    /** Returns the ray of a hit: ray i of packet k has the number {@code k · WIDTH + i}. */
    public int hitRay(int n) {
        return pairs.hitRay[n];
    }

    public int hitTriangle(int n) {
        return pairs.hitTriangle[n];
    }

    public double hitDistance(int n) {
        return pairs.hitDistance[n];
    }

    private void testAllLeaves(int ray) {
        for (int leaf = 0; leaf < tree.triangle.length / MeshTree.WIDTH; leaf++) {
            pairs.add(tree, ray, leaf, -1 >>> -MeshTree.WIDTH);
        }
    }

    /** Traverses the BVH with the first rays of {@link #list}, whose lines run along an axis. */
    private void traverse(int count, int axis) {
        stack[0] = 0;
        stackStart[0] = 0;
        stackEnd[0] = count;
        int top = 1;
        while (top > 0) {
            int node = stack[--top];
            int start = stackStart[top];
            int end = stackEnd[top];
            int free = end;
            for (int left = enter(node, start, end); left != 0; left &= left - 1) {
                int c = Integer.numberOfTrailingZeros(left);
                int to = select(c, start, end, free);
                int child = tree.child[MeshTree.WIDTH * node + c];
                if (child < 0) {
                    testLeaf(~child, MeshTree.NODE_FLOATS * node + c, free, to, axis);
                } else {
                    stack[top] = child;
                    stackStart[top] = free;
                    stackEnd[top++] = to;
                    free = to;
                }
            }
        }
    }

    /** Tests a list of rays against the boxes of a node; writes {@link #entered}, and returns the children that any ray enters. */
    private int enter(int node, int start, int end) {
        float[] b = tree.box;
        int at = MeshTree.NODE_FLOATS * node;
        FloatVector minX = FloatVector.fromArray(BOXES, b, at);
        FloatVector maxX = FloatVector.fromArray(BOXES, b, at + 8);
        FloatVector minY = FloatVector.fromArray(BOXES, b, at + 16);
        FloatVector maxY = FloatVector.fromArray(BOXES, b, at + 24);
        FloatVector minZ = FloatVector.fromArray(BOXES, b, at + 32);
        FloatVector maxZ = FloatVector.fromArray(BOXES, b, at + 40);
        int any = 0;
        for (int k = start; k < end; k++) {
            int i = RECORD * list[k];
            FloatVector inverse = FloatVector.broadcast(BOXES, record[i]);
            IntVector p = minX.fma(inverse, FloatVector.broadcast(BOXES, record[i + 3])).reinterpretAsInts();
            IntVector q = maxX.fma(inverse, FloatVector.broadcast(BOXES, record[i + 6])).reinterpretAsInts();
            IntVector enters = p.min(q).max(0);
            IntVector leaves = p.max(q).min(FloatVector.broadcast(BOXES, record[i + 9]).reinterpretAsInts());
            inverse = FloatVector.broadcast(BOXES, record[i + 1]);
            p = minY.fma(inverse, FloatVector.broadcast(BOXES, record[i + 4])).reinterpretAsInts();
            q = maxY.fma(inverse, FloatVector.broadcast(BOXES, record[i + 7])).reinterpretAsInts();
            enters = enters.max(p.min(q));
            leaves = leaves.min(p.max(q));
            inverse = FloatVector.broadcast(BOXES, record[i + 2]);
            p = minZ.fma(inverse, FloatVector.broadcast(BOXES, record[i + 5])).reinterpretAsInts();
            q = maxZ.fma(inverse, FloatVector.broadcast(BOXES, record[i + 8])).reinterpretAsInts();
            enters = enters.max(p.min(q));
            leaves = leaves.min(p.max(q));
            int children = (int) enters.compare(LE, leaves).toLong();
            entered[k - start] = children;
            any |= children;
        }
        Arrays.fill(entered, end - start, end - start + INTS.length(), 0);
        // Unused boxes are inverted, which the test does not see.
        return any & (int) IntVector.fromArray(CHILDREN, tree.child, MeshTree.WIDTH * node).compare(NE, MeshTree.NONE).toLong();
    }

    /** Writes the rays of the list that enter child {@code c} to a new list, which starts at {@code to}; returns its end. */
    private int select(int c, int start, int end, int to) {
        if (list.length < to + end - start + INTS.length()) {
            list = Arrays.copyOf(list, 2 * list.length);
        }
        int free = to;
        for (int k = 0; k < end - start; k += INTS.length()) {
            VectorMask<Integer> enters = IntVector.fromArray(INTS, entered, k).and(1 << c).compare(NE, 0);
            IntVector.fromArray(INTS, list, start + k).compress(enters).intoArray(list, free);
            free += enters.trueCount();
        }
        return free;
    }

    /** Collects the triangles of a leaf that a list of rays may hit, by the test of {@link LeafTriangleCulling#candidateSlots}. */
    private void testLeaf(int leaf, int box, int start, int end, int axis) {
        float extent = LeafRayFilter.extent(tree.box, box);
        float[] v = tree.vertex;
        int at = MeshTree.LEAF_FLOATS * leaf;
        int x = at + MeshTree.AXIS_FLOATS * ((axis + 1) % 3);
        int y = at + MeshTree.AXIS_FLOATS * ((axis + 2) % 3);
        int z = at + MeshTree.AXIS_FLOATS * axis;
        for (int k = start; k < end; k++) {
            int i = RECORD * list[k];
            float w = record[i + 15];
            leafSlots[k - start] = w < MeshFloatLines.MAX_WIDTH
                    ? LeafTriangleCulling.candidateSlots(v, x, y, z, record[i + 10], record[i + 11], record[i + 12], record[i + 13],
                            record[i + 14], w, extent)
                    : -1 >>> -MeshTree.WIDTH;
        }
        for (int k = start; k < end; k++) {
            if (leafSlots[k - start] != 0) {
                pairs.add(tree, list[k], leaf, leafSlots[k - start]);
            }
        }
    }
}

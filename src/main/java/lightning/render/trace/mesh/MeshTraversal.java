package lightning.render.trace.mesh;

import java.util.Arrays;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Single-ray traversal of a mesh's BVH. Holds scratch memory: use one per thread. */
final class MeshTraversal {
    private final @Nullable Supplier<MeshTests> fixedTests;
    /** Tests of the current ray; null for loops. */
    private @Nullable MeshTests tests;
    /** The same, created on first use. */
    private @Nullable MeshTests ownTests;
    private int[] stack = new int[64];
    /** Entry distances of the nodes on the stack, as bits of non-negative doubles. */
    private long[] entryBits = new long[64];
    /** Child references, in the lower half, of the leaves found by {@link #findLeaves}. */
    private int[] leafReference = new int[64];
    private int leafCount;
    /** Triangle found by {@link #nearest}. */
    int triangle;
    /** Hits found by {@link #collectHits}. */
    int hitCount;
    int[] hitTriangle = new int[8];
    double[] hitDistance = new double[8];

    /** @param fixedTests tests to use; null for those of the process at each time */
    MeshTraversal(@Nullable Supplier<MeshTests> fixedTests) {
        this.fixedTests = fixedTests;
    }

    /**
     * Returns the distance of the triangle hit first, the one with the lowest index among equal distances; {@code +∞} if there
     * is none up to {@code limit}.
     *
     * @param alphaTest test for holes
     */
    double nearest(MeshTree tree, MeshRay ray, @Nullable AlphaTest alphaTest, double limit) {
        begin(tree, ray);
        double nearestDistance = limit;
        triangle = -1;
        int top = enter(tree, ray, 0, 0, nearestDistance);
        while (top > 0) {
            top--;
            if (entryBits[top] > Double.doubleToRawLongBits(nearestDistance)) {
                continue;
            }
            int next = stack[top];
            if (next >= 0) {
                top = enter(tree, ray, next, top, nearestDistance);
                continue;
            }
            int leaf = ~next;
            for (int slots = hitSlots(tree, ray, leaf); slots != 0; slots &= slots - 1) {
                int s = Integer.numberOfTrailingZeros(slots);
                int id = MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + s]);
                double t = distance(tree, ray, leaf, s);
                if (t < MeshRay.MISS && (t < nearestDistance || t == nearestDistance && (triangle < 0 || id < triangle))
                        && (alphaTest == null || !alphaTest.isHole(id, t))) {
                    nearestDistance = t;
                    triangle = id;
                }
            }
        }
        return triangle < 0 ? MeshRay.MISS : nearestDistance;
    }

    /** Returns whether the ray hits a triangle at a distance below {@code limit}. */
    boolean isBlocked(MeshTree tree, MeshRay ray, @Nullable AlphaTest alphaTest, double limit) {
        begin(tree, ray);
        int top = enter(tree, ray, 0, 0, limit);
        while (top > 0) {
            int next = stack[--top];
            if (next >= 0) {
                top = enter(tree, ray, next, top, limit);
                continue;
            }
            int leaf = ~next;
            for (int slots = hitSlots(tree, ray, leaf); slots != 0; slots &= slots - 1) {
                int s = Integer.numberOfTrailingZeros(slots);
                double t = distance(tree, ray, leaf, s);
                if (t < limit && (alphaTest == null || !alphaTest.isHole(MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + s]), t))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Adds all hits of a ray at distances below {@code limit} to {@link #hitTriangle} and {@link #hitDistance}, in any order. */
    void collectHits(MeshTree tree, MeshRay ray, double limit) {
        begin(tree, ray);
        hitCount = 0;
        int top = enter(tree, ray, 0, 0, limit);
        while (top > 0) {
            int next = stack[--top];
            if (next >= 0) {
                top = enter(tree, ray, next, top, limit);
            } else {
                collectLeaf(tree, ray, ~next, limit);
            }
        }
    }

    /** Finds the leaves that a light buffer's place may show; returns their number. */
    int findLeaves(LightBuffer buffer, int place) {
        int cell = place >> LightBuffer.PART_BITS;
        int part = 1 << LightBuffer.REFERENCE_BITS + (place & 15);
        int[] entries = buffer.entries;
        int end = buffer.start[cell + 1];
        int from = buffer.start[cell];
        if (leafReference.length < end - from) {
            leafReference = new int[2 * (end - from)];
        }
        int[] found = leafReference;
        int count = 0;
        for (int i = from; i < end; i++) {
            int entry = entries[i];
            if ((entry & part) != 0) {
                found[count++] = entry;
            }
        }
        leafCount = count;
        return count;
    }

    /** Adds all hits, at distances below 1, of a ray to a light buffer's point on the leaves of {@link #findLeaves}. */
    void collectHits(MeshTree tree, MeshRay ray) {
        hitCount = 0;
        chooseTests(tree, ray);
        keepEntered(tree.box, ray);
        for (int i = 0; i < leafCount; i++) {
            collectLeaf(tree, ray, ~tree.child[leafReference[i]], 1);
        }
    }

    /** Keeps only leaves whose boxes the padded ray may enter at a distance up to 1, by the test of {@link #push}. */
    private void keepEntered(float[] box, MeshRay ray) {
        int[] references = leafReference;
        double nearX = ray.nearX;
        double nearY = ray.nearY;
        double nearZ = ray.nearZ;
        double farX = ray.farX;
        double farY = ray.farY;
        double farZ = ray.farZ;
        double inverseX = ray.inverseX;
        double inverseY = ray.inverseY;
        double inverseZ = ray.inverseZ;
        int nearSideX = inverseX > 0 ? 0 : 8;
        int nearSideY = inverseY > 0 ? 16 : 24;
        int nearSideZ = inverseZ > 0 ? 32 : 40;
        long limitBits = Double.doubleToRawLongBits(1);
        int end = leafCount;
        int count = 0;
        for (int i = 0; i < end; i++) {
            int reference = references[i] & -1 >>> LightBuffer.REFERENCE_BITS;
            int at = MeshTree.NODE_FLOATS * (reference >> 3) + (reference & 7);
            long in = Math.max(0, Double.doubleToRawLongBits((box[at + nearSideX] - nearX) * inverseX));
            in = Math.max(in, Double.doubleToRawLongBits((box[at + nearSideY] - nearY) * inverseY));
            in = Math.max(in, Double.doubleToRawLongBits((box[at + nearSideZ] - nearZ) * inverseZ));
            // Adding 0 makes −0 positive.
            long out = Math.min(limitBits, Double.doubleToRawLongBits((box[at + 8 - nearSideX] - farX) * inverseX + 0.0));
            out = Math.min(out, Double.doubleToRawLongBits((box[at + 40 - nearSideY] - farY) * inverseY + 0.0));
            out = Math.min(out, Double.doubleToRawLongBits((box[at + 72 - nearSideZ] - farZ) * inverseZ + 0.0));
            references[count] = reference;
            count += in <= out ? 1 : 0;
        }
        leafCount = count;
    }

    private void collectLeaf(MeshTree tree, MeshRay ray, int leaf, double limit) {
        for (int slots = hitSlots(tree, ray, leaf); slots != 0; slots &= slots - 1) {
            int s = Integer.numberOfTrailingZeros(slots);
            double t = distance(tree, ray, leaf, s);
            if (t < limit) {
                addHit(MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + s]), t);
            }
        }
    }

    /** Removes all hits. */
    void clearHits() {
        hitCount = 0;
    }

    void addHit(int id, double t) {
        if (hitCount == hitTriangle.length) {
            hitTriangle = Arrays.copyOf(hitTriangle, 2 * hitCount);
            hitDistance = Arrays.copyOf(hitDistance, 2 * hitCount);
        }
        hitTriangle[hitCount] = id;
        hitDistance[hitCount++] = t;
    }

    private static double distance(MeshTree tree, MeshRay ray, int leaf, int slot) {
        int reference = tree.triangle[MeshTree.WIDTH * leaf + slot];
        if (reference < 0) {
            return MeshRay.MISS;
        }
        int last = MeshTree.lastCorner(reference);
        int corner = MeshTree.LEAF_FLOATS * leaf + slot;
        // The order of the other two corners does not change the distance.
        return ray.distance(tree.vertex, corner + (last == 0 ? MeshTree.CORNER_FLOATS : 0),
                corner + (last == 2 ? MeshTree.CORNER_FLOATS : 2 * MeshTree.CORNER_FLOATS), corner + MeshTree.CORNER_FLOATS * last,
                MeshTree.AXIS_FLOATS);
    }

    private void begin(MeshTree tree, MeshRay ray) {
        if (stack.length < tree.stackSize) {
            stack = new int[tree.stackSize];
            entryBits = new long[tree.stackSize];
        }
        chooseTests(tree, ray);
    }

    private void chooseTests(MeshTree tree, MeshRay ray) {
        Supplier<MeshTests> wanted = fixedTests == null ? MeshTests.current() : fixedTests;
        if (wanted == MeshTests.LOOPS) {
            tests = null;
            return;
        }
        MeshTests own = ownTests == null ? ownTests = wanted.get() : ownTests;
        tests = own.setRay(ray, tree.maxCoordinate) ? own : null;
    }

    private int hitSlots(MeshTree tree, MeshRay ray, int leaf) {
        int at = MeshTree.LEAF_FLOATS * leaf;
        return tests == null ? ray.hitSlots(tree.vertex, at) : tests.hitSlots(ray, tree.vertex, at);
    }

    private int enter(MeshTree tree, MeshRay ray, int node, int top, double limit) {
        return tests == null ? push(tree, ray, node, top, limit)
                : push(tree, node, top, tests.entered(tree.box, node, limit), tests.entries());
    }

    /** Pushes children of a node onto the stack, the nearest last. */
    private int push(MeshTree tree, int node, int top, int children, float[] entry) {
        int end = top;
        for (int left = children; left != 0; left &= left - 1) {
            int c = Integer.numberOfTrailingZeros(left);
            long in = Double.doubleToRawLongBits(entry[c]);
            int at = end++;
            for (; at > top && entryBits[at - 1] < in; at--) {
                entryBits[at] = entryBits[at - 1];
                stack[at] = stack[at - 1];
            }
            entryBits[at] = in;
            stack[at] = tree.child[MeshTree.WIDTH * node + c];
        }
        return end;
    }

    /**
     * Pushes the children of a node whose boxes the padded ray may enter at a distance up to {@code limit} onto the stack, the
     * nearest last.
     *
     * <p>Contains the box test, because the first compiler does not inline methods of this size. Compares distances as bits: it
     * compiles a minimum of integers without a branch, and neither order nor sign differs where it matters.
     */
    private int push(MeshTree tree, MeshRay ray, int node, int top, double limit) {
        float[] box = tree.box;
        int[] child = tree.child;
        double nearX = ray.nearX;
        double nearY = ray.nearY;
        double nearZ = ray.nearZ;
        double farX = ray.farX;
        double farY = ray.farY;
        double farZ = ray.farZ;
        double inverseX = ray.inverseX;
        double inverseY = ray.inverseY;
        double inverseZ = ray.inverseZ;
        int first = MeshTree.NODE_FLOATS * node;
        // Distances to the sides that the ray reaches first, and to the others.
        int x = inverseX > 0 ? first : first + 8;
        int y = inverseY > 0 ? first + 16 : first + 24;
        int z = inverseZ > 0 ? first + 32 : first + 40;
        int exitX = 2 * first + 8 - x;
        int exitY = 2 * first + 40 - y;
        int exitZ = 2 * first + 72 - z;
        long limitBits = Double.doubleToRawLongBits(limit);
        int end = top;
        for (int c = 0; c < MeshTree.WIDTH; c++) {
            long in = Math.max(0, Double.doubleToRawLongBits((box[x + c] - nearX) * inverseX));
            in = Math.max(in, Double.doubleToRawLongBits((box[y + c] - nearY) * inverseY));
            in = Math.max(in, Double.doubleToRawLongBits((box[z + c] - nearZ) * inverseZ));
            // Adding 0 makes −0 positive.
            long out = Math.min(limitBits, Double.doubleToRawLongBits((box[exitX + c] - farX) * inverseX + 0.0));
            out = Math.min(out, Double.doubleToRawLongBits((box[exitY + c] - farY) * inverseY + 0.0));
            out = Math.min(out, Double.doubleToRawLongBits((box[exitZ + c] - farZ) * inverseZ + 0.0));
            if (in <= out) {
                int at = end++;
                for (; at > top && entryBits[at - 1] < in; at--) {
                    entryBits[at] = entryBits[at - 1];
                    stack[at] = stack[at - 1];
                }
                entryBits[at] = in;
                stack[at] = child[MeshTree.WIDTH * node + c];
            }
        }
        return end;
    }
}

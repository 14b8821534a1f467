package lightning.render.trace.mesh;

/** Single-ray traversal of a mesh's BVH. Holds scratch memory: use one per thread. */
final class MeshTraversal {
    private int[] stack = new int[64];
    private double[] entryDistance = new double[64];
    /** Triangle found by {@link #nearest}. */
    int triangle;

    /**
     * Returns the distance of the triangle hit first, the one with the lowest index among equal distances; {@code +∞} if there
     * is none up to {@code limit}.
     *
     * @param alphaTest test for holes; null for none
     */
    double nearest(MeshTree tree, MeshRay ray, AlphaTest alphaTest, double limit) {
        ensureCapacity(tree);
        double nearestDistance = limit;
        triangle = -1;
        int top = push(tree, ray, 0, 0, nearestDistance);
        while (top > 0) {
            top--;
            if (entryDistance[top] > nearestDistance) {
                continue;
            }
            int next = stack[top];
            if (next >= 0) {
                top = push(tree, ray, next, top, nearestDistance);
                continue;
            }
            int leaf = ~next;
            for (int s = 0; s < MeshTree.WIDTH && tree.triangle[MeshTree.WIDTH * leaf + s] >= 0; s++) {
                int id = tree.triangle[MeshTree.WIDTH * leaf + s];
                double t = distance(tree, ray, leaf, s);
                if (t < MeshRay.MISS && (t < nearestDistance || t == nearestDistance && (triangle < 0 || id < triangle))
                        && (alphaTest == null || !alphaTest.passes(id, t))) {
                    nearestDistance = t;
                    triangle = id;
                }
            }
        }
        return triangle < 0 ? MeshRay.MISS : nearestDistance;
    }

    /** Returns true if the ray hits a triangle at a distance below {@code limit}. */
    boolean isBlocked(MeshTree tree, MeshRay ray, AlphaTest alphaTest, double limit) {
        ensureCapacity(tree);
        int top = push(tree, ray, 0, 0, limit);
        while (top > 0) {
            int next = stack[--top];
            if (next >= 0) {
                top = push(tree, ray, next, top, limit);
                continue;
            }
            int leaf = ~next;
            for (int s = 0; s < MeshTree.WIDTH && tree.triangle[MeshTree.WIDTH * leaf + s] >= 0; s++) {
                double t = distance(tree, ray, leaf, s);
                if (t < limit && (alphaTest == null || !alphaTest.passes(tree.triangle[MeshTree.WIDTH * leaf + s], t))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static double distance(MeshTree tree, MeshRay ray, int leaf, int slot) {
        int at = MeshTree.LEAF_FLOATS * leaf + slot;
        return ray.distance(tree.vertex, at, at + MeshTree.VERTEX_FLOATS, at + 2 * MeshTree.VERTEX_FLOATS, MeshTree.WIDTH);
    }

    private void ensureCapacity(MeshTree tree) {
        if (stack.length < tree.stackSize) {
            stack = new int[tree.stackSize];
            entryDistance = new double[tree.stackSize];
        }
    }

    /** Pushes the children of a node whose boxes the ray enters onto the stack, the nearest last. */
    private int push(MeshTree tree, MeshRay ray, int node, int top, double limit) {
        int end = top;
        for (int c = 0; c < MeshTree.WIDTH && tree.child[MeshTree.WIDTH * node + c] != MeshTree.NONE; c++) {
            if (ray.entersBox(tree.box, MeshTree.NODE_FLOATS * node + c, limit)) {
                double in = ray.entryDistance;
                int at = end++;
                for (; at > top && entryDistance[at - 1] < in; at--) {
                    entryDistance[at] = entryDistance[at - 1];
                    stack[at] = stack[at - 1];
                }
                entryDistance[at] = in;
                stack[at] = tree.child[MeshTree.WIDTH * node + c];
            }
        }
        return end;
    }
}

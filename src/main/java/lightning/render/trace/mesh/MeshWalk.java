package lightning.render.trace.mesh;

/** Searches which triangle of a mesh a ray meets, by the tree of boxes. Scratch memory: one for each thread. */
final class MeshWalk {
    private int[] stack = new int[64];
    private double[] since = new double[64];
    /** The triangle that {@link #nearest} found. */
    int triangle;

    /**
     * The distance of the triangle that is met first, the one with the lowest index among equals; {@code +∞} where none is met at a
     * distance up to {@code limit}.
     *
     * @param sieve where triangles are passed; null for nowhere
     */
    double nearest(MeshTree tree, MeshRay ray, Sieve sieve, double limit) {
        room(tree);
        double best = limit;
        triangle = -1;
        int top = push(tree, ray, 0, 0, best);
        while (top > 0) {
            top--;
            if (since[top] > best) {
                continue;
            }
            int next = stack[top];
            if (next >= 0) {
                top = push(tree, ray, next, top, best);
                continue;
            }
            int leaf = ~next;
            for (int s = 0; s < MeshTree.WIDTH && tree.triangle[MeshTree.WIDTH * leaf + s] >= 0; s++) {
                int id = tree.triangle[MeshTree.WIDTH * leaf + s];
                double t = distance(tree, ray, leaf, s);
                if (t < MeshRay.MISS && (t < best || t == best && (triangle < 0 || id < triangle))
                        && (sieve == null || !sieve.passes(id, t))) {
                    best = t;
                    triangle = id;
                }
            }
        }
        return triangle < 0 ? MeshRay.MISS : best;
    }

    /** Whether a triangle is met at a distance below {@code limit}. */
    boolean blocked(MeshTree tree, MeshRay ray, Sieve sieve, double limit) {
        room(tree);
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
                if (t < limit && (sieve == null || !sieve.passes(tree.triangle[MeshTree.WIDTH * leaf + s], t))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static double distance(MeshTree tree, MeshRay ray, int leaf, int slot) {
        int at = MeshTree.LEAF * leaf + slot;
        return ray.distance(tree.vertex, at, at + MeshTree.VERTEX, at + 2 * MeshTree.VERTEX, MeshTree.WIDTH);
    }

    private void room(MeshTree tree) {
        if (stack.length < tree.stack) {
            stack = new int[tree.stack];
            since = new double[tree.stack];
        }
    }

    /** Puts the children of a node whose boxes the ray enters on the stack, the nearest last. */
    private int push(MeshTree tree, MeshRay ray, int node, int top, double limit) {
        int end = top;
        for (int c = 0; c < MeshTree.WIDTH && tree.child[MeshTree.WIDTH * node + c] != MeshTree.NONE; c++) {
            if (ray.enters(tree.box, MeshTree.NODE * node + c, limit)) {
                double in = ray.in;
                int at = end++;
                for (; at > top && since[at - 1] < in; at--) {
                    since[at] = since[at - 1];
                    stack[at] = stack[at - 1];
                }
                since[at] = in;
                stack[at] = tree.child[MeshTree.WIDTH * node + c];
            }
        }
        return end;
    }
}

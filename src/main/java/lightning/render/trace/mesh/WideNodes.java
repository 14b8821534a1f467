package lightning.render.trace.mesh;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Collapse of a binary BVH to nodes of up to eight children: a node adopts its children's children, the largest first, until it
 * is full (Wald, Benthin and Boulos 2008, Getting Rid of Packets). The layout is that of {@link MeshTree}.
 */
final class WideNodes {
    private float[] box = new float[MeshTree.NODE_FLOATS];
    private int[] child = new int[MeshTree.WIDTH];
    private int nodes;
    private TriangleSet[] leaves = new TriangleSet[1];
    private int leafCount;
    private int depth;

    /** @param root set of all triangles; null if there are none */
    WideNodes(@Nullable TriangleSet root) {
        addNode();
        if (root != null) {
            collapse(root, 0, 1);
        }
    }

    /** Returns the boxes of all children. */
    float[] boxes() {
        return Arrays.copyOf(box, MeshTree.NODE_FLOATS * nodes);
    }

    int[] children() {
        return Arrays.copyOf(child, MeshTree.WIDTH * nodes);
    }

    int leafCount() {
        return leafCount;
    }

    /** Returns the triangles of a leaf. */
    TriangleSet leaf(int leaf) {
        return leaves[leaf];
    }

    /** Returns the depth of the tree. */
    int depth() {
        return depth;
    }

    /** Writes the subtree of a set to node {@code node}, which must be empty. */
    private void collapse(TriangleSet set, int node, int level) {
        depth = Math.max(depth, level);
        TriangleSet[] children = new TriangleSet[MeshTree.WIDTH];
        children[0] = set;
        int n = 1;
        while (n < MeshTree.WIDTH) {
            int largest = largest(children, n);
            if (largest < 0) {
                break;
            }
            TriangleSet split = children[largest];
            children[largest] = split.first;
            children[n++] = split.second;
        }
        for (int c = 0; c < n; c++) {
            for (int a = 0; a < 3; a++) {
                box[MeshTree.NODE_FLOATS * node + 16 * a + c] = children[c].box[a];
                box[MeshTree.NODE_FLOATS * node + 16 * a + 8 + c] = -children[c].box[3 + a];
            }
            int next = children[c].isLeaf() ? ~addLeaf(children[c]) : addNode();
            child[MeshTree.WIDTH * node + c] = next;
            if (next >= 0) {
                collapse(children[c], next, level + 1);
            }
        }
    }

    private static int largest(TriangleSet[] children, int n) {
        int largest = -1;
        double maxArea = -1;
        for (int c = 0; c < n; c++) {
            double area = children[c].isLeaf() ? -1 : TriangleBoxes.area(children[c].box);
            if (area > maxArea) {
                maxArea = area;
                largest = c;
            }
        }
        return largest;
    }

    private int addLeaf(TriangleSet set) {
        if (leafCount == leaves.length) {
            leaves = Arrays.copyOf(leaves, 2 * leafCount);
        }
        leaves[leafCount] = set;
        return leafCount++;
    }

    private int addNode() {
        int node = nodes++;
        if (MeshTree.WIDTH * nodes > child.length) {
            child = Arrays.copyOf(child, 2 * child.length);
            box = Arrays.copyOf(box, 2 * box.length);
        }
        for (int c = 0; c < MeshTree.WIDTH; c++) {
            child[MeshTree.WIDTH * node + c] = MeshTree.NONE;
            for (int a = 0; a < 3; a++) {
                box[MeshTree.NODE_FLOATS * node + 16 * a + c] = MeshTree.EMPTY_BOUND;
                box[MeshTree.NODE_FLOATS * node + 16 * a + 8 + c] = -MeshTree.EMPTY_BOUND;
            }
        }
        return node;
    }
}

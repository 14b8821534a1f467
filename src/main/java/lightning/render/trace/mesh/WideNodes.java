package lightning.render.trace.mesh;

import java.util.Arrays;

/**
 * Nodes of up to eight children made of sets that are split in two: a node takes its children's children in, the largest first, until it is
 * full (Wald, Benthin and Boulos 2008, Getting Rid of Packets). As {@link MeshTree} has them.
 */
final class WideNodes {
    private float[] box = new float[MeshTree.NODE_FLOATS];
    private int[] child = new int[MeshTree.WIDTH];
    private int nodes;
    private TriangleSet[] leaves = new TriangleSet[1];
    private int leafCount;
    private int depth;

    /** @param root the set of all triangles; null where there is none */
    WideNodes(TriangleSet root) {
        addNode();
        if (root != null) {
            collapse(root, 0, 1);
        }
    }

    /** The boxes of all children. */
    float[] boxes() {
        return Arrays.copyOf(box, MeshTree.NODE_FLOATS * nodes);
    }

    int[] children() {
        return Arrays.copyOf(child, MeshTree.WIDTH * nodes);
    }

    int leafCount() {
        return leafCount;
    }

    /** The triangles of a leaf. */
    TriangleSet leaf(int leaf) {
        return leaves[leaf];
    }

    /** How many nodes lie above each other. */
    int depth() {
        return depth;
    }

    /** Writes what is under a set to node {@code node}, which has nothing yet. */
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

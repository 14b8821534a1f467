package lightning.trace.mesh;

import java.util.Arrays;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.stream.IntStream;
import lightning.mesh.Mesh;

/**
 * Builds the tree of a mesh from the top: a set of triangles is split in two where the surface area heuristic, on a few bins along
 * each axis, expects the fewest blocks of eight triangles to be tested (Wald 2007, On fast Construction of SAH-based Bounding Volume
 * Hierarchies). Then nodes take their children's children in, the largest first, until they have eight (Wald, Benthin and Boulos
 * 2008, Getting Rid of Packets).
 */
final class MeshTreeBuilder {
    private static final int BINS = 16;
    /** Just less than the bins, so that what lies at the end is in the last. */
    private static final float SPREAD = BINS * 0.9999f;
    /** Below this depth sets are halved by count, which bounds the depth for any input. */
    private static final int MAX_SAH_DEPTH = 50;
    /** Sets of more triangles are split by two threads. */
    private static final int SHARED = 8192;
    /** Triangles or leaves that one thread takes at a time. */
    private static final int CHUNK = 16384;

    private final Mesh mesh;
    private final int count;
    /** Boxes of triangles: least x y z and the negative greatest, so that the lesser is the larger box in all six. */
    private final float[] boxes;
    /** Which triangles these are. */
    private final int[] ids;

    private float[] wideBox = new float[MeshTree.NODE];
    private int[] wideChild = new int[MeshTree.WIDTH];
    private int nodes;
    private Set[] leaves = new Set[1];
    private int leafCount;
    private int depth;

    /** Some triangles, those of {@code ids[from … to − 1]}, and their box. */
    private static final class Set {
        final int from;
        final int to;
        final float[] box;
        Set first;
        Set second;

        Set(int from, int to, float[] box) {
            this.from = from;
            this.to = to;
            this.box = box;
        }

        boolean isLeaf() {
            return first == null;
        }
    }

    /** Memory for one thread's splitting. */
    private static final class Scratch {
        final float[] box = new float[3 * BINS * 6];
        final int[] count = new int[3 * BINS];
        final double[] above = new double[BINS];
        final float[] sum = new float[6];
        final float[] low = new float[3];
        final float[] scale = new float[3];
        int axis;
        int bin;
    }

    MeshTreeBuilder(Mesh mesh) {
        this.mesh = mesh;
        count = mesh.triangleCount();
        boxes = new float[6 * count];
        ids = new int[count];
    }

    MeshTree tree() {
        chunks(count, (from, to) -> bound(from, to));
        float[] all = empty();
        for (int i = 0; i < count; i++) {
            grow(all, 0, boxes, 6 * i);
        }
        Set root = count == 0 ? null : ForkJoinPool.commonPool().submit(() -> split(0, count, 0, all, new Scratch())).join();
        node();
        if (root != null) {
            collapse(root, 0, 1);
        }
        float[] vertex = new float[MeshTree.LEAF * leafCount];
        int[] triangle = new int[MeshTree.WIDTH * leafCount];
        chunks(leafCount, (from, to) -> {
            for (int leaf = from; leaf < to; leaf++) {
                pack(leaf, vertex, triangle);
            }
        });
        float[] bounds = new float[6];
        for (int a = 0; count > 0 && a < 3; a++) {
            bounds[a] = all[a];
            bounds[3 + a] = -all[3 + a];
        }
        return new MeshTree(Arrays.copyOf(wideBox, MeshTree.NODE * nodes), Arrays.copyOf(wideChild, MeshTree.WIDTH * nodes), vertex,
                triangle, bounds, depth);
    }

    private interface Range {
        void run(int from, int to);
    }

    private static void chunks(int count, Range range) {
        IntStream.range(0, (count + CHUNK - 1) / CHUNK).parallel()
                .forEach(chunk -> range.run(chunk * CHUNK, Math.min(count, (chunk + 1) * CHUNK)));
    }

    private void bound(int from, int to) {
        float[] p = mesh.positions();
        int[] t = mesh.triangles();
        for (int i = from; i < to; i++) {
            ids[i] = i;
            for (int a = 0; a < 3; a++) {
                float x = p[3 * t[3 * i] + a];
                float y = p[3 * t[3 * i + 1] + a];
                float z = p[3 * t[3 * i + 2] + a];
                float least = x < y ? x : y;
                float most = x < y ? y : x;
                boxes[6 * i + a] = least < z ? least : z;
                boxes[6 * i + 3 + a] = -(most > z ? most : z);
            }
        }
    }

    private Set split(int from, int to, int level, float[] box, Scratch scratch) {
        Set set = new Set(from, to, box);
        if (to - from <= MeshTree.WIDTH) {
            return set;
        }
        float[] firstBox = empty();
        float[] secondBox = empty();
        int middle = level < MAX_SAH_DEPTH && best(from, to, scratch) ? parted(from, to, firstBox, secondBox, scratch)
                : halved(from, to, firstBox, secondBox);
        if (to - from > SHARED) {
            ForkJoinTask<Set> first = ForkJoinTask.adapt(() -> split(from, middle, level + 1, firstBox, new Scratch())).fork();
            set.second = split(middle, to, level + 1, secondBox, scratch);
            set.first = first.join();
        } else {
            set.first = split(from, middle, level + 1, firstBox, scratch);
            set.second = split(middle, to, level + 1, secondBox, scratch);
        }
        return set;
    }

    /** Writes where a set is best split to {@code scratch}; whether it can be split so at all. */
    private boolean best(int from, int to, Scratch s) {
        range(from, to, s);
        fill(from, to, s);
        double best = Double.POSITIVE_INFINITY;
        s.axis = -1;
        for (int a = 0; a < 3; a++) {
            Arrays.fill(s.sum, Float.POSITIVE_INFINITY);
            int n = 0;
            for (int b = BINS - 1; b > 0; b--) {
                grow(s.sum, 0, s.box, 6 * (a * BINS + b));
                n += s.count[a * BINS + b];
                s.above[b] = blocks(n) * area(s.sum);
            }
            Arrays.fill(s.sum, Float.POSITIVE_INFINITY);
            n = 0;
            for (int b = 1; b < BINS; b++) {
                grow(s.sum, 0, s.box, 6 * (a * BINS + b - 1));
                n += s.count[a * BINS + b - 1];
                double cost = blocks(n) * area(s.sum) + s.above[b];
                if (n > 0 && n < to - from && cost < best) {
                    best = cost;
                    s.axis = a;
                    s.bin = b;
                }
            }
        }
        return s.axis >= 0;
    }

    private static int blocks(int triangles) {
        return (triangles + MeshTree.WIDTH - 1) / MeshTree.WIDTH;
    }

    /** Twice the centre of triangle {@code i}'s box. */
    private float centre(int i, int a) {
        return boxes[6 * i + a] - boxes[6 * i + 3 + a];
    }

    private void range(int from, int to, Scratch s) {
        for (int a = 0; a < 3; a++) {
            float least = Float.POSITIVE_INFINITY;
            float most = Float.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                float c = centre(i, a);
                least = c < least ? c : least;
                most = c > most ? c : most;
            }
            s.low[a] = least;
            s.scale[a] = most > least ? SPREAD / (most - least) : 0;
        }
    }

    private int bin(int i, int a, Scratch s) {
        int b = (int) ((centre(i, a) - s.low[a]) * s.scale[a]);
        // A range so small that its inverse is endless.
        return b < BINS ? b : BINS - 1;
    }

    private void fill(int from, int to, Scratch s) {
        Arrays.fill(s.count, 0);
        Arrays.fill(s.box, Float.POSITIVE_INFINITY);
        for (int i = from; i < to; i++) {
            for (int a = 0; a < 3; a++) {
                int b = a * BINS + bin(i, a, s);
                s.count[b]++;
                grow(s.box, 6 * b, boxes, 6 * i);
            }
        }
    }

    /** Moves the triangles before the best place to the front and returns where the others begin. */
    private int parted(int from, int to, float[] first, float[] second, Scratch s) {
        int low = from;
        int high = to - 1;
        while (low <= high) {
            if (bin(low, s.axis, s) < s.bin) {
                low++;
            } else {
                swap(low, high--);
            }
        }
        for (int b = 0; b < BINS; b++) {
            grow(b < s.bin ? first : second, 0, s.box, 6 * (s.axis * BINS + b));
        }
        return low;
    }

    private int halved(int from, int to, float[] first, float[] second) {
        int middle = (from + to) >>> 1;
        for (int i = from; i < to; i++) {
            grow(i < middle ? first : second, 0, boxes, 6 * i);
        }
        return middle;
    }

    private void swap(int i, int j) {
        int id = ids[i];
        ids[i] = ids[j];
        ids[j] = id;
        for (int k = 0; k < 6; k++) {
            float b = boxes[6 * i + k];
            boxes[6 * i + k] = boxes[6 * j + k];
            boxes[6 * j + k] = b;
        }
    }

    private static float[] empty() {
        float[] box = new float[6];
        Arrays.fill(box, Float.POSITIVE_INFINITY);
        return box;
    }

    private static void grow(float[] box, int at, float[] by, int i) {
        for (int k = 0; k < 6; k++) {
            box[at + k] = by[i + k] < box[at + k] ? by[i + k] : box[at + k];
        }
    }

    private static double area(float[] box) {
        double x = -(double) box[3] - box[0];
        double y = -(double) box[4] - box[1];
        double z = -(double) box[5] - box[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }

    /** Writes what is under a set to node {@code node}, which has nothing yet. */
    private void collapse(Set set, int node, int level) {
        depth = Math.max(depth, level);
        Set[] children = new Set[MeshTree.WIDTH];
        children[0] = set;
        int n = 1;
        while (n < MeshTree.WIDTH) {
            int largest = largest(children, n);
            if (largest < 0) {
                break;
            }
            Set split = children[largest];
            children[largest] = split.first;
            children[n++] = split.second;
        }
        for (int c = 0; c < n; c++) {
            for (int a = 0; a < 3; a++) {
                wideBox[MeshTree.NODE * node + 16 * a + c] = children[c].box[a];
                wideBox[MeshTree.NODE * node + 16 * a + 8 + c] = -children[c].box[3 + a];
            }
            int child = children[c].isLeaf() ? ~leaf(children[c]) : node();
            wideChild[MeshTree.WIDTH * node + c] = child;
            if (child >= 0) {
                collapse(children[c], child, level + 1);
            }
        }
    }

    private static int largest(Set[] children, int n) {
        int largest = -1;
        double most = -1;
        for (int c = 0; c < n; c++) {
            double area = children[c].isLeaf() ? -1 : area(children[c].box);
            if (area > most) {
                most = area;
                largest = c;
            }
        }
        return largest;
    }

    private int leaf(Set set) {
        if (leafCount == leaves.length) {
            leaves = Arrays.copyOf(leaves, 2 * leafCount);
        }
        leaves[leafCount] = set;
        return leafCount++;
    }

    private int node() {
        int node = nodes++;
        if (MeshTree.WIDTH * nodes > wideChild.length) {
            wideChild = Arrays.copyOf(wideChild, 2 * wideChild.length);
            wideBox = Arrays.copyOf(wideBox, 2 * wideBox.length);
        }
        for (int c = 0; c < MeshTree.WIDTH; c++) {
            wideChild[MeshTree.WIDTH * node + c] = MeshTree.NONE;
            for (int a = 0; a < 3; a++) {
                wideBox[MeshTree.NODE * node + 16 * a + c] = MeshTree.NOWHERE;
                wideBox[MeshTree.NODE * node + 16 * a + 8 + c] = -MeshTree.NOWHERE;
            }
        }
        return node;
    }

    private void pack(int leaf, float[] vertex, int[] triangle) {
        float[] p = mesh.positions();
        int[] t = mesh.triangles();
        Set set = leaves[leaf];
        for (int s = 0; s < MeshTree.WIDTH; s++) {
            int id = set.from + s < set.to ? ids[set.from + s] : -1;
            triangle[MeshTree.WIDTH * leaf + s] = id;
            for (int v = 0; v < 3; v++) {
                for (int a = 0; a < 3; a++) {
                    vertex[MeshTree.LEAF * leaf + MeshTree.VERTEX * v + MeshTree.WIDTH * a + s] =
                            id < 0 ? Float.NaN : p[3 * t[3 * id + v] + a];
                }
            }
        }
    }
}

package lightning.trace.mesh;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.stream.IntStream;
import lightning.mesh.Mesh;

/**
 * Builds the tree of a mesh from the top: sets of triangles are split in two ({@link TriangleSplit}), on all processors, then made eight wide
 * ({@link WideNodes}).
 */
final class MeshTreeBuilder {
    /** Sets of more triangles are split by two threads. */
    private static final int SHARED = 8192;
    /** Triangles or leaves that one thread takes at a time. */
    private static final int CHUNK = 16384;

    private final Mesh mesh;
    private final int count;
    private final TriangleBoxes boxes;

    MeshTreeBuilder(Mesh mesh) {
        this.mesh = mesh;
        count = mesh.triangleCount();
        boxes = new TriangleBoxes(count);
    }

    MeshTree tree() {
        chunks(count, (from, to) -> boxes.take(mesh, from, to));
        float[] all = TriangleBoxes.empty();
        boxes.enclose(0, count, all);
        TriangleSet root = count == 0 ? null
                : ForkJoinPool.commonPool().submit(() -> split(0, count, 0, all, new TriangleSplit(boxes))).join();
        WideNodes nodes = new WideNodes(root);
        float[] vertex = new float[MeshTree.LEAF * nodes.leafCount()];
        int[] triangle = new int[MeshTree.WIDTH * nodes.leafCount()];
        chunks(nodes.leafCount(), (from, to) -> {
            for (int leaf = from; leaf < to; leaf++) {
                pack(nodes, leaf, vertex, triangle);
            }
        });
        float[] bounds = new float[6];
        for (int a = 0; count > 0 && a < 3; a++) {
            bounds[a] = all[a];
            bounds[3 + a] = -all[3 + a];
        }
        return new MeshTree(nodes.boxes(), nodes.children(), vertex, triangle, bounds, nodes.depth());
    }

    private interface Range {
        void run(int from, int to);
    }

    private static void chunks(int count, Range range) {
        IntStream.range(0, (count + CHUNK - 1) / CHUNK).parallel()
                .forEach(chunk -> range.run(chunk * CHUNK, Math.min(count, (chunk + 1) * CHUNK)));
    }

    private TriangleSet split(int from, int to, int level, float[] box, TriangleSplit splitting) {
        TriangleSet set = new TriangleSet(from, to, box);
        if (to - from <= MeshTree.WIDTH) {
            return set;
        }
        float[] firstBox = TriangleBoxes.empty();
        float[] secondBox = TriangleBoxes.empty();
        int middle = splitting.part(from, to, level, firstBox, secondBox);
        if (to - from > SHARED) {
            ForkJoinTask<TriangleSet> first =
                    ForkJoinTask.adapt(() -> split(from, middle, level + 1, firstBox, new TriangleSplit(boxes))).fork();
            set.second = split(middle, to, level + 1, secondBox, splitting);
            set.first = first.join();
        } else {
            set.first = split(from, middle, level + 1, firstBox, splitting);
            set.second = split(middle, to, level + 1, secondBox, splitting);
        }
        return set;
    }

    private void pack(WideNodes nodes, int leaf, float[] vertex, int[] triangle) {
        float[] p = mesh.positions();
        int[] t = mesh.triangles();
        TriangleSet set = nodes.leaf(leaf);
        for (int s = 0; s < MeshTree.WIDTH; s++) {
            int id = set.from + s < set.to ? boxes.ids[set.from + s] : -1;
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

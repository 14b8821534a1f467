package lightning.render.trace.mesh;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.FutureTask;
import java.util.stream.IntStream;
import lightning.scene.Mesh;

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

    private MeshTreeBuilder(Mesh mesh) {
        this.mesh = mesh;
        count = mesh.triangleCount();
        boxes = new TriangleBoxes(count);
    }

    /**
     * Builds the tree of a mesh. What is large is built by threads of its own: in the common pool a thread that waits for its part takes up other work there, and that
     * may be work which waits for this tree.
     */
    static MeshTree build(Mesh mesh) {
        var builder = new MeshTreeBuilder(mesh);
        if (builder.count <= SHARED) {
            return builder.tree();
        }
        // A task that is no ForkJoinTask: who waits for it does nothing else meanwhile.
        var task = new FutureTask<>(builder::tree);
        try (var pool = new ForkJoinPool()) {
            pool.execute(task);
            return result(task);
        }
    }

    /** An interrupt is kept for later: half a tree is of no use to the others who wait for it. */
    private static MeshTree result(FutureTask<MeshTree> task) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get();
                } catch (InterruptedException e) {
                    interrupted = true;
                } catch (ExecutionException e) {
                    // Memory may have run out.
                    if (e.getCause() instanceof Error error) {
                        throw error;
                    }
                    throw new IllegalStateException(e.getCause());
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private MeshTree tree() {
        chunks(count, (from, to) -> boxes.take(mesh, from, to));
        float[] all = TriangleBoxes.empty();
        boxes.enclose(0, count, all);
        TriangleSet root = count == 0 ? null : split(0, count, 0, all, new TriangleSplit(boxes));
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

package lightning.render.trace.mesh;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.FutureTask;
import java.util.stream.IntStream;
import lightning.scene.node.Mesh;

/**
 * Top-down builder of a mesh's BVH: splits sets of triangles in two ({@link TriangleSplitter}) on all processors, then
 * collapses them to eight-wide nodes ({@link WideNodes}).
 */
final class MeshTreeBuilder {
    /** Sets of more triangles are split by two threads. */
    private static final int PARALLEL_THRESHOLD = 8192;
    /** Triangles or leaves per unit of work. */
    private static final int CHUNK = 16384;

    private final Mesh mesh;
    private final TrianglePairs pairs;
    private final int count;
    private final TriangleBoxes boxes;

    private MeshTreeBuilder(Mesh mesh) {
        this.mesh = mesh;
        pairs = TrianglePairs.of(mesh);
        count = pairs.count();
        boxes = new TriangleBoxes(count);
    }

    /**
     * Builds the BVH of a mesh. Large meshes use a separate pool: in the common pool a thread that waits for its part runs
     * other tasks, which may in turn wait for this BVH.
     */
    static MeshTree build(Mesh mesh) {
        var builder = new MeshTreeBuilder(mesh);
        if (builder.count <= PARALLEL_THRESHOLD) {
            return builder.buildTree();
        }
        // A FutureTask, not a ForkJoinTask: the waiting thread must not run other tasks meanwhile.
        var task = new FutureTask<>(builder::buildTree);
        try (var pool = new ForkJoinPool()) {
            pool.execute(task);
            return awaitResult(task);
        }
    }

    /** Waits for the result and defers interrupts, since other threads need the complete BVH. */
    private static MeshTree awaitResult(FutureTask<MeshTree> task) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get();
                } catch (InterruptedException e) {
                    interrupted = true;
                } catch (ExecutionException e) {
                    // Memory may be exhausted.
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

    private MeshTree buildTree() {
        forEachChunk(count, (from, to) -> boxes.setPairs(mesh, pairs, from, to));
        float[] meshBox = TriangleBoxes.emptyBox();
        boxes.enclose(0, count, meshBox);
        TriangleSet root = count == 0 ? null : split(0, count, 0, meshBox, new TriangleSplitter(boxes));
        WideNodes nodes = new WideNodes(root);
        float[] vertex = new float[MeshTree.LEAF_FLOATS * nodes.leafCount()];
        int[] triangle = new int[MeshTree.WIDTH * nodes.leafCount()];
        forEachChunk(nodes.leafCount(), (from, to) -> {
            for (int leaf = from; leaf < to; leaf++) {
                packLeaf(nodes, leaf, vertex, triangle);
            }
        });
        float[] bounds = new float[6];
        for (int a = 0; count > 0 && a < 3; a++) {
            bounds[a] = meshBox[a];
            bounds[3 + a] = -meshBox[3 + a];
        }
        return new MeshTree(nodes.boxes(), nodes.children(), vertex, triangle, bounds, nodes.depth());
    }

    private interface ChunkTask {
        void run(int from, int to);
    }

    private static void forEachChunk(int count, ChunkTask chunkTask) {
        IntStream.range(0, (count + CHUNK - 1) / CHUNK).parallel()
                .forEach(chunk -> chunkTask.run(chunk * CHUNK, Math.min(count, (chunk + 1) * CHUNK)));
    }

    private TriangleSet split(int from, int to, int level, float[] box, TriangleSplitter splitter) {
        TriangleSet set = new TriangleSet(from, to, box);
        if (to - from <= MeshTree.STRIPS) {
            return set;
        }
        float[] firstBox = TriangleBoxes.emptyBox();
        float[] secondBox = TriangleBoxes.emptyBox();
        int middle = splitter.split(from, to, level, firstBox, secondBox);
        if (to - from > PARALLEL_THRESHOLD) {
            ForkJoinTask<TriangleSet> first =
                    ForkJoinTask.adapt(() -> split(from, middle, level + 1, firstBox, new TriangleSplitter(boxes))).fork();
            set.second = split(middle, to, level + 1, secondBox, splitter);
            set.first = first.join();
        } else {
            set.first = split(from, middle, level + 1, firstBox, splitter);
            set.second = split(middle, to, level + 1, secondBox, splitter);
        }
        return set;
    }

    private void packLeaf(WideNodes nodes, int leaf, float[] vertex, int[] triangle) {
        float[] p = mesh.positions();
        TriangleSet set = nodes.leaf(leaf);
        for (int s = 0; s < MeshTree.STRIPS; s++) {
            int pair = set.from + s < set.to ? boxes.ids[set.from + s] : -1;
            triangle[MeshTree.WIDTH * leaf + s] = pair < 0 ? -1 : pairs.first(pair);
            triangle[MeshTree.WIDTH * leaf + MeshTree.STRIPS + s] = pair < 0 ? -1 : pairs.second(pair);
            for (int k = 0; k < 4; k++) {
                int v = pair < 0 ? -1 : pairs.vertex(pair, k);
                for (int a = 0; a < 3; a++) {
                    vertex[MeshTree.LEAF_FLOATS * leaf + MeshTree.AXIS_FLOATS * a + MeshTree.CORNER_FLOATS * k + s] =
                            v < 0 ? Float.NaN : p[3 * v + a];
                }
            }
        }
    }
}

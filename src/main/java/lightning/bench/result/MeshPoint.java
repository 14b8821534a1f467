package lightning.bench.result;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Ray throughput on one generated mesh on one thread, with the cost of its BVH.
 *
 * @param triangles number of triangles
 * @param meshBytes bytes of vertices and indices per triangle
 * @param treeBytes bytes of the BVH per triangle
 * @param tree      build time of the BVH on all processors
 * @param rays      throughput per kind of rays
 * @param rival     another program; null if none is installed
 */
public record MeshPoint(int triangles, double meshBytes, double treeBytes, TimeSamples tree, List<RayThroughput> rays,
        @Nullable Rival rival) {
    public MeshPoint {
        rays = List.copyOf(rays);
    }

    /**
     * BVH of another program for the same mesh.
     *
     * @param program   name and settings
     * @param treeBytes bytes of its BVH per triangle
     * @param tree      build time, measured in turns with ours
     */
    public record Rival(String program, double treeBytes, TimeSamples tree) {}
}

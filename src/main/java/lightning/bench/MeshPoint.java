package lightning.bench;

import java.util.List;

/**
 * How fast rays are traced against one generated mesh, on one thread, and what its tree takes.
 *
 * @param triangles how many
 * @param meshBytes bytes of its vertices and indices for each triangle
 * @param treeBytes bytes of its tree for each triangle
 * @param tree      building that, on all processors
 * @param rays      one for each kind of rays
 * @param rival     another program; null where none is installed
 */
public record MeshPoint(int triangles, double meshBytes, double treeBytes, TimeSamples tree, List<RayThroughput> rays, Rival rival) {
    public MeshPoint {
        rays = List.copyOf(rays);
    }

    /**
     * The tree of another program over the same mesh.
     *
     * @param program   its name and how it is set
     * @param treeBytes as ours
     * @param tree      as ours, measured in turns with it
     */
    public record Rival(String program, double treeBytes, TimeSamples tree) {}
}

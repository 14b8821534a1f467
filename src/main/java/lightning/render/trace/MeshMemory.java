package lightning.render.trace;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import lightning.scene.Mesh;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** Estimate of the memory that a scene's meshes need, before any BVH is built. Each mesh counts once. */
public final class MeshMemory {
    /**
     * Bytes of a triangle in its BVH: 54 with leaves of typical occupancy ({@code MeshRayQueryTest}). During the build, add 28
     * for its box and index and about 20 for sets of triangles. The rest is reserve.
     */
    private static final long TREE_BYTES = 112;

    private MeshMemory() {}

    /** Returns the bytes of meshes and of their BVHs. */
    public static long bytes(Scene scene) {
        Set<Mesh> meshes = Collections.newSetFromMap(new IdentityHashMap<>());
        for (Shape shape : scene.stage().shapes()) {
            if (shape.solid() instanceof Solid.TriangleMesh t) {
                meshes.add(t.mesh());
            }
        }
        return meshes.stream().mapToLong(MeshMemory::bytes).sum();
    }

    private static long bytes(Mesh m) {
        return (long) Float.BYTES * (m.positions().length + length(m.normals()) + length(m.coordinates()) + length(m.colors())
                + length(m.tangents()))
                + (long) Integer.BYTES * m.triangles().length + TREE_BYTES * m.triangleCount();
    }

    private static long length(float[] column) {
        return column == null ? 0 : column.length;
    }
}

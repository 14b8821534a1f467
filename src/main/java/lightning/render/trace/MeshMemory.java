package lightning.render.trace;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import lightning.scene.Scene;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;

/** Estimate of the memory that a scene's meshes need, before any BVH is built. Each mesh counts once. */
public final class MeshMemory {
    /**
     * Bytes of a triangle in its BVH: about 40 if most triangles share an edge with another, up to 80 if none does. During the
     * build, add about 30 for boxes, indices and sets of triangles, twice as many if none does.
     */
    private static final long TREE_BYTES = 144;

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

    private static long length(float @Nullable [] column) {
        return column == null ? 0 : column.length;
    }
}

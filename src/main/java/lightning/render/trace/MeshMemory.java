package lightning.render.trace;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import lightning.scene.Mesh;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** How much memory a scene's meshes take, each once, before any tree is built. */
public final class MeshMemory {
    /**
     * Bytes of a triangle in its tree: 54 where leaves are as full as usual ({@code MeshRayQueryTest}), and the 28 of its box and number and
     * about 20 of sets of triangles while the tree is built, with some room.
     */
    private static final long TREE_BYTES = 112;

    private MeshMemory() {}

    /** The bytes of meshes and of the trees over them. */
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

package lightning.format.jen.asset;

import java.lang.ref.WeakReference;
import java.util.Map;
import java.util.WeakHashMap;
import lightning.scene.node.Mesh;

/**
 * Meshes in use that were read from files, so that a file that is read again gives the same object: comparisons of two scenes then find that its
 * shapes did not change, and share its BVH. Thread-safe.
 */
final class MeshPool {
    private static final Map<Mesh, WeakReference<Mesh>> MESHES = new WeakHashMap<>();

    private MeshPool() {}

    /** Returns the mesh in use that equals a given one, which becomes the one in use if there is none. */
    static Mesh shared(Mesh mesh) {
        synchronized (MESHES) {
            WeakReference<Mesh> reference = MESHES.get(mesh);
            Mesh known = reference == null ? null : reference.get();
            if (known == null) {
                // A key that is about to be collected would stay with a new value.
                MESHES.remove(mesh);
                MESHES.put(mesh, new WeakReference<>(mesh));
                return mesh;
            }
            return known;
        }
    }
}

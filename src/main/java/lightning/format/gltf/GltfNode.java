package lightning.format.gltf;

import java.util.List;
import lightning.base.math.Transform;

/**
 * Node of a glTF scene.
 *
 * @param index index in the file; −1 for a copy of a node
 * @param name name in the file; empty if absent
 * @param local transform from its own space to its parent's
 * @param mesh index of its mesh; −1 for none
 * @param skin index of the skin of its mesh; −1 for none
 * @param weights weights of its mesh's morph targets; empty for those of the mesh
 * @param camera index of its camera; −1 for none
 * @param light index of its light (KHR_lights_punctual); −1 for none
 */
public record GltfNode(int index, String name, Transform local, int mesh, int skin, List<Double> weights, int camera, int light,
        List<GltfNode> children) {
    /** Index of nodes that are copies of a node in the file. */
    static final int COPY = -1;

    /** Returns this node with another transform. */
    GltfNode withLocal(Transform other) {
        return new GltfNode(index, name, other, mesh, skin, weights, camera, light, children);
    }

    /** Returns a node that shows a mesh. */
    static GltfNode copy(String name, Transform local, int mesh) {
        return new GltfNode(COPY, name, local, mesh, -1, List.of(), -1, -1, List.of());
    }
}

package lightning.format.gltf;

import java.util.List;
import lightning.base.math.Transform;

/**
 * Node of a glTF scene.
 *
 * @param index index in the file
 * @param name name in the file; empty if absent
 * @param local transform from its own space to its parent's
 * @param mesh index of its mesh; −1 for none
 * @param camera index of its camera; −1 for none
 * @param light index of its light (KHR_lights_punctual); −1 for none
 */
public record GltfNode(int index, String name, Transform local, int mesh, int camera, int light, List<GltfNode> children) {}

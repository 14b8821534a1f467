package lightning.format.gltf;

import java.util.List;
import lightning.base.math.Transform;

/**
 * A node of a glTF file's scene.
 *
 * @param index  its number in the file
 * @param name   as the file says; empty where it says none
 * @param local  from its own space to that of its parent
 * @param mesh   which of the file's meshes stands there; −1 for none, likewise the other two
 * @param camera which of its cameras
 * @param light  which of its lights (KHR_lights_punctual)
 */
public record GltfNode(int index, String name, Transform local, int mesh, int camera, int light, List<GltfNode> children) {}

package lightning.format.exchange;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import lightning.base.text.Quote;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfNode;
import lightning.format.mesh.MeshException;
import lightning.scene.Camera;

/**
 * Cameras of a glTF file, of which a scene shows one and keeps all, if there are several. A camera has the name of its node, or its own if the
 * node has none.
 */
final class GltfCameras {
    /** Name of each camera, by the index of its node. */
    private final Map<Integer, String> names = new LinkedHashMap<>();
    private final String chosen;
    /** Cameras that could be placed, by the index of their node. */
    private final Map<Integer, Camera> placed = new LinkedHashMap<>();

    /**
     * Finds all cameras.
     *
     * @param roots nodes of the scene
     * @param name name of the chosen camera; empty for the stored one
     * @param stored name of the node that the file's settings of Lightning name; empty for the first camera
     * @throws MeshException if no camera has the chosen name
     */
    GltfCameras(GltfFile file, List<GltfNode> roots, String name, String stored) throws MeshException {
        List<GltfNode> pending = new ArrayList<>(roots.reversed());
        while (!pending.isEmpty()) {
            GltfNode node = pending.removeLast();
            pending.addAll(node.children().reversed());
            if (node.camera() >= 0) {
                names.put(node.index(), node.name().isEmpty() ? file.cameraName(node.camera()) : node.name());
            }
        }
        chosen = name.isEmpty() ? stored : name;
        if (!name.isEmpty() && !names.containsValue(name)) {
            throw new MeshException(file.path(), "", "must have the camera " + Quote.of(name) + ", has "
                    + (names.isEmpty() ? "none" : Quote.list(List.copyOf(names.values()))));
        }
    }

    /** Returns whether a node has a camera that the scene may show. */
    boolean isCandidate(GltfNode node) {
        return node.camera() >= 0 && (chosen.isEmpty() || chosen.equals(names.get(node.index())));
    }

    void add(GltfNode node, Camera camera) {
        placed.put(node.index(), camera);
    }

    /** Passes on all cameras with their names, in the order of the file. */
    void forEach(BiConsumer<String, Camera> receiver) {
        placed.forEach((node, camera) -> receiver.accept(requireNonNull(names.get(node)), camera));
    }
}

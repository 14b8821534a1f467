package lightning.format.exchange;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import lightning.base.text.Quote;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfNode;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.UniqueNames;
import lightning.scene.Camera;
import lightning.scene.NamedCamera;

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

    /** Returns all cameras, in the order of the file; none if there is only one. */
    List<NamedCamera> named(UnaryOperator<Camera> finished) {
        var unique = new UniqueNames();
        return placed.size() < 2 ? List.of() : placed.entrySet().stream()
                .map(e -> new NamedCamera(unique.unique(requireNonNull(names.get(e.getKey())), "camera"), finished.apply(e.getValue())))
                .toList();
    }
}

package lightning.format.exchange.usd;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.ObjectLight;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/**
 * Meshes of a stage whose surfaces are lights ({@code MeshLightAPI}). One with a material is seen and glows; another shines unseen, since it has
 * no look of its own.
 */
final class UsdMeshLights {
    private final ConversionNotes notes;
    /** By the name of a light: true if its mesh is seen. */
    private final Map<String, Boolean> seen = new LinkedHashMap<>();

    UsdMeshLights(ConversionNotes notes) {
        this.notes = notes;
    }

    /** Returns the light of a mesh with the name of its node. */
    Light placed(Light light, JsonValue in, JsonValue allNodes, UsdNodes nodes) throws MeshException {
        List<String> names = nodes.names(in.get("node").index(allNodes));
        if (names.isEmpty()) {
            notes.add("mesh lights whose mesh cannot be shown");
            return light;
        }
        boolean isSeen = in.get("bound").bool(false);
        seen.put(light.name(), isSeen);
        notes.add("mesh lights without a material, hidden from the camera", isSeen ? 0 : 1);
        notes.add("parts of mesh lights beyond the first",
                allNodes.element(in.get("node").index(allNodes)).get("subsets").size() > 0 ? 1 : 0);
        return light.withArea(light.area().withShape(names.getFirst()));
    }

    /** Returns an imported scene whose mesh lights show their glow or are hidden. */
    ImportedScene shown(ImportedScene imported) {
        return seen.isEmpty() ? imported : imported.withObjects(this::shown);
    }

    private Scene shown(Scene imported) {
        Scene scene = imported;
        for (Map.Entry<String, Boolean> entry : seen.entrySet()) {
            Optional<Light> light = scene.light(entry.getKey());
            Optional<SceneNode> node = light.flatMap(l -> imported.stage().node(l.area().shape()));
            if (light.isPresent() && node.isPresent()) {
                scene = shown(scene, light.get(), node.get(), entry.getValue());
            }
        }
        return scene;
    }

    private Scene shown(Scene scene, Light light, SceneNode node, boolean isSeen) {
        Optional<Shape> first = firstShape(node);
        if (first.isEmpty()) {
            return scene;
        }
        Shape shape = first.get();
        Scene named = scene.withLight(light.withArea(light.area().withShape(shape.name())));
        return isSeen ? ObjectLight.withBulb(named, shape, light.name()) : named.withNode(shape.name(), shape.withVisible(false));
    }

    private static Optional<Shape> firstShape(SceneNode node) {
        return switch (node) {
            case Shape shape -> Optional.of(shape);
            case NodeGroup group -> group.children().stream().flatMap(child -> firstShape(child).stream()).findFirst();
        };
    }
}

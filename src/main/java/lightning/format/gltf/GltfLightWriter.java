package lightning.format.gltf;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writer of lights into a copy of a glTF file: replaces {@code KHR_lights_punctual} and keeps everything else, including all
 * digits of numbers. A light whose node exists by name stays there; if it moved, its node moves too, unless other objects
 * depend on the node. Other lights get new root nodes.
 */
public final class GltfLightWriter {
    private static final String EXTENSION = "KHR_lights_punctual";
    /** Tolerance for comparisons, since glTF files contain floats. */
    private static final double TOLERANCE = 1e-5;
    private static final JsonMapper EXACT_JSON = GltfFile.JSON.rebuild().enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS).build();

    private final ObjectNode root;
    private final GltfFile file;
    private final Map<String, Integer> nodesByLight = new HashMap<>();
    private final Map<Integer, Transform> nodeTransforms = new HashMap<>();

    /**
     * Light with its placement.
     *
     * @param direction direction of emission, of length 1; ignored for a point
     */
    public record PlacedLight(GltfLight light, Vec3 position, Vec3 direction) {}

    private GltfLightWriter(GltfFile file) throws MeshException {
        this.file = file;
        root = (ObjectNode) file.root().node().deepCopy();
    }

    /**
     * Returns the bytes of a copy with these lights.
     *
     * @throws MeshException if the file is not glTF, or its nodes are invalid
     * @throws IOException if it cannot be read
     */
    public static byte[] replaceLights(Path path, List<PlacedLight> lights, Progress progress) throws IOException, MeshException {
        GltfFile file = GltfFile.readExactly(path, progress, EXACT_JSON);
        return new GltfLightWriter(file).replaceLights(lights);
    }

    private byte[] replaceLights(List<PlacedLight> lights) throws IOException, MeshException {
        var scene = new GltfScene(file, new ConversionNotes());
        List<GltfLight> oldLights = scene.lights();
        for (GltfNode node : scene.nodes()) {
            collectLightNodes(node, Transform.IDENTITY, oldLights);
        }
        ArrayNode nodes = childArray(root, "nodes");
        Map<Integer, Boolean> removable = removeLights(nodes);
        ArrayNode list = EXACT_JSON.createArrayNode();
        for (PlacedLight placed : lights) {
            int index = list.size();
            list.add(toJson(placed.light()));
            Integer nodeIndex = nodesByLight.remove(placed.light().name());
            if (nodeIndex == null
                    || !isPlacedAt(placed, requireNonNull(nodeTransforms.get(nodeIndex))) && !removable.getOrDefault(nodeIndex, false)) {
                ObjectNode node = EXACT_JSON.createObjectNode().put("name", placed.light().name());
                setTransform(node, placed);
                nodes.add(node);
                nodeIndex = nodes.size() - 1;
                if (root.path("scenes").get(root.path("scene").asInt(0)) instanceof ObjectNode shown) {
                    // Without a scene, all nodes are shown.
                    childArray(shown, "nodes").add(nodeIndex);
                }
            } else if (!isPlacedAt(placed, requireNonNull(nodeTransforms.get(nodeIndex)))) {
                setTransform((ObjectNode) nodes.get(nodeIndex), placed);
            }
            childObject(childObject((ObjectNode) nodes.get(nodeIndex), "extensions"), EXTENSION).put("light", index);
        }
        addExtension(list);
        return encode();
    }

    private void collectLightNodes(GltfNode node, Transform outer, List<GltfLight> oldLights) {
        Transform world = outer.times(node.local());
        if (node.light() >= 0) {
            nodesByLight.putIfAbsent(node.name().isEmpty() ? oldLights.get(node.light()).name() : node.name(), node.index());
            nodeTransforms.put(node.index(), world);
        }
        node.children().forEach(child -> collectLightNodes(child, world, oldLights));
    }

    /** Removes all lights from the nodes; returns their nodes, true for root nodes without other content. */
    private Map<Integer, Boolean> removeLights(ArrayNode nodes) {
        Map<Integer, Boolean> removable = new HashMap<>();
        for (JsonNode scene : root.path("scenes")) {
            scene.path("nodes").forEach(index -> removable.put(index.asInt(), true));
        }
        for (int i = 0; i < nodes.size(); i++) {
            ObjectNode node = (ObjectNode) nodes.get(i);
            if (node.has("mesh") || node.has("camera") || node.has("children")) {
                removable.put(i, false);
            }
            if (node.get("extensions") instanceof ObjectNode extensions && extensions.remove(EXTENSION) != null && extensions.isEmpty()) {
                node.remove("extensions");
            }
        }
        return removable;
    }

    private static boolean isPlacedAt(PlacedLight placed, Transform world) {
        Vec3 direction = world.transformVector(new Vec3(0, 0, -1));
        Vec3 position = world.transformPoint(Vec3.ZERO);
        boolean isSamePosition = placed.light().type() == GltfLight.Type.DIRECTIONAL
                || position.minus(placed.position()).maxAbs() <= TOLERANCE * Math.max(1, position.maxAbs());
        return isSamePosition && (placed.light().type() == GltfLight.Type.POINT
                || direction.maxAbs() > 0 && direction.normalized().minus(placed.direction()).maxAbs() <= TOLERANCE);
    }

    private static void setTransform(ObjectNode node, PlacedLight placed) {
        for (String property : List.of("matrix", "translation", "rotation", "scale")) {
            node.remove(property);
        }
        Vec3 p = placed.position();
        node.set("translation", EXACT_JSON.createArrayNode().add(p.x()).add(p.y()).add(p.z()));
        if (placed.light().type() != GltfLight.Type.POINT) {
            // The shortest rotation from −z: the axis is their cross product, and the half vector gives half the angle.
            Vec3 d = placed.direction();
            double w = 1 - d.z();
            double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + w * w);
            ArrayNode rotation = EXACT_JSON.createArrayNode();
            node.set("rotation", length < 1e-9 ? rotation.add(0).add(1).add(0).add(0)
                    : rotation.add(d.y() / length).add(-d.x() / length).add(0).add(w / length));
        }
    }

    private static ObjectNode toJson(GltfLight light) {
        Rgb c = light.color();
        ObjectNode json = EXACT_JSON.createObjectNode().put("name", light.name()).put("type", light.type().name().toLowerCase(Locale.ROOT));
        json.set("color", EXACT_JSON.createArrayNode().add(c.r()).add(c.g()).add(c.b()));
        json.put("intensity", light.intensity());
        if (light.type() == GltfLight.Type.SPOT) {
            json.set("spot",
                    EXACT_JSON.createObjectNode().put("innerConeAngle", light.innerAngle()).put("outerConeAngle", light.outerAngle()));
        }
        if (light.settings().isObject()) {
            json.putObject("extras").set(GltfLight.SETTINGS_KEY, light.settings());
        }
        return json;
    }

    /** Inserts the list of lights, and adds the extension to those in use. */
    private void addExtension(ArrayNode list) {
        ArrayNode used = childArray(root, "extensionsUsed");
        boolean isListed = false;
        for (JsonNode name : used) {
            isListed |= name.asString("").equals(EXTENSION);
        }
        if (!isListed) {
            used.add(EXTENSION);
        }
        childObject(childObject(root, "extensions"), EXTENSION).set("lights", list);
    }

    private static ObjectNode childObject(ObjectNode in, String name) {
        if (!(in.get(name) instanceof ObjectNode)) {
            in.set(name, EXACT_JSON.createObjectNode());
        }
        return (ObjectNode) in.get(name);
    }

    private static ArrayNode childArray(ObjectNode in, String name) {
        if (!(in.get(name) instanceof ArrayNode)) {
            in.set(name, EXACT_JSON.createArrayNode());
        }
        return (ArrayNode) in.get(name);
    }

    private byte[] encode() {
        byte[] json =
                file.isBinary() ? EXACT_JSON.writeValueAsBytes(root) : EXACT_JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root);
        if (!file.isBinary()) {
            return json;
        }
        byte[] data = file.binaryChunk();
        int paddedLength = (json.length + 3) / 4 * 4;
        ByteBuffer out = GltfFile.littleEndian(new byte[20 + paddedLength + (data == null ? 0 : 8 + data.length)]);
        out.put(GltfFile.MAGIC).putInt(2).putInt(out.capacity()).putInt(paddedLength).putInt(GltfFile.JSON_CHUNK).put(json);
        while (out.position() < 20 + paddedLength) {
            out.put((byte) ' ');
        }
        if (data != null) {
            out.putInt(data.length).putInt(GltfFile.BINARY_CHUNK).put(data);
        }
        return out.array();
    }
}

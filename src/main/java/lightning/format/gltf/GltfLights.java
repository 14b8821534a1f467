package lightning.format.gltf;

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
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Puts lights into a copy of a glTF file: its {@code KHR_lights_punctual} is replaced, and all else stays as it is, numbers to
 * their last digit. A light whose node the file has already, by its name, stays there, and where it moved, the node does, if
 * nothing else hangs on it; others get nodes of their own at the root.
 */
public final class GltfLights {
    private static final String LIGHTS = "KHR_lights_punctual";
    /** Files hold floats. */
    private static final double SAME = 1e-5;
    private static final JsonMapper EXACT = GltfFile.JSON.rebuild().enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS).build();

    private final ObjectNode root;
    private final GltfFile file;
    private final Map<String, Integer> places = new HashMap<>();
    private final Map<Integer, Transform> worlds = new HashMap<>();

    /**
     * A light where it stands.
     *
     * @param direction where it shines to, of length 1; of no meaning for a point
     */
    public record Placed(GltfLight light, Vec3 position, Vec3 direction) {}

    private GltfLights(GltfFile file) throws MeshException {
        this.file = file;
        root = (ObjectNode) file.root().node().deepCopy();
    }

    /**
     * The bytes of a copy with these lights.
     *
     * @throws MeshException if the file is no glTF, or its nodes are wrong
     * @throws IOException   if it cannot be read
     */
    public static byte[] replaced(Path path, List<Placed> lights, Progress progress) throws IOException, MeshException {
        GltfFile file = GltfFile.readExactly(path, progress, EXACT);
        return new GltfLights(file).copy(lights);
    }

    private byte[] copy(List<Placed> lights) throws MeshException {
        var scene = new GltfScene(file, new Notes());
        List<GltfLight> before = scene.lights();
        for (GltfNode node : scene.nodes()) {
            find(node, Transform.IDENTITY, before);
        }
        ArrayNode nodes = array(root, "nodes");
        Map<Integer, Boolean> free = strip(nodes);
        ArrayNode list = EXACT.createArrayNode();
        for (Placed placed : lights) {
            int index = list.size();
            list.add(light(placed.light()));
            Integer at = places.remove(placed.light().name());
            if (at == null || !isAt(placed, worlds.get(at)) && !free.getOrDefault(at, false)) {
                ObjectNode node = EXACT.createObjectNode().put("name", placed.light().name());
                place(node, placed);
                nodes.add(node);
                at = nodes.size() - 1;
                array((ObjectNode) array(root, "scenes").get(root.path("scene").asInt(0)), "nodes").add(at);
            } else if (!isAt(placed, worlds.get(at))) {
                place((ObjectNode) nodes.get(at), placed);
            }
            object(object((ObjectNode) nodes.get(at), "extensions"), LIGHTS).put("light", index);
        }
        name(list);
        return bytes();
    }

    private void find(GltfNode node, Transform outer, List<GltfLight> before) {
        Transform world = outer.times(node.local());
        if (node.light() >= 0) {
            places.putIfAbsent(node.name().isEmpty() ? before.get(node.light()).name() : node.name(), node.index());
            worlds.put(node.index(), world);
        }
        node.children().forEach(child -> find(child, world, before));
    }

    /** Takes all lights from the nodes; tells which of those stand at the root and carry nothing else. */
    private Map<Integer, Boolean> strip(ArrayNode nodes) {
        Map<Integer, Boolean> free = new HashMap<>();
        for (JsonNode scene : root.path("scenes")) {
            scene.path("nodes").forEach(index -> free.put(index.asInt(), true));
        }
        for (int i = 0; i < nodes.size(); i++) {
            ObjectNode node = (ObjectNode) nodes.get(i);
            if (node.has("mesh") || node.has("camera") || node.has("children")) {
                free.put(i, false);
            }
            if (node.get("extensions") instanceof ObjectNode extensions && extensions.remove(LIGHTS) != null && extensions.isEmpty()) {
                node.remove("extensions");
            }
        }
        return free;
    }

    private static boolean isAt(Placed placed, Transform world) {
        Vec3 shines = world.vector(new Vec3(0, 0, -1));
        Vec3 place = world.point(Vec3.ZERO);
        boolean there = placed.light().type() == GltfLight.Type.DIRECTIONAL
                || place.minus(placed.position()).maxAbs() <= SAME * Math.max(1, place.maxAbs());
        return there && (placed.light().type() == GltfLight.Type.POINT
                || shines.maxAbs() > 0 && shines.normalized().minus(placed.direction()).maxAbs() <= SAME);
    }

    private static void place(ObjectNode node, Placed placed) {
        for (String old : List.of("matrix", "translation", "rotation", "scale")) {
            node.remove(old);
        }
        Vec3 p = placed.position();
        node.set("translation", EXACT.createArrayNode().add(p.x()).add(p.y()).add(p.z()));
        if (placed.light().type() != GltfLight.Type.POINT) {
            // The shortest turn from −z: its axis is their cross product, and half its angle lies between them.
            Vec3 d = placed.direction();
            double w = 1 - d.z();
            double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + w * w);
            ArrayNode turn = EXACT.createArrayNode();
            node.set("rotation", length < 1e-9 ? turn.add(0).add(1).add(0).add(0)
                    : turn.add(d.y() / length).add(-d.x() / length).add(0).add(w / length));
        }
    }

    private static ObjectNode light(GltfLight light) {
        Rgb c = light.color();
        ObjectNode out = EXACT.createObjectNode().put("name", light.name()).put("type", light.type().name().toLowerCase(Locale.ROOT));
        out.set("color", EXACT.createArrayNode().add(c.r()).add(c.g()).add(c.b()));
        out.put("intensity", light.intensity());
        if (light.type() == GltfLight.Type.SPOT) {
            out.set("spot", EXACT.createObjectNode().put("innerConeAngle", light.inner()).put("outerConeAngle", light.outer()));
        }
        if (light.own().isObject()) {
            out.putObject("extras").set(GltfLight.OWN, light.own());
        }
        return out;
    }

    /** Puts the list where it belongs, and the extension among those in use. */
    private void name(ArrayNode list) {
        ArrayNode used = array(root, "extensionsUsed");
        boolean known = false;
        for (JsonNode name : used) {
            known |= name.asString("").equals(LIGHTS);
        }
        if (!known) {
            used.add(LIGHTS);
        }
        object(object(root, "extensions"), LIGHTS).set("lights", list);
    }

    private static ObjectNode object(ObjectNode in, String name) {
        if (!(in.get(name) instanceof ObjectNode)) {
            in.set(name, EXACT.createObjectNode());
        }
        return (ObjectNode) in.get(name);
    }

    private static ArrayNode array(ObjectNode in, String name) {
        if (!(in.get(name) instanceof ArrayNode)) {
            in.set(name, EXACT.createArrayNode());
        }
        return (ArrayNode) in.get(name);
    }

    private byte[] bytes() {
        byte[] json = file.isBinary() ? EXACT.writeValueAsBytes(root) : EXACT.writerWithDefaultPrettyPrinter().writeValueAsBytes(root);
        if (!file.isBinary()) {
            return json;
        }
        byte[] data = file.binary();
        int padded = (json.length + 3) / 4 * 4;
        ByteBuffer out = GltfFile.little(new byte[20 + padded + (data == null ? 0 : 8 + data.length)]);
        out.put(GltfFile.MAGIC).putInt(2).putInt(out.capacity()).putInt(padded).putInt(GltfFile.JSON_CHUNK).put(json);
        while (out.position() < 20 + padded) {
            out.put((byte) ' ');
        }
        if (data != null) {
            out.putInt(data.length).putInt(GltfFile.BINARY_CHUNK).put(data);
        }
        return out.array();
    }
}

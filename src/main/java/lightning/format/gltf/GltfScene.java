package lightning.format.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import tools.jackson.databind.JsonNode;

/** Content of a glTF file except meshes: nodes, cameras, lights, materials, images. */
public final class GltfScene {
    /** Maximum nesting depth of nodes in a scene. Deeper ones become neighbors. */
    public static final int MAX_NESTING = 30;
    /** Maximum nesting depth of nodes in a file. */
    private static final int MAX_DEPTH = 500;
    private static final String LIGHTS = "KHR_lights_punctual";

    private final GltfFile file;
    private final ConversionNotes notes;
    private final boolean[] visited;
    private final NodeInstances instances;

    /**
     * Creates a reader.
     *
     * @param notes receives omitted features
     */
    public GltfScene(GltfFile file, ConversionNotes notes) throws MeshException {
        this.file = file;
        this.notes = notes;
        visited = new boolean[file.array("nodes").size()];
        instances = new NodeInstances(file);
        file.noteExtensions(notes);
    }

    /**
     * Returns the nodes of the default scene, limited by the file's size.
     *
     * @param limit number of shapes allowed for any file size
     * @throws MeshException if there are more, or the nodes are invalid
     * @throws IOException if the size of a buffer cannot be read
     */
    public List<GltfNode> nodes(long limit) throws IOException, MeshException {
        List<GltfNode> nodes = nodes();
        ExpansionLimit.checkShapes(file, nodes, limit);
        return nodes;
    }

    /** Returns the nodes of the default scene; all nodes if the file has no scene. */
    List<GltfNode> nodes() throws IOException, MeshException {
        JsonValue scenes = file.array("scenes");
        if (scenes.size() == 0) {
            return rootNodes();
        }
        notes.add("additional scenes", scenes.size() - 1);
        JsonValue scene = scenes.element(file.root().get("scene").integer(0, scenes.size() - 1, 0));
        return readNodes(scene.get("nodes"), 1);
    }

    private List<GltfNode> rootNodes() throws IOException, MeshException {
        JsonValue all = file.array("nodes");
        var children = new BitSet();
        for (int i = 0; i < all.size(); i++) {
            JsonValue indices = all.element(i).get("children");
            for (int j = 0; j < indices.size(); j++) {
                children.set(indices.element(j).index(all));
            }
        }
        List<GltfNode> nodes = new ArrayList<>();
        for (int i = children.nextClearBit(0); i < all.size(); i = children.nextClearBit(i + 1)) {
            nodes.addAll(readNode(all.element(i), i, 1));
        }
        return List.copyOf(nodes);
    }

    private List<GltfNode> readNodes(JsonValue indices, int nesting) throws IOException, MeshException {
        List<GltfNode> nodes = new ArrayList<>();
        for (int i = 0; i < indices.size(); i++) {
            nodes.addAll(readNode(indices.element(i), indices.element(i).index(file.array("nodes")), nesting));
        }
        return List.copyOf(nodes);
    }

    /**
     * Reads a node; empty if it is hidden. Several if it is nested too deep for a scene: those in it come after it.
     *
     * @param reference place in the file, for messages
     */
    private List<GltfNode> readNode(JsonValue reference, int index, int nesting) throws IOException, MeshException {
        if (nesting > MAX_DEPTH) {
            throw reference.problem("nodes must be nested at most " + MAX_DEPTH + " deep");
        }
        if (visited[index]) {
            throw reference.problem("must be a node with a single parent, was " + index);
        }
        visited[index] = true;
        JsonValue node = file.array("nodes").element(index);
        JsonValue mesh = node.get("mesh");
        JsonValue camera = node.get("camera");
        JsonValue light = node.get("extensions").get(LIGHTS).get("light");
        if (!node.get("extensions").get("KHR_node_visibility").get("visible").bool(true)) {
            notes.add("hidden nodes (KHR_node_visibility), left out with all that is in them");
            return List.of();
        }
        String name = node.get("name").text().orElse("");
        int meshIndex = mesh.isPresent() ? mesh.index(file.array("meshes")) : -1;
        JsonValue skin = node.get("skin");
        List<GltfNode> children = new ArrayList<>(readNodes(node.get("children"), nesting + 1));
        List<Transform> copies = meshIndex < 0 ? List.of() : instances.of(node);
        copies.forEach(copy -> children.add(GltfNode.copy(name, copy, meshIndex)));
        Transform transform = localTransform(node);
        List<GltfNode> neighbors = List.of();
        if (nesting >= MAX_NESTING && !children.isEmpty()) {
            notes.add("nodes nested more than " + MAX_NESTING + " deep, which became neighbors of those around them");
            neighbors = children.stream().map(child -> child.withLocal(transform.times(child.local()))).toList();
            children.clear();
        }
        var read = new GltfNode(index, name, transform, copies.isEmpty() ? meshIndex : -1,
                skin.isPresent() ? skin.index(file.array("skins")) : -1, weights(node),
                camera.isPresent() ? camera.index(file.array("cameras")) : -1,
                light.isPresent() ? light.index(lightArray()) : -1, List.copyOf(children));
        return Stream.concat(Stream.of(read), neighbors.stream()).toList();
    }

    private static List<Double> weights(JsonValue node) throws MeshException {
        List<Double> weights = new ArrayList<>();
        JsonValue array = node.get("weights");
        for (int i = 0; i < array.size(); i++) {
            weights.add(array.element(i).number());
        }
        return List.copyOf(weights);
    }

    private static Transform localTransform(JsonValue node) throws MeshException {
        if (node.get("matrix").isPresent()) {
            // Column-major.
            double[] m = node.get("matrix").numbers(new double[16]);
            return new Transform(m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]);
        }
        double[] q = node.get("rotation").numbers(0, 0, 0, 1);
        if (!(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0)) {
            throw node.get("rotation").problem("must not be zero");
        }
        return transform(node.get("translation").numbers(0, 0, 0), q, node.get("scale").numbers(1, 1, 1));
    }

    /**
     * Returns scaling, then rotation, then translation.
     *
     * @param t translation
     * @param q quaternion x, y, z, w; not zero
     * @param s scale
     */
    static Transform transform(double[] t, double[] q, double[] s) {
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        double x = q[0] / length;
        double y = q[1] / length;
        double z = q[2] / length;
        double w = q[3] / length;
        Transform rotated = new Transform(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t[0],
                2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t[1],
                2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t[2]);
        return rotated.times(Transform.scaling(new Vec3(s[0], s[1], s[2])));
    }

    private JsonValue lightArray() throws MeshException {
        return file.root().get("extensions").get(LIGHTS).get("lights");
    }

    /** Returns all lights, in index order. */
    public List<GltfLight> lights() throws MeshException {
        List<GltfLight> lights = new ArrayList<>();
        JsonValue array = lightArray();
        for (int i = 0; i < array.size(); i++) {
            JsonValue light = array.element(i);
            String type = light.get("type").text().orElse("missing");
            if (!type.equals("directional") && !type.equals("point") && !type.equals("spot")) {
                throw light.get("type").problem("must be directional, point or spot, was " + Quote.of(type));
            }
            double[] color = light.get("color").numbers(1, 1, 1);
            JsonValue spot = light.get("spot");
            lights.add(new GltfLight(i, light.get("name").text().orElse(""), GltfLight.Type.valueOf(type.toUpperCase(Locale.ROOT)),
                    new Rgb(color[0], color[1], color[2]), light.get("intensity").number(1), spot.get("innerConeAngle").number(0),
                    spot.get("outerConeAngle").number(Math.PI / 4), light.get("range").isPresent(),
                    light.get("extras").node().path(GltfLight.SETTINGS_KEY)));
        }
        return List.copyOf(lights);
    }

    /** Returns the number of animations. */
    public int animationCount() throws MeshException {
        return file.array("animations").size();
    }

    /**
     * Counts the skins of nodes that have a moving joint, each as often as it is shown.
     *
     * @param moves whether a node moves
     */
    public int movingSkinCount(List<GltfNode> nodes, Predicate<GltfNode> moves) throws MeshException {
        var moving = new BitSet();
        addMoving(nodes, moves, moving);
        return countSkins(nodes, moving);
    }

    private static void addMoving(List<GltfNode> nodes, Predicate<GltfNode> moves, BitSet moving) {
        for (GltfNode node : nodes) {
            if (node.index() >= 0) {
                moving.set(node.index(), moves.test(node));
            }
            addMoving(node.children(), moves, moving);
        }
    }

    private int countSkins(List<GltfNode> nodes, BitSet moving) throws MeshException {
        int count = 0;
        for (GltfNode node : nodes) {
            count += node.skin() >= 0 && node.mesh() >= 0 && hasMovingJoint(node.skin(), moving) ? 1 : 0;
            count += countSkins(node.children(), moving);
        }
        return count;
    }

    private boolean hasMovingJoint(int skin, BitSet moving) throws MeshException {
        JsonValue joints = file.array("skins").element(skin).get("joints");
        for (int i = 0; i < joints.size(); i++) {
            if (moving.get(joints.element(i).index(file.array("nodes")))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns a camera.
     *
     * @param notes receives its unsupported values
     */
    public GltfCamera camera(int camera, ConversionNotes notes) throws MeshException {
        JsonValue json = file.array("cameras").element(camera);
        JsonValue perspective = json.get("perspective");
        JsonValue orthographic = json.get("orthographic");
        for (String plane : List.of("znear", "zfar")) {
            notes.add("clipping distances of cameras (" + plane + ")",
                    perspective.get(plane).isPresent() || orthographic.get(plane).isPresent() ? 1 : 0);
        }
        JsonValue yfov = perspective.get("yfov");
        return new GltfCamera(yfov.isPresent() ? Optional.of(yfov.number()) : Optional.empty(),
                orthographic.isPresent() ? Optional.of(positive(orthographic.get("xmag")) / positive(orthographic.get("ymag")))
                        : perspective.get("aspectRatio").isPresent() ? Optional.of(positive(perspective.get("aspectRatio")))
                        : Optional.empty());
    }

    private static double positive(JsonValue value) throws MeshException {
        double v = value.number();
        if (!(v > 0)) {
            throw value.problem("must be above 0, was " + DecimalNumber.format(v));
        }
        return v;
    }

    /** Returns all materials, in index order; a gray one in the place of one with invalid values. */
    public List<GltfMaterial> materials() throws MeshException {
        List<GltfMaterial> materials = new ArrayList<>();
        JsonValue array = file.array("materials");
        for (int i = 0; i < array.size(); i++) {
            try {
                materials.add(new MaterialReader(file, notes).material(array.element(i)));
            } catch (MeshException e) {
                notes.add("materials with invalid values, imported as gray");
                materials.add(GltfMaterial.GRAY);
            }
        }
        return List.copyOf(materials);
    }

    /** Returns this program's settings from the extras of the file's root; a missing node if absent. */
    public JsonNode settings() {
        return file.root().node().path("extras").path(GltfLight.SETTINGS_KEY);
    }

    /** Returns the name of an image in the file; empty if absent. */
    public String imageName(int image) throws MeshException {
        return file.array("images").element(image).get("name").text().orElse("");
    }

    /** Returns the reference to the file of an image, as written; empty if it is embedded. */
    public Optional<String> imageReference(int image) throws MeshException {
        JsonValue uri = file.array("images").element(image).get("uri");
        return !uri.isPresent() ? Optional.empty() : uri.text().filter(text -> !text.startsWith("data:"));
    }

    /** Returns the bytes of an embedded image. */
    public byte[] imageBytes(int image) throws IOException, MeshException {
        JsonValue json = file.array("images").element(image);
        if (json.get("uri").isPresent()) {
            return file.buffers().bytes(json.get("uri"));
        }
        ByteBuffer view = file.buffers().view(json.get("bufferView"));
        byte[] bytes = new byte[view.remaining()];
        view.get(bytes);
        return bytes;
    }

    /** Returns the external buffer files. */
    public Set<Path> bufferFiles() throws IOException, MeshException {
        return file.bufferFiles();
    }
}

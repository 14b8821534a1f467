package lightning.format.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
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
    /** Maximum nesting depth of nodes. */
    public static final int MAX_NESTING = 30;
    private static final String LIGHTS = "KHR_lights_punctual";

    private final GltfFile file;
    private final ConversionNotes notes;
    private final boolean[] visited;

    /**
     * Creates a reader.
     *
     * @param notes receives omitted features
     */
    public GltfScene(GltfFile file, ConversionNotes notes) throws MeshException {
        this.file = file;
        this.notes = notes;
        visited = new boolean[file.array("nodes").size()];
        for (String property : List.of("animations", "skins")) {
            notes.add(property, file.array(property).size());
        }
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

    /** Returns the nodes of the default scene. */
    List<GltfNode> nodes() throws MeshException {
        JsonValue scenes = file.array("scenes");
        if (scenes.size() == 0) {
            throw file.root().get("scenes").problem("must have a scene");
        }
        notes.add("additional scenes", scenes.size() - 1);
        JsonValue scene = scenes.element(file.root().get("scene").integer(0, scenes.size() - 1, 0));
        return readNodes(scene.get("nodes"), 1);
    }

    private List<GltfNode> readNodes(JsonValue indices, int nesting) throws MeshException {
        List<GltfNode> nodes = new ArrayList<>();
        for (int i = 0; i < indices.size(); i++) {
            nodes.add(readNode(indices.element(i), nesting));
        }
        return List.copyOf(nodes);
    }

    private GltfNode readNode(JsonValue reference, int nesting) throws MeshException {
        if (nesting > MAX_NESTING) {
            throw reference.problem("nodes must be nested at most " + MAX_NESTING + " deep");
        }
        int index = reference.index(file.array("nodes"));
        if (visited[index]) {
            throw reference.problem("must be a node with a single parent, was " + index);
        }
        visited[index] = true;
        JsonValue node = file.array("nodes").element(index);
        JsonValue mesh = node.get("mesh");
        JsonValue camera = node.get("camera");
        JsonValue light = node.get("extensions").get(LIGHTS).get("light");
        return new GltfNode(index, node.get("name").text().orElse(""), localTransform(node),
                mesh.isPresent() ? mesh.index(file.array("meshes")) : -1,
                camera.isPresent() ? camera.index(file.array("cameras")) : -1, light.isPresent() ? light.index(lightArray()) : -1,
                readNodes(node.get("children"), nesting + 1));
    }

    private static Transform localTransform(JsonValue node) throws MeshException {
        if (node.get("matrix").isPresent()) {
            // Column-major.
            double[] m = node.get("matrix").numbers(new double[16]);
            return new Transform(m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]);
        }
        double[] t = node.get("translation").numbers(0, 0, 0);
        double[] q = node.get("rotation").numbers(0, 0, 0, 1);
        double[] s = node.get("scale").numbers(1, 1, 1);
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(length > 0)) {
            throw node.get("rotation").problem("must not be zero");
        }
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

    /** Returns a camera; notes its unsupported values. */
    public GltfCamera camera(int camera) throws MeshException {
        JsonValue json = file.array("cameras").element(camera);
        JsonValue perspective = json.get("perspective");
        JsonValue orthographic = json.get("orthographic");
        for (String plane : List.of("znear", "zfar")) {
            notes.add(plane + " of cameras", perspective.get(plane).isPresent() || orthographic.get(plane).isPresent() ? 1 : 0);
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

    /** Returns all materials, in index order. */
    public List<GltfMaterial> materials() throws MeshException {
        var reader = new MaterialReader(file, notes);
        List<GltfMaterial> materials = new ArrayList<>();
        JsonValue array = file.array("materials");
        for (int i = 0; i < array.size(); i++) {
            materials.add(reader.material(array.element(i)));
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

    /** Returns the file of an image, in this file's folder; empty if it is embedded. */
    public Optional<Path> imageFile(int image) throws IOException, MeshException {
        JsonValue uri = file.array("images").element(image).get("uri");
        return !uri.isPresent() || uri.text().orElse("").startsWith("data:") ? Optional.empty()
                : Optional.of(file.buffers().siblingFile(uri));
    }

    /** Returns the bytes of an image, embedded or external. */
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
        return file.buffers().files();
    }
}

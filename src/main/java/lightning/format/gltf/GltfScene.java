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
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;

/** What a glTF file says beside its meshes: nodes, cameras, lights, materials, images. */
public final class GltfScene {
    /** Nodes inside nodes. */
    public static final int MOST_NESTING = 30;
    private static final String LIGHTS = "KHR_lights_punctual";

    private final GltfFile file;
    private final Notes notes;
    private final boolean[] seen;

    /** @param notes hears what is left out */
    public GltfScene(GltfFile file, Notes notes) throws MeshException {
        this.file = file;
        this.notes = notes;
        seen = new boolean[file.array("nodes").size()];
        for (String unknown : List.of("animations", "skins")) {
            notes.add(unknown, file.array(unknown).size());
        }
        file.tellExtensions(notes);
    }

    /**
     * The nodes of the scene that the file shows first, if they show no more shapes than its bytes justify.
     *
     * @param limit how many shapes there may be whatever the file's size
     * @throws MeshException if there are more, or the nodes are wrong
     * @throws IOException   if the size of a buffer cannot be read
     */
    public List<GltfNode> nodes(long limit) throws IOException, MeshException {
        List<GltfNode> nodes = nodes();
        Unfolding.checkShapes(file, nodes, limit);
        return nodes;
    }

    /** The nodes of the scene that the file shows first. */
    List<GltfNode> nodes() throws MeshException {
        Json scenes = file.array("scenes");
        if (scenes.size() == 0) {
            throw file.root().get("scenes").problem("must have a scene");
        }
        notes.add("other scenes", scenes.size() - 1);
        Json scene = scenes.at(file.root().get("scene").whole(0, scenes.size() - 1, 0));
        return nodes(scene.get("nodes"), 1);
    }

    private List<GltfNode> nodes(Json indices, int nesting) throws MeshException {
        List<GltfNode> nodes = new ArrayList<>();
        for (int i = 0; i < indices.size(); i++) {
            nodes.add(node(indices.at(i), nesting));
        }
        return List.copyOf(nodes);
    }

    private GltfNode node(Json reference, int nesting) throws MeshException {
        if (nesting > MOST_NESTING) {
            throw reference.problem("nodes must be nested at most " + MOST_NESTING + " deep");
        }
        int index = reference.index(file.array("nodes"));
        if (seen[index]) {
            throw reference.problem("must be a node that stands nowhere else, was " + index);
        }
        seen[index] = true;
        Json node = file.array("nodes").at(index);
        Json mesh = node.get("mesh");
        Json camera = node.get("camera");
        Json light = node.get("extensions").get(LIGHTS).get("light");
        return new GltfNode(index, node.get("name").text().orElse(""), local(node), mesh.isThere() ? mesh.index(file.array("meshes")) : -1,
                camera.isThere() ? camera.index(file.array("cameras")) : -1, light.isThere() ? light.index(lightArray()) : -1,
                nodes(node.get("children"), nesting + 1));
    }

    private static Transform local(Json node) throws MeshException {
        if (node.get("matrix").isThere()) {
            // Column by column.
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
        Transform turned = new Transform(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t[0],
                2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t[1],
                2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t[2]);
        return turned.times(Transform.scaling(new Vec3(s[0], s[1], s[2])));
    }

    private Json lightArray() throws MeshException {
        return file.root().get("extensions").get(LIGHTS).get("lights");
    }

    /** All lights, by their numbers. */
    public List<GltfLight> lights() throws MeshException {
        List<GltfLight> lights = new ArrayList<>();
        Json array = lightArray();
        for (int i = 0; i < array.size(); i++) {
            Json light = array.at(i);
            String type = light.get("type").text().orElse("missing");
            if (!type.equals("directional") && !type.equals("point") && !type.equals("spot")) {
                throw light.get("type").problem("must be directional, point or spot, was " + Quote.of(type));
            }
            double[] color = light.get("color").numbers(1, 1, 1);
            Json spot = light.get("spot");
            lights.add(new GltfLight(i, light.get("name").text().orElse(""), GltfLight.Type.valueOf(type.toUpperCase(Locale.ROOT)),
                    new Rgb(color[0], color[1], color[2]), light.get("intensity").number(1), spot.get("innerConeAngle").number(0),
                    spot.get("outerConeAngle").number(Math.PI / 4), light.get("range").isThere(),
                    light.get("extras").node().path(GltfLight.OWN)));
        }
        return List.copyOf(lights);
    }

    /** A camera by its number. Its other numbers are told. */
    public GltfCamera camera(int camera) throws MeshException {
        Json look = file.array("cameras").at(camera);
        Json perspective = look.get("perspective");
        Json orthographic = look.get("orthographic");
        for (String plane : List.of("znear", "zfar")) {
            notes.add(plane + " of cameras", perspective.get(plane).isThere() || orthographic.get(plane).isThere() ? 1 : 0);
        }
        Json yfov = perspective.get("yfov");
        return new GltfCamera(yfov.isThere() ? Optional.of(yfov.number()) : Optional.empty(),
                orthographic.isThere() ? Optional.of(aboveZero(orthographic.get("xmag")) / aboveZero(orthographic.get("ymag")))
                        : perspective.get("aspectRatio").isThere() ? Optional.of(aboveZero(perspective.get("aspectRatio")))
                        : Optional.empty());
    }

    private static double aboveZero(Json value) throws MeshException {
        double v = value.number();
        if (!(v > 0)) {
            throw value.problem("must be above 0, was " + Decimal.text(v));
        }
        return v;
    }

    /** All materials, by their numbers. */
    public List<GltfMaterial> materials() throws MeshException {
        var reader = new MaterialReader(file, notes);
        List<GltfMaterial> materials = new ArrayList<>();
        Json array = file.array("materials");
        for (int i = 0; i < array.size(); i++) {
            materials.add(reader.material(array.at(i)));
        }
        return List.copyOf(materials);
    }

    /** The name of an image, as the file says; empty where it says none. */
    public String imageName(int image) throws MeshException {
        return file.array("images").at(image).get("name").text().orElse("");
    }

    /** The file that an image is, in the folder of this one; empty where it is embedded. */
    public Optional<Path> imageFile(int image) throws IOException, MeshException {
        Json uri = file.array("images").at(image).get("uri");
        return !uri.isThere() || uri.text().orElse("").startsWith("data:") ? Optional.empty() : Optional.of(file.buffers().beside(uri));
    }

    /** The bytes of an image, be it embedded or a file. */
    public byte[] imageBytes(int image) throws IOException, MeshException {
        Json at = file.array("images").at(image);
        if (at.get("uri").isThere()) {
            return file.buffers().bytes(at.get("uri"));
        }
        ByteBuffer view = file.buffers().view(at.get("bufferView"));
        byte[] bytes = new byte[view.remaining()];
        view.get(bytes);
        return bytes;
    }

    /** The files beside this one that hold its buffers. */
    public Set<Path> bufferFiles() throws IOException, MeshException {
        return file.buffers().files();
    }
}

package lightning.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.math.Rgb;
import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.mesh.MeshException;
import lightning.mesh.Notes;
import lightning.text.Quote;

/** What a glTF file says beside its meshes: nodes, cameras, lights, materials, images. */
public final class GltfScene {
    /** Nodes inside nodes. */
    public static final int MOST_NESTING = 30;
    private static final String LIGHTS = "KHR_lights_punctual";
    private static final int REPEAT = 10497;
    private static final int NEAREST = 9728;

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

    /** The nodes of the scene that the file shows first. */
    public List<GltfNode> nodes() throws MeshException {
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
                    spot.get("outerConeAngle").number(Math.PI / 4), light.get("range").isThere()));
        }
        return List.copyOf(lights);
    }

    /** The vertical opening angle of a camera, radians; empty where it has none, and nothing is smaller farther away. Its other numbers are told. */
    public Optional<Double> fieldOfView(int camera) throws MeshException {
        Json look = file.array("cameras").at(camera);
        Json perspective = look.get("perspective");
        Json yfov = perspective.get("yfov");
        notes.add("aspect ratios of cameras", perspective.get("aspectRatio").isThere() ? 1 : 0);
        for (String plane : List.of("znear", "zfar")) {
            boolean there = perspective.get(plane).isThere() || look.get("orthographic").get(plane).isThere();
            notes.add(plane + " of cameras", there ? 1 : 0);
        }
        return yfov.isThere() ? Optional.of(yfov.number()) : Optional.empty();
    }

    /** All materials, by their numbers. */
    public List<GltfMaterial> materials() throws MeshException {
        List<GltfMaterial> materials = new ArrayList<>();
        Json array = file.array("materials");
        for (int i = 0; i < array.size(); i++) {
            materials.add(material(array.at(i)));
        }
        return List.copyOf(materials);
    }

    private GltfMaterial material(Json material) throws MeshException {
        Json look = material.get("pbrMetallicRoughness");
        Json extensions = material.get("extensions");
        double[] base = look.get("baseColorFactor").numbers(1, 1, 1, 1);
        double[] emission = material.get("emissiveFactor").numbers(0, 0, 0);
        double strength = extensions.get("KHR_materials_emissive_strength").get("emissiveStrength").number(1);
        double ior = extensions.get("KHR_materials_ior").get("ior").number(1.5);
        Json specular = extensions.get("KHR_materials_specular");
        double[] tint = specular.get("specularColorFactor").numbers(1, 1, 1);
        double head = Math.pow((ior - 1) / (ior + 1), 2) * specular.get("specularFactor").number(1);
        for (String picture : List.of("occlusionTexture", "emissiveTexture")) {
            notes.add(picture + " of materials", material.get(picture).isThere() ? 1 : 0);
        }
        for (String picture : List.of("specularTexture", "specularColorTexture")) {
            notes.add(picture + " of materials", specular.get(picture).isThere() ? 1 : 0);
        }
        Json normals = material.get("normalTexture");
        notes.add("metallicRoughnessTexture of materials", look.get("metallicRoughnessTexture").isThere() ? 1 : 0);
        notes.add("transparent materials", material.get("alphaMode").text().orElse("OPAQUE").equals("OPAQUE") ? 0 : 1);
        return new GltfMaterial(material.get("name").text().orElse(""), new Rgb(base[0], base[1], base[2]),
                look.get("metallicFactor").number(1),
                look.get("roughnessFactor").number(1), new Rgb(head * tint[0], head * tint[1], head * tint[2]),
                new Rgb(emission[0], emission[1], emission[2]).times(strength), extensions.get("KHR_materials_unlit").isThere(),
                image(look.get("baseColorTexture")), image(normals), normals.get("scale").number(1));
    }

    private int image(Json texture) throws MeshException {
        if (!texture.isThere()) {
            return -1;
        }
        Json named = texture.get("index").in(file.array("textures"));
        sampler(named.get("sampler"));
        Json source = named.get("source");
        if (!source.isThere()) {
            notes.add("textures in formats of extensions");
            return -1;
        }
        return source.index(file.array("images"));
    }

    /** A texture here repeats and is smooth between its pixels. */
    private void sampler(Json index) throws MeshException {
        if (index.isThere()) {
            Json sampler = index.in(file.array("samplers"));
            boolean repeats = true;
            for (String wrap : List.of("wrapS", "wrapT")) {
                repeats &= sampler.get(wrap).whole(0, Integer.MAX_VALUE, REPEAT) == REPEAT;
            }
            notes.add("textures that end or turn back at their edges, repeated here", repeats ? 0 : 1);
            notes.add("textures with hard pixels, smooth here", sampler.get("magFilter").whole(0, Integer.MAX_VALUE, 0) == NEAREST ? 1 : 0);
        }
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

    /** The bytes of an image that is embedded. */
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
    public List<Path> bufferFiles() throws IOException, MeshException {
        List<Path> files = new ArrayList<>();
        Json buffers = file.array("buffers");
        for (int i = 0; i < buffers.size(); i++) {
            Json uri = buffers.at(i).get("uri");
            if (uri.isThere() && !uri.text().orElse("").startsWith("data:")) {
                files.add(file.buffers().beside(uri));
            }
        }
        return files;
    }
}

package lightning.format.assimp;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import lightning.base.file.RegularFile;
import lightning.base.math.Vec3;
import lightning.base.text.TextEncoding;
import org.lwjgl.assimp.AICamera;
import org.lwjgl.assimp.AIColor3D;
import org.lwjgl.assimp.AILight;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.AIVector3D;
import org.lwjgl.assimp.Assimp;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Lights and cameras of a scene, which Assimp's glTF lacks. Each belongs to the node of its name, and gets a child of that node. */
final class GlbLights {
    private static final JsonMapper JSON = new JsonMapper();
    private static final int HEADER_BYTES = 20;
    private static final int JSON_LENGTH_AT = 12;
    private static final String PUNCTUAL = "KHR_lights_punctual";
    /** Assimp's default for files that do not say: that of a picture with square pixels and this aspect ratio. */
    private static final double DEFAULT_ASPECT = 4.0 / 3;

    private final ObjectNode root;
    private final Map<String, Integer> notes = new TreeMap<>();

    /** True for FBX: cameras have half of their angle. */
    private final boolean hasHalfAngles;
    /** True for Collada: lights have their angle as the inner one. */
    private final boolean hasInnerAngles;

    private GlbLights(ObjectNode root, boolean hasHalfAngles, boolean hasInnerAngles) {
        this.root = root;
        this.hasHalfAngles = hasHalfAngles;
        this.hasInnerAngles = hasInnerAngles;
    }

    /**
     * Adds the lights and cameras to a written file; returns a line for each kind that glTF lacks: its name, a tab and its number.
     *
     * @param file   glTF in one file, as Assimp writes it
     * @param source file that the scene was read from
     */
    static List<String> add(Path file, AIScene scene, Path source) throws IOException {
        byte[] bytes = RegularFile.readBytes(file, "a converted file", Integer.MAX_VALUE - 8);
        ByteBuffer header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int length = header.getInt(JSON_LENGTH_AT);
        String content = TextEncoding.decode(Arrays.copyOfRange(bytes, HEADER_BYTES, HEADER_BYTES + length));
        String format = source.toString().toLowerCase(Locale.ROOT);
        var lights =
                new GlbLights((ObjectNode) JSON.readTree(content), format.endsWith(".fbx"), format.endsWith(".dae"));
        // Only a hint about polygons.
        lights.root.withArray("extensionsUsed").removeIf(name -> name.asString("").equals("FB_ngon_encoding"));
        lights.addLights(scene);
        lights.addCameras(scene);
        byte[] json = JSON.writeValueAsBytes(lights.root);
        byte[] padded = Arrays.copyOf(json, (json.length + 3) / 4 * 4);
        Arrays.fill(padded, json.length, padded.length, (byte) ' ');
        header.putInt(8, bytes.length - length + padded.length).putInt(JSON_LENGTH_AT, padded.length);
        try (var out = Files.newOutputStream(file)) {
            out.write(bytes, 0, HEADER_BYTES);
            out.write(padded);
            out.write(bytes, HEADER_BYTES + length, bytes.length - HEADER_BYTES - length);
        }
        return lights.notes.entrySet().stream().map(note -> note.getKey() + "\t" + note.getValue()).toList();
    }

    private void addLights(AIScene scene) {
        for (int i = 0; i < scene.mNumLights(); i++) {
            AILight light = AILight.create(requireNonNull(scene.mLights()).get(i));
            String type = switch (light.mType()) {
                case Assimp.aiLightSource_DIRECTIONAL -> "directional";
                case Assimp.aiLightSource_POINT -> "point";
                case Assimp.aiLightSource_SPOT -> "spot";
                default -> "";
            };
            if (type.isEmpty()) {
                note(light.mType() == Assimp.aiLightSource_AMBIENT ? "ambient lights" : "area lights");
                continue;
            }
            String name = light.mName().dataString();
            ObjectNode entry = JSON.createObjectNode().put("name", name).put("type", type);
            AIColor3D color = light.mColorDiffuse();
            boolean isInverseSquare = light.mAttenuationConstant() == 0 && light.mAttenuationLinear() == 0;
            if (!type.equals("directional") && !isInverseSquare) {
                note("attenuations of lights, imported as the inverse square");
            }
            double intensity = Math.max(color.r(), Math.max(color.g(), color.b()));
            double unit = intensity > 0 ? intensity : 1;
            entry.putArray("color").add(color.r() / unit).add(color.g() / unit).add(color.b() / unit);
            entry.put("intensity", intensity);
            if (type.equals("spot")) {
                double outer = Math.clamp(0.5 * (hasInnerAngles ? light.mAngleInnerCone() : light.mAngleOuterCone()), 0.001, 0.5 * Math.PI);
                entry.putObject("spot").put("outerConeAngle", outer)
                        .put("innerConeAngle", Math.clamp(0.5 * light.mAngleInnerCone(), 0, outer - 0.0005));
            }
            ArrayNode lights = root.withObject("extensions").withObject(PUNCTUAL).withArray("lights");
            ObjectNode node = place(name, vector(light.mPosition()), vector(light.mDirection()), vector(light.mUp()));
            node.putObject("extensions").putObject(PUNCTUAL).put("light", lights.size());
            lights.add(entry);
        }
        if (root.path("extensions").has(PUNCTUAL)) {
            root.withArray("extensionsUsed").add(PUNCTUAL);
        }
    }

    private void addCameras(AIScene scene) {
        for (int i = 0; i < scene.mNumCameras(); i++) {
            AICamera camera = AICamera.create(requireNonNull(scene.mCameras()).get(i));
            double width = camera.mHorizontalFOV() * (hasHalfAngles ? 2 : 1);
            if (!(width > 0 && width < Math.PI)) {
                note("cameras without an angle of view");
                continue;
            }
            String name = camera.mName().dataString();
            double aspect = camera.mAspect() > 0 ? camera.mAspect() : DEFAULT_ASPECT;
            ArrayNode cameras = root.withArray("cameras");
            ObjectNode node = place(name, vector(camera.mPosition()), vector(camera.mLookAt()), vector(camera.mUp()));
            node.put("camera", cameras.size());
            ObjectNode perspective = cameras.addObject().put("name", name).put("type", "perspective").putObject("perspective");
            perspective.put("yfov", 2 * Math.atan(Math.tan(0.5 * width) / aspect));
            if (camera.mAspect() > 0) {
                perspective.put("aspectRatio", aspect);
            }
        }
    }

    /** Adds a node that looks along a direction to the node of a name, or to the scene if there is none. */
    private ObjectNode place(String parent, Vec3 position, Vec3 direction, Vec3 up) {
        ArrayNode nodes = root.withArray("nodes");
        ObjectNode node = JSON.createObjectNode().put("name", parent);
        Vec3 back = direction.length() > 0 ? direction.normalized().times(-1) : new Vec3(0, 0, 1);
        Vec3 across = up.cross(back).length() > 1e-6 ? up.cross(back).normalized()
                : new Vec3(back.y() > 0.9 || back.y() < -0.9 ? 1 : 0, back.y() > 0.9 || back.y() < -0.9 ? 0 : 1, 0).cross(back)
                        .normalized();
        Vec3 top = back.cross(across);
        ArrayNode matrix = node.putArray("matrix");
        for (Vec3 column : new Vec3[] {across, top, back}) {
            matrix.add(column.x()).add(column.y()).add(column.z()).add(0);
        }
        matrix.add(position.x()).add(position.y()).add(position.z()).add(1);
        int index = nodes.size();
        for (int i = 0; i < index; i++) {
            if (nodes.get(i).path("name").asString("").equals(parent)) {
                ((ObjectNode) nodes.get(i)).withArray("children").add(index);
                nodes.add(node);
                return node;
            }
        }
        ((ObjectNode) root.withArray("scenes").get(0)).withArray("nodes").add(index);
        nodes.add(node);
        return node;
    }

    private void note(String kind) {
        notes.merge(kind, 1, Integer::sum);
    }

    private static Vec3 vector(AIVector3D v) {
        return new Vec3(v.x(), v.y(), v.z());
    }
}

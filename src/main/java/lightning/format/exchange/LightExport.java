package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfLightWriter;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightGroup;
import lightning.scene.Scene;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The lights of a scene for other programs: in a copy of the glTF file that they light, or as a plain JSON of all that they are.
 *
 * @param bytes what the file holds
 * @param notes what the format cannot say, each with its number
 */
public record LightExport(byte[] bytes, Map<String, Integer> notes) {
    private static final JsonMapper JSON = JsonMapper.builder().build();

    /**
     * A copy of a glTF file with these lights in place of its own. What glTF has no word for is in their extras, from where an import
     * restores it.
     *
     * @param units what the numbers of its lights shall be
     * @throws MeshException if it is no glTF file that can be read
     * @throws IOException   if it cannot be read
     */
    public static LightExport toGltf(Path gltf, Scene scene, LightUnits units, Progress progress) throws IOException, MeshException {
        var notes = new ConversionNotes();
        List<GltfLightWriter.PlacedLight> lights = new ArrayList<>();
        List<Light> effectiveLights = scene.rig().effectiveLights();
        for (int i = 0; i < effectiveLights.size(); i++) {
            Light effectiveLight = effectiveLights.get(i);
            // Those of the environment come last, and are lights of no block.
            Light light = i < scene.lights().size() ? scene.lights().get(i) : effectiveLight;
            notes.add("lights that are dark, which shine there", scene.isActive(effectiveLight) ? 0 : 1);
            lights.add(new GltfLightWriter.PlacedLight(
                    PunctualLightExport.convert(effectiveLight, units, LightSettings.toJson(light, scene.rig(), units), notes),
                    effectiveLight.position(), effectiveLight.direction().normalized()));
        }
        return new LightExport(GltfLightWriter.replaceLights(gltf, lights, progress), Map.copyOf(notes.counts()));
    }

    /** A list of all lights and banks with all that a scene says of them. */
    public static LightExport toJson(Scene scene) {
        ObjectNode root = JSON.createObjectNode();
        ArrayNode lights = root.putArray("lights");
        for (Light light : scene.lights()) {
            AttributeJson.write(lights.addObject().put("name", light.name()), light, LightAttribute.ALL);
        }
        ArrayNode groups = root.putArray("banks");
        for (LightGroup group : scene.rig().lightGroups()) {
            AttributeJson.write(groups.addObject().put("name", group.name()), group, LightGroup.ATTRIBUTES);
        }
        return new LightExport(JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root), Map.of());
    }
}

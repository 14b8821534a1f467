package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfLights;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import lightning.scene.Bank;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
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
public record LightsBack(byte[] bytes, Map<String, Integer> notes) {
    private static final JsonMapper JSON = JsonMapper.builder().build();

    /**
     * A copy of a glTF file with these lights in place of its own. What glTF has no word for is in their extras, from where an import
     * restores it.
     *
     * @param units what the numbers of its lights shall be
     * @throws MeshException if it is no glTF file that can be read
     * @throws IOException   if it cannot be read
     */
    public static LightsBack into(Path gltf, Scene scene, LightUnits units, Progress progress) throws IOException, MeshException {
        var notes = new Notes();
        List<GltfLights.Placed> lights = new ArrayList<>();
        List<Light> acting = scene.rig().actingLights();
        for (int i = 0; i < acting.size(); i++) {
            Light shown = acting.get(i);
            // Those of the environment come last, and are lights of no block.
            Light light = i < scene.lights().size() ? scene.lights().get(i) : shown;
            notes.add("lights that are dark, which shine there", scene.shines(shown) ? 0 : 1);
            lights.add(new GltfLights.Placed(PunctualLight.of(shown, units, LightSettings.of(light, scene.rig(), units), notes),
                    shown.position(), shown.direction().normalized()));
        }
        return new LightsBack(GltfLights.replaced(gltf, lights, progress), Map.copyOf(notes.counts()));
    }

    /** A list of all lights and banks with all that a scene says of them. */
    public static LightsBack json(Scene scene) {
        ObjectNode root = JSON.createObjectNode();
        ArrayNode lights = root.putArray("lights");
        for (Light light : scene.lights()) {
            AttributeJson.write(lights.addObject().put("name", light.name()), light, LightAttribute.ALL);
        }
        ArrayNode banks = root.putArray("banks");
        for (Bank bank : scene.rig().banks()) {
            AttributeJson.write(banks.addObject().put("name", bank.name()), bank, Bank.ATTRIBUTES);
        }
        return new LightsBack(JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root), Map.of());
    }
}

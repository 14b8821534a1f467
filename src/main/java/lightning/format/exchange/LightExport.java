package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.exchange.json.DomeJson;
import lightning.format.exchange.json.MaterialExtras;
import lightning.format.exchange.json.PictureJson;
import lightning.format.exchange.json.TransformJson;
import lightning.format.exchange.usd.UsdLightExport;
import lightning.format.gltf.GltfLightWriter;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Emission;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.AnimatedScene;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Lights of a scene for other programs: in a copy of the glTF file that they light, as a layer of a USD stage, or as JSON. */
public final class LightExport {
    /** Key of a light's intensity without its unit, so that readers need no photometry. */
    static final String RELATIVE_INTENSITY = "relative_intensity";
    private static final String DOMES = "domes, whose light is sample lights and whose images are left out";
    private static final JsonMapper JSON = JsonMapper.builder().build();

    private LightExport() {}

    /**
     * Returns a copy of a glTF file in which these lights replace its own. Properties that glTF does not support are stored
     * in their extras, from which an import restores them.
     *
     * @param units light units of the output
     * @throws MeshException if the file is not a valid glTF file
     * @throws IOException if it cannot be read
     */
    public static ExportedLights toGltf(Path gltf, Scene scene, LightUnits units, Progress progress) throws IOException, MeshException {
        var notes = new ConversionNotes();
        List<GltfLightWriter.PlacedLight> lights = new ArrayList<>();
        List<Light> effectiveLights = scene.lightsForOtherPrograms();
        for (int i = 0; i < effectiveLights.size(); i++) {
            Light effectiveLight = effectiveLights.get(i);
            // Environment lights come last; they have no block in the scene file.
            Light light = i < scene.lights().size() ? scene.lights().get(i) : effectiveLight;
            notes.add("lights that are off, exported as on", scene.isActive(effectiveLight) ? 0 : 1);
            lights.add(new GltfLightWriter.PlacedLight(
                    PunctualLightExport.convert(effectiveLight, units, LightSettings.toJson(light, scene.rig(), units), notes),
                    effectiveLight.position(), effectiveLight.direction().normalized()));
        }
        notes.add(DOMES, (int) scene.world().named().stream().filter(d -> d.on() && d.image().isPresent()).count());
        return new ExportedLights(GltfLightWriter.replaceLights(gltf, lights, progress), Map.of(), Map.copyOf(notes.counts()));
    }

    /**
     * Returns a layer of a USD stage with these lights: changes of the lights that were imported, and definitions of new ones.
     *
     * @param text text of the scene file, which says where the lights are in the stage
     * @param sceneFile the scene file
     * @param output file of the layer
     * @throws IOException if the folders of the lights' files cannot be read
     */
    public static ExportedLights toUsd(String text, AnimatedScene scene, Path sceneFile, Path output) throws IOException {
        return UsdLightExport.export(text, scene, sceneFile, output);
    }

    /**
     * Returns JSON with all lights, light groups and materials of a scene, its picture, world and camera, with all their attributes, the
     * transforms of its objects and outermost groups, what is animated at each frame, and the keywords of the materials' attributes that
     * cannot come back as edits.
     */
    public static ExportedLights toJson(AnimatedScene animated) {
        Scene scene = animated.base();
        ObjectNode root = JSON.createObjectNode();
        ArrayNode lights = root.putArray("lights");
        for (Light light : scene.lights()) {
            ObjectNode json = lights.addObject().put("name", light.name());
            AttributeJson.write(json, light, LightAttribute.ALL);
            json.put(RELATIVE_INTENSITY, relativeIntensity(light, scene));
        }
        ArrayNode groups = root.putArray("banks");
        for (LightGroup group : scene.rig().lightGroups()) {
            AttributeJson.write(groups.addObject().put("name", group.name()), group, LightGroup.ATTRIBUTES);
        }
        PictureJson.write(root.putObject("picture"), scene.picture());
        AttributeJson.write(root.putObject("world"), scene.world(), World.ATTRIBUTES);
        DomeJson.write(root, scene.world());
        AttributeJson.write(root.putObject("camera"), scene.camera(), Camera.ATTRIBUTES);
        ArrayNode objects = root.putArray("objects");
        for (SceneNode node : scene.stage().nodes()) {
            ObjectNode json = objects.addObject().put("name", node.name()).put("visible", node.visible());
            TransformJson.write(json.putArray("matrix"), node);
        }
        ArrayNode materials = root.putArray("materials");
        for (Material material : scene.materials()) {
            AttributeJson.write(materials.addObject().put("name", material.name()), material, MaterialAttribute.ALL);
        }
        MaterialExtras.NAMES.forEach(root.putArray("materialNames")::add);
        var notes = new ConversionNotes();
        animated.shot().ifPresent(shot -> new ShotValues(animated, shot, notes).write(root.putObject("shot")));
        return new ExportedLights(JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root), Map.of(), Map.copyOf(notes.counts()));
    }

    static double relativeIntensity(Light light, Scene scene) {
        return Emission.withUnit(light, IntensityUnit.RELATIVE, scene.world().meters()).intensity();
    }
}

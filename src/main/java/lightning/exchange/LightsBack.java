package lightning.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.gltf.GltfLight;
import lightning.gltf.GltfLights;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.mesh.MeshException;
import lightning.mesh.Notes;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.work.Progress;
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
    /** glTF wants the inner angle below the outer one. */
    private static final double SHARPEST = 1 - 1e-6;

    /**
     * A copy of a glTF file with these lights in place of its own.
     *
     * @param units what the numbers of its lights shall be
     * @throws MeshException if it is no glTF file that can be read
     * @throws IOException   if it cannot be read
     */
    public static LightsBack into(Path gltf, Scene scene, LightUnits units, Progress progress) throws IOException, MeshException {
        var notes = new Notes();
        List<GltfLights.Placed> lights = new ArrayList<>();
        for (Light light : scene.rig().actingLights()) {
            lights.add(placed(light, scene.shines(light), units, notes));
        }
        return new LightsBack(GltfLights.replaced(gltf, lights, progress), Map.copyOf(notes.counts()));
    }

    /** A list of all lights with all that a scene says of them. */
    public static LightsBack json(Scene scene) {
        ArrayNode list = JSON.createArrayNode();
        for (Light light : scene.lights()) {
            ObjectNode out = list.addObject().put("name", light.name()).put("type", light.type().name().toLowerCase(Locale.ROOT));
            vector(out, "color", new Vec3(light.color().r(), light.color().g(), light.color().b()));
            out.put("intensity", light.intensity());
            vector(out, "at", light.position());
            vector(out, "direction", light.direction());
            vector(out, "attenuation",
                    new Vec3(light.attenuation().constant(), light.attenuation().linear(), light.attenuation().quadratic()));
            out.put("radius", light.area().radius()).put("spread", light.area().spread());
            out.put("width", light.area().width()).put("height", light.area().height());
            vector(out, "up", light.area().up());
            out.put("samples", light.area().samples());
            out.put("angle", light.angle()).put("dropoff", light.dropoff());
            out.putArray("doors").add(light.doors().left()).add(light.doors().right()).add(light.doors().bottom()).add(light.doors().top());
            light.gobo().ifPresent(gobo -> out.put("gobo", gobo.file()));
            light.profile().ifPresent(profile -> out.put("profile", profile.file()));
            out.put("feather", light.feather()).put("on", light.on()).put("solo", light.solo()).put("bank", light.bank());
        }
        ObjectNode root = JSON.createObjectNode();
        root.set("lights", list);
        return new LightsBack(JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(root), Map.of());
    }

    private static void vector(ObjectNode out, String name, Vec3 v) {
        out.putArray(name).add(v.x()).add(v.y()).add(v.z());
    }

    private static GltfLights.Placed placed(Light light, boolean shines, LightUnits units, Notes notes) {
        LightType type = light.type();
        double most = Math.max(light.color().max(), 1);
        Rgb color = light.color().times(1 / most);
        notes.add("lights that are dark, which have intensity 0", shines ? 0 : 1);
        double intensity = shines ? most * light.intensity() * strength(light, notes) / units.intensityOfOne(type) : 0;
        double outer = Math.toRadians(type.isSurface() ? 90 : Math.min(light.angle(), 90));
        notes.add("lights that are larger than a point, which are one there", light.isArea() ? 1 : 0);
        notes.add("spots wider than 90 degrees", type.hasCone() && light.angle() > 90 ? 1 : 0);
        notes.add("edges of spots, which fade otherwise there", type.hasCone() && light.dropoff() > 0 || type.isSurface() ? 1 : 0);
        double dropoff = type.isSurface() ? 1 : light.dropoff();
        notes.add("barn doors", LightAttribute.DOORS.acts(type) && !light.doors().isOpen() ? 1 : 0);
        notes.add("gobos", type.hasCone() && light.gobo().isPresent() ? 1 : 0);
        notes.add("profiles", LightAttribute.PROFILE.acts(type) && light.profile().isPresent() ? 1 : 0);
        GltfLight.Type kind = switch (type) {
            case DIRECTIONAL -> GltfLight.Type.DIRECTIONAL;
            case POINT -> GltfLight.Type.POINT;
            case SPOT, RECT, DISC -> GltfLight.Type.SPOT;
        };
        return new GltfLights.Placed(new GltfLight(0, light.name(), kind, color, intensity, inner(dropoff, outer), outer, false),
                light.position(), light.direction().normalized());
    }

    /** What of it is left at distance 1: there the light falls with the square of the distance, whatever it does here. */
    private static double strength(Light light, Notes notes) {
        if (!light.type().hasPosition()) {
            return 1;
        }
        var a = light.attenuation();
        notes.add("lights that do not fall off with the square of the distance; theirs is right at distance 1", a.constant() == 0
                && a.linear() == 0 && a.quadratic() > 0 ? 0 : 1);
        double sum = a.constant() + a.linear() + a.quadratic();
        return a.constant() == 0 && a.linear() == 0 && sum > 0 ? 1 / sum : Math.min(1 / sum, 1);
    }

    /** The inner angle with which a spot is half as bright where it is here; see {@code GltfImport}. */
    private static double inner(double dropoff, double outer) {
        double half = dropoff == 0 ? Math.cos(outer) : Math.pow(0.5, 1 / dropoff);
        double edge = Math.cos(outer);
        return half <= edge ? outer * SHARPEST : Math.acos(Math.min(1, edge + (half - edge) / Math.sqrt(0.5)));
    }
}

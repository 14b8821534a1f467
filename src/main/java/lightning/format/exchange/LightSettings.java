package lightning.format.exchange;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.gltf.GltfLight;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * All that a scene says of a light, in the {@code extras} of the light that glTF has in its place. What glTF has too counts as glTF says it
 * where another program changed it since.
 */
final class LightSettings {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String UNITS_KEY = "light_units";
    private static final String LIGHT_GROUP_KEY = "bank_settings";
    /** Files hold floats. */
    private static final double TOLERANCE = 1e-5;

    private final SceneAssembler assembler;
    private final Map<String, LightGroup> lightGroups = new HashMap<>();

    /** @param assembler gets the light groups, and the notes of what cannot be restored */
    LightSettings(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /**
     * What goes into the extras.
     *
     * @param units what the numbers of glTF are
     */
    static ObjectNode toJson(Light light, LightRig rig, LightUnits units) {
        ObjectNode out = JSON.createObjectNode().put(UNITS_KEY, units.name().toLowerCase(Locale.ROOT));
        AttributeJson.write(out, light, LightAttribute.ALL);
        rig.lightGroup(light.lightGroup())
                .ifPresent(group -> AttributeJson.write(out.putObject(LIGHT_GROUP_KEY), group, LightGroup.ATTRIBUTES));
        return out;
    }

    /**
     * The light that was written, where glTF's still is what was written of it.
     *
     * @param imported  as glTF says it
     * @param gltfLight what glTF says
     * @return {@code imported} itself where this program did not write it
     */
    Light restore(Light imported, GltfLight gltfLight) {
        JsonNode settings = gltfLight.settings();
        Optional<LightUnits> units = Stream.of(LightUnits.values())
                .filter(u -> settings.path(UNITS_KEY).asString("").equals(u.name().toLowerCase(Locale.ROOT))).findFirst();
        if (units.isEmpty()) {
            return imported;
        }
        Light stored = AttributeJson.read(settings, imported, LightAttribute.ALL, assembler::hasFile, _ -> noteUnusable());
        Optional<LightGroup> group = lightGroup(stored, settings.path(LIGHT_GROUP_KEY));
        GltfLight exported =
                PunctualLightExport.convert(group.map(b -> LightRig.of(List.of(stored), List.of(b)).effectiveLight(stored)).orElse(stored),
                        units.get(), settings, new ConversionNotes());
        Light light = stored;
        if (!isSameShape(exported, gltfLight)) {
            light = light.withType(imported.type()).withAngle(imported.angle()).withDropoff(imported.dropoff());
        }
        if (imported.type().hasPosition() && !isNear(imported.position(), stored.position(), Math.max(1, imported.position().maxAbs()))) {
            light = light.withPosition(imported.position());
        }
        if (imported.type().hasDirection() && !isNear(imported.direction().normalized(), stored.direction().normalized(), 1)) {
            light = light.withDirection(imported.direction());
        }
        if (!isSameIntensity(exported, gltfLight)) {
            return light.withColor(imported.color()).withIntensity(imported.intensity()).withAttenuation(imported.attenuation())
                    .withLightGroup("");
        }
        assembler.restoredLights.add(imported.name());
        return group.isEmpty() ? light.withLightGroup("") : light.withLightGroup(addLightGroup(group.get()));
    }

    private void noteUnusable() {
        assembler.notes.add("settings of lights that cannot be used here");
    }

    private Optional<LightGroup> lightGroup(Light stored, JsonNode settings) {
        return stored.lightGroup().isEmpty() ? Optional.empty()
                : Optional.of(AttributeJson.read(settings, LightGroup.of(stored.lightGroup()), LightGroup.ATTRIBUTES, assembler::hasFile,
                        _ -> noteUnusable()));
    }

    /** The name of the scene's bank; the first of a name stands for the others. */
    private String addLightGroup(LightGroup group) {
        return lightGroups.computeIfAbsent(group.name(), name -> {
            LightGroup unique = group.withName(assembler.names.unique(name, "bank"));
            assembler.lightGroups.add(unique);
            return unique;
        }).name();
    }

    private static boolean isSameShape(GltfLight a, GltfLight b) {
        return a.type() == b.type()
                && (a.type() != GltfLight.Type.SPOT || isNear(a.innerAngle(), b.innerAngle()) && isNear(a.outerAngle(), b.outerAngle()));
    }

    private static boolean isSameIntensity(GltfLight a, GltfLight b) {
        Rgb one = a.color().times(a.intensity());
        Rgb other = b.color().times(b.intensity());
        return isNear(one.r(), other.r()) && isNear(one.g(), other.g()) && isNear(one.b(), other.b());
    }

    private static boolean isNear(double a, double b) {
        return Math.abs(a - b) <= TOLERANCE * Math.max(Math.abs(a), Math.abs(b));
    }

    private static boolean isNear(Vec3 a, Vec3 b, double scale) {
        return a.minus(b).maxAbs() <= TOLERANCE * scale;
    }
}

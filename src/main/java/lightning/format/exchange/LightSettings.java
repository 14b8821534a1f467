package lightning.format.exchange;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.gltf.GltfLight;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Complete settings of a light in the {@code extras} of its glTF light. If another program changed a glTF property since,
 * the glTF value takes precedence.
 */
final class LightSettings {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String UNITS_KEY = "light_units";
    private static final String LIGHT_GROUP_KEY = "bank_settings";
    /** The light that was exported in the place of an object's; it depends on the object's surface. */
    private static final String EFFECTIVE_KEY = "effective";
    /** Tolerance for comparisons, since glTF files contain floats. */
    private static final double TOLERANCE = 1e-5;

    private final SceneAssembler assembler;
    private final Map<String, LightGroup> lightGroups = new HashMap<>();

    /**
     * Creates a reader.
     *
     * @param assembler receives the light groups, and notes on settings that cannot be restored
     */
    LightSettings(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /**
     * Returns the content of the extras.
     *
     * @param units light units of the glTF file
     */
    static ObjectNode toJson(Light light, LightRig rig, LightUnits units) {
        ObjectNode out = JSON.createObjectNode().put(UNITS_KEY, units.name().toLowerCase(Locale.ROOT));
        AttributeJson.write(out, rig.inMeters(light), LightAttribute.ALL);
        if (light.type() == LightType.OBJECT) {
            AttributeJson.write(out.putObject(EFFECTIVE_KEY), rig.effectiveLight(light), LightAttribute.ALL);
        }
        rig.lightGroup(light.lightGroup())
                .ifPresent(group -> AttributeJson.write(out.putObject(LIGHT_GROUP_KEY), group, LightGroup.ATTRIBUTES));
        return out;
    }

    /**
     * Returns the original light, with glTF properties that changed since the export.
     *
     * @param imported light converted from glTF alone
     * @param gltfLight the glTF light with its settings
     * @return the restored light; {@code imported} itself if this program did not write it
     */
    Light restore(Light imported, GltfLight gltfLight) {
        JsonNode settings = gltfLight.settings();
        Optional<LightUnits> units = Stream.of(LightUnits.values())
                .filter(u -> settings.path(UNITS_KEY).asString("").equals(u.name().toLowerCase(Locale.ROOT))).findFirst();
        if (units.isEmpty()) {
            return imported;
        }
        Light stored = AttributeJson.read(settings, imported.withProfile(Optional.empty()), LightAttribute.ALL, assembler::hasFile,
                _ -> noteUnusable());
        Optional<LightGroup> group = lightGroup(stored, settings.path(LIGHT_GROUP_KEY));
        Light effective = effective(stored, group, settings.path(EFFECTIVE_KEY));
        GltfLight exported = PunctualLightExport.convert(effective, units.get(), settings, new ConversionNotes());
        Light light = stored;
        if (!isSameShape(exported, gltfLight)) {
            light = light.withType(imported.type()).withAngle(imported.angle()).withDropoff(imported.dropoff())
                    .withProfile(imported.profile());
        }
        if (imported.type().hasPosition()
                && !isNear(imported.position(), effective.position(), Math.max(1, imported.position().maxAbs()))) {
            light = light.withPosition(imported.position());
        }
        if (imported.type().hasDirection() && !isNear(imported.direction().normalized(), stored.direction().normalized(), 1)) {
            light = light.withDirection(imported.direction());
        }
        if (!isSameIntensity(exported, gltfLight)) {
            return light.withColor(imported.color()).withIntensity(imported.intensity()).withEmission(imported.emission())
                    .withFalloff(imported.falloff()).withAttenuation(imported.attenuation()).withLightGroup("");
        }
        assembler.restoredLights.add(imported.name());
        return group.isEmpty() ? light.withLightGroup("") : light.withLightGroup(addLightGroup(group.get()));
    }

    private Light effective(Light stored, Optional<LightGroup> group, JsonNode effective) {
        return effective.isObject()
                ? AttributeJson.read(effective, stored, LightAttribute.ALL, assembler::hasFile, _ -> noteUnusable())
                : LightRig.of(List.of(stored.withLightGroup(group.isPresent() ? stored.lightGroup() : "")), group.stream().toList())
                        .effectiveLights().getFirst();
    }

    private void noteUnusable() {
        assembler.notes.add("light settings that cannot be restored");
    }

    private Optional<LightGroup> lightGroup(Light stored, JsonNode settings) {
        return stored.lightGroup().isEmpty() ? Optional.empty()
                : Optional.of(AttributeJson.read(settings, LightGroup.of(stored.lightGroup()), LightGroup.ATTRIBUTES, assembler::hasFile,
                        _ -> noteUnusable()));
    }

    /** Adds a light group and returns its name in the scene; the first group of a name represents all. */
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

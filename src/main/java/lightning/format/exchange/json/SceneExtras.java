package lightning.format.exchange.json;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;
import lightning.base.text.RefusalException;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.Camera;
import lightning.scene.LensAttributes;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import tools.jackson.databind.JsonNode;

/**
 * Settings in the {@code extras} of a glTF file's root, under {@code lightning}: what glTF cannot represent. The Blender add-on writes them;
 * docs/pipeline.md describes them. Values that cannot be used are noted and left out.
 *
 * @param json the settings; a missing node if the file has none
 */
public record SceneExtras(JsonNode json) {
    /** Note about a lens shift that no camera can have. */
    public static final String INVALID_SHIFT =
            "lens shifts beyond " + SceneLimits.format(SceneLimits.MAX_SHIFT) + " pictures, imported without shift";

    private static final Pattern SENDER = Pattern.compile("[0-9a-f]{32}");

    /** Returns the name of the active camera's node; empty for the first camera. */
    public String camera() {
        return json.path("camera").asString("");
    }

    /** Returns whether they have an animation. */
    public boolean hasShot() {
        return json.path("shot").isObject();
    }

    /** Returns the distance of the active camera's target; empty for one as far as the objects. */
    public OptionalDouble cameraDistance() {
        double distance = json.path("distance").asDouble(0);
        return distance > 0 && Double.isFinite(distance) ? OptionalDouble.of(distance) : OptionalDouble.empty();
    }

    /** Returns the lens shift of the active camera; none, with a note, if no camera can have it. */
    public LensShift cameraShift(ConversionNotes notes) {
        JsonNode shift = json.path("shift");
        double x = shift.path(0).asDouble(0);
        double y = shift.path(1).asDouble(0);
        if (LensShift.isValid(x, y)) {
            return new LensShift(x, y);
        }
        notes.add(INVALID_SHIFT);
        return LensShift.NONE;
    }

    /** Returns the active camera with its lens; a pinhole if the settings have none. */
    public Camera withLens(Camera camera, ConversionNotes notes) {
        return AttributeJson.read(json.path("lens"), camera, LensAttributes.ALL, (_, _) -> false,
                _ -> notes.add("scene settings that cannot be restored"));
    }

    /**
     * Sets the scene's picture, world, edits of materials, light groups, lights and animation, and a comment with the scene that it was sent from. Lights count only if the file has none of its own, so that
     * lights that were exported into it later win.
     *
     * @param nodeNames names in the scene of the file's nodes
     */
    public void apply(SceneAssembler assembler, Map<String, String> nodeNames) {
        assembler.picture = PictureJson.read(json.path("picture"), assembler.picture, _ -> noteUnusable(assembler));
        assembler.world = AttributeJson.read(json.path("world"), assembler.world, World.ATTRIBUTES, assembler::hasOrCopiesFile,
                _ -> noteUnusable(assembler));
        DomeJson.read(json, assembler, () -> noteUnusable(assembler));
        MaterialExtras.apply(json.path("materials"), assembler.materials, () -> noteUnusable(assembler));
        assembler.isLit = json.path("lights").isArray();
        if (assembler.lights.isEmpty()) {
            Set<String> groups = new HashSet<>();
            for (JsonNode group : json.path("banks")) {
                readGroup(assembler, group).ifPresent(groups::add);
            }
            for (JsonNode light : json.path("lights")) {
                readLight(assembler, light, nodeNames, groups);
            }
        }
        String sender = json.path("id").asString("");
        if (SENDER.matcher(sender).matches()) {
            assembler.addComment("sent from: " + sender);
        }
        if (hasShot()) {
            assembler.shot = new ShotExtras(json.path("shot"), nodeNames, assembler.notes).read();
        }
    }

    private static void noteUnusable(SceneAssembler assembler) {
        assembler.notes.add("scene settings that cannot be restored");
    }

    private static Optional<String> readGroup(SceneAssembler assembler, JsonNode in) {
        try {
            LightGroup group = AttributeJson.read(in, LightGroup.of(in.path("name").asString("")), LightGroup.ATTRIBUTES,
                    assembler::hasOrCopiesFile, _ -> noteUnusable(assembler));
            if (assembler.names.unique(group.name(), "bank").equals(group.name())) {
                assembler.lightGroups.add(group);
                return Optional.of(group.name());
            }
        } catch (RefusalException e) {
            // Noted below, like a name that another object has.
        }
        noteUnusable(assembler);
        return Optional.empty();
    }

    private static void readLight(SceneAssembler assembler, JsonNode in, Map<String, String> nodeNames, Set<String> groups) {
        try {
            Light blank = Light.of(assembler.names.unique(in.path("name").asString(""), "light"), LightType.POINT);
            Light light = AttributeJson.read(in, blank, LightAttribute.ALL, assembler::hasOrCopiesFile, _ -> noteUnusable(assembler));
            assembler.lights.add(light.withIlluminates(renamed(light.illuminates(), nodeNames))
                    .withShadowedBy(renamed(light.shadowedBy(), nodeNames))
                    .withInfluence(light.influence().withGains(renamed(light.influence().gains(), nodeNames)))
                    .withLightGroup(groups.contains(light.lightGroup()) ? light.lightGroup() : ""));
            assembler.restoredLights.add(light.name());
        } catch (RefusalException e) {
            noteUnusable(assembler);
        }
    }

    private static ShapeLinks renamed(ShapeLinks links, Map<String, String> nodeNames) {
        return new ShapeLinks(links.exclusive(), links.names().stream().map(n -> nodeNames.getOrDefault(n, n)).toList());
    }

    private static ShapeGains renamed(ShapeGains gains, Map<String, String> nodeNames) {
        List<ShapeGains.Entry> entries = new ArrayList<>();
        gains.entries().forEach(e -> entries.add(new ShapeGains.Entry(nodeNames.getOrDefault(e.name(), e.name()), e.gain())));
        return new ShapeGains(entries);
    }
}

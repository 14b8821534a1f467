package lightning.format.exchange.usd;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.file.ContentHash;
import lightning.base.math.Transform;
import lightning.base.text.RefusalException;
import lightning.format.exchange.json.AttributeJson;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A light as it was imported, by which an export finds what has been edited. A comment of the scene file stores it as JSON.
 *
 * @param light  the light; its files are placeholders
 * @param tracks hash of the keyframes of each animated attribute, by its name
 * @param stage  values of the prim that the light does not have
 */
public record UsdOriginal(Light light, Map<String, String> tracks, JsonNode stage) {
    /** Start of the comment. */
    static final String COMMENT = "usd values: ";
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final int HASH_LENGTH = 16;
    private static final int MATRIX_SIZE = 16;

    /** Returns the values of a prim that its light in the scene does not have; defaults are left out. */
    static ObjectNode stage(JsonValue in) throws MeshException {
        ObjectNode out = JSON.createObjectNode();
        JsonValue rig = in.get("rig");
        for (String flag : List.of("normalize", "treatAsPoint")) {
            if (in.get(flag).bool(false)) {
                out.put(flag, true);
            }
        }
        for (String flag : List.of("moves", "resets", "shared", "switched")) {
            if (rig.get(flag).bool(false)) {
                out.put(flag, true);
            }
        }
        put(out, "exposure", in.get("exposure").number(0));
        put(out, "radius", in.get("radius").number(0));
        put(out, "softness", in.get("shaping").isPresent() ? in.get("shaping").get("softness").number(0) : 0);
        matrix(out, "matrix", in.get("matrix"));
        matrix(out, "inverse", rig.get("inverse"));
        for (String list : List.of("apis", "instances", "animated", "hiders")) {
            JsonNode values = rig.get(list).node();
            if (!values.isEmpty()) {
                out.set(list, values);
            }
        }
        return out;
    }

    private static void put(ObjectNode out, String key, double value) {
        if (value != 0) {
            out.put(key, UsdNumbers.tidy(value));
        }
    }

    private static void matrix(ObjectNode out, String key, JsonValue in) throws MeshException {
        if (in.isPresent()) {
            ArrayNode numbers = out.putArray(key);
            for (double v : in.numbers(new double[MATRIX_SIZE])) {
                if (v == Math.rint(v) && Math.abs(v) < 1e6) {
                    numbers.add((int) v);
                } else {
                    numbers.add(v);
                }
            }
        }
    }

    /** Returns the comment of a light. */
    static String comment(Light light, Optional<Shot> shot, ObjectNode stage) {
        ObjectNode out = JSON.createObjectNode().put("name", light.name());
        ObjectNode initial = JSON.createObjectNode();
        AttributeJson.write(initial, Light.of(light.name(), LightType.POINT), LightAttribute.ALL);
        ObjectNode values = JSON.createObjectNode();
        AttributeJson.write(values, light, LightAttribute.ALL);
        ObjectNode set = out.putObject("light");
        values.properties().stream().filter(e -> !e.getValue().equals(initial.get(e.getKey())))
                .forEach(e -> set.set(e.getKey(), e.getValue()));
        Map<String, String> tracks = hashes(light.name(), shot);
        if (!tracks.isEmpty()) {
            tracks.forEach(out.putObject("tracks")::put);
        }
        return COMMENT + out.set("stage", stage);
    }

    /** Returns what a comment says; empty if it has been damaged. */
    static Optional<UsdOriginal> parse(String comment) {
        try {
            JsonNode in = JSON.readTree(comment.substring(COMMENT.length()));
            String name = in.path("name").asString("");
            List<String> problems = new ArrayList<>();
            Light light = AttributeJson.read(in.path("light"), Light.of(name, LightType.POINT), LightAttribute.ALL, (_, _) -> true,
                    problems::add);
            Map<String, String> tracks = new LinkedHashMap<>();
            in.path("tracks").properties().forEach(e -> tracks.put(e.getKey(), e.getValue().asString("")));
            var original = new UsdOriginal(light, tracks, in.path("stage"));
            return problems.isEmpty() && in.path("light").isObject() && original.transform("matrix").isPresent() ? Optional.of(original)
                    : Optional.empty();
        } catch (JacksonException | RefusalException e) {
            return Optional.empty();
        }
    }

    /** Returns a hash of the keyframes of each animated attribute of a light. */
    static Map<String, String> hashes(String light, Optional<Shot> shot) {
        Map<String, String> result = new LinkedHashMap<>();
        for (Track track : shot.map(Shot::tracks).orElse(List.of())) {
            if (track.target().equals(new SceneElement.OfLight(light))) {
                String keys = track.keys().stream().map(UsdOriginal::text).collect(Collectors.joining("; "));
                result.put(track.attribute(), ContentHash.of(keys.getBytes(UTF_8)).hex().substring(0, HASH_LENGTH));
            }
        }
        return result;
    }

    private static String text(Keyframe key) {
        String value = switch (key.value()) {
            case KeyframeValue.Numbers n -> n.values().toString();
            case KeyframeValue.Word w -> w.text();
        };
        return key.frame() + " " + value + " " + key.interpolation();
    }

    /** Returns a transform of the prim; empty if it has none. */
    private Optional<Transform> transform(String key) {
        JsonNode in = stage.path(key);
        double[] m = new double[MATRIX_SIZE];
        for (int i = 0; i < MATRIX_SIZE; i++) {
            m[i] = in.path(i).asDouble(Double.NaN);
            if (!Double.isFinite(m[i])) {
                return Optional.empty();
            }
        }
        return Optional.of(UsdStage.transform(m));
    }

    /** Returns the transform of the prim in the stage. */
    Transform world() {
        return transform("matrix").orElse(Transform.IDENTITY);
    }

    /** Returns the transform from the stage to the parent of the prim; empty if it moves or cannot be inverted. */
    Optional<Transform> worldToParent() {
        return stage.path("moves").asBoolean(false) ? Optional.empty() : transform("inverse");
    }

    /** Returns whether the transform of the prim is without that of its parent. */
    public boolean resetsTransform() {
        return stage.path("resets").asBoolean(false);
    }

    /** Returns whether several lights of the scene are copies of the prim, by a point instancer. */
    public boolean isShared() {
        return stage.path("shared").asBoolean(false);
    }

    boolean isNormalized() {
        return stage.path("normalize").asBoolean(false);
    }

    boolean isTreatedAsPoint() {
        return stage.path("treatAsPoint").asBoolean(false);
    }

    double exposure() {
        return stage.path("exposure").asDouble(0);
    }

    double radius() {
        return stage.path("radius").asDouble(0);
    }

    double softness() {
        return stage.path("softness").asDouble(0);
    }

    /** Returns whether the prim has a schema such as ShadowAPI. */
    public boolean hasSchema(String name) {
        return stage.path("apis").valueStream().anyMatch(v -> v.asString("").equals(name));
    }

    /** Returns whether the stage animates an attribute of which the scene has only one frame. */
    boolean isAnimated(String declaration) {
        String name = declaration.substring(declaration.indexOf(' ') + 1);
        boolean isTransform = declaration.equals(UsdLightValues.MATRIX);
        return stage.path("animated").valueStream().map(v -> v.asString(""))
                .anyMatch(v -> isTransform ? v.startsWith("xformOp:") : v.equals(name));
    }

    /** Returns the paths of prims above that are invisible or below such a prim, the outermost first; empty if none hides the light. */
    List<String> hiders() {
        return stage.path("hiders").valueStream().map(v -> v.asString("")).toList();
    }

    /** Returns whether prims above hide the light at some times only. */
    boolean isSwitched() {
        return stage.path("switched").asBoolean(false);
    }

    /** Returns the paths of the instances in which the prim is, the outermost first. */
    public List<String> instances() {
        return stage.path("instances").valueStream().map(v -> v.asString("")).filter(UsdPaths::isWritable).toList();
    }
}

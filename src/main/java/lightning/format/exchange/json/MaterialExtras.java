package lightning.format.exchange.json;

import java.util.List;
import lightning.scene.attribute.ValueKind;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Edits of materials in the extras of a glTF file: {@code [{"name": …, "edits": {"shininess": [16, 40]}}]}, each with the value before and
 * after. They belong to materials that went to another program and came back, and which that program cannot hold. An edit counts only if the
 * file still gives the value before, so that a later change in the other program wins. Files and names of lights cannot be edited.
 */
public final class MaterialExtras {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final List<MaterialAttribute<?>> EDITABLE =
            MaterialAttribute.ALL.stream().filter(attribute -> !hasNames(attribute)).toList();
    /** Keywords of the attributes that cannot be edited, because their values are names of files or lights. */
    public static final List<String> NAMES =
            MaterialAttribute.ALL.stream().filter(MaterialExtras::hasNames).map(MaterialAttribute::name).toList();

    private MaterialExtras() {}

    private static boolean hasNames(MaterialAttribute<?> attribute) {
        return attribute.kind() instanceof ValueKind.TextureKind || attribute.kind() instanceof ValueKind.NameKind;
    }

    /**
     * Changes the materials.
     *
     * @param onError called for each value that cannot be used
     */
    static void apply(JsonNode edited, List<Material> materials, Runnable onError) {
        for (JsonNode entry : edited) {
            String name = entry.path("name").asString("");
            materials.replaceAll(material -> material.name().equals(name) ? edited(material, entry.path("edits"), onError) : material);
        }
    }

    private static Material edited(Material material, JsonNode edits, Runnable onError) {
        ObjectNode before = JSON.createObjectNode();
        AttributeJson.write(before, material, EDITABLE);
        ObjectNode after = JSON.createObjectNode();
        for (MaterialAttribute<?> attribute : EDITABLE) {
            JsonNode edit = edits.path(attribute.name());
            if (edit.size() == 2 && isSame(edit.get(0), before.get(attribute.name()))) {
                after.set(attribute.name(), edit.get(1));
            }
        }
        return AttributeJson.read(after, material, EDITABLE, (_, _) -> false, _ -> onError.run());
    }

    private static boolean isSame(JsonNode a, JsonNode b) {
        if (a.isNumber() && b.isNumber()) {
            return a.doubleValue() == b.doubleValue();
        }
        if (!a.isArray() || !b.isArray()) {
            return a.equals(b);
        }
        boolean same = a.size() == b.size();
        for (int i = 0; same && i < a.size(); i++) {
            same = isSame(a.get(i), b.get(i));
        }
        return same;
    }
}

package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.shot.Shot;

/**
 * Writer of what has been edited of imported lights.
 *
 * @param layer      receives the edits
 * @param writer     writer of single attributes
 * @param notes      receives what cannot be written
 * @param visibility writer of what hides lights
 */
public record UsdSparseLights(UsdLayer layer, UsdPrimWriter writer, ConversionNotes notes, UsdVisibility visibility) {
    private static final String SHARED = "edited lights of point instancers, which a layer cannot change one by one";
    private static final String SHAPING = "ShapingAPI";
    private static final String RIG_ORDER = "[\"xformOp:transform:lightning\"]";

    public UsdSparseLights(UsdLayer layer, UsdPrimWriter writer, ConversionNotes notes) {
        this(layer, writer, notes, new UsdVisibility(layer, writer.paths(), notes));
    }

    /**
     * Writes what has been edited of a light.
     *
     * @param type type of its prim now
     * @param prim prim in the stage
     * @param states the light at all frames; at one only if nothing moves
     */
    public void add(Light light, String type, UsdPaths.Prim prim, UsdOriginal original, Optional<Shot> shot,
            List<UsdLightChanges.State> states) throws IOException {
        var changes = new UsdLightChanges(original, light, shot, prim.type(), type, states, writer.paths());
        Map<String, TreeMap<Integer, String>> values = changes.values();
        Map<String, String> files = files(light, type, changes);
        boolean hasLinks = changes.has(LightAttribute.ILLUMINATES) || changes.has(LightAttribute.SHADOWED_BY);
        if (values.isEmpty() && files.isEmpty() && !hasLinks && !changes.isRetyped()) {
            return;
        }
        if (original.isShared()) {
            notes.add(SHARED);
            return;
        }
        UsdLayer.Prim over = editable(prim, original);
        if (changes.isRetyped()) {
            over.define(type);
            if (!UsdLightValues.isShaped(type) && original.hasSchema(SHAPING)) {
                openCone(over);
            }
        }
        addSchemas(over, original, values.keySet(), files.keySet());
        values.forEach((declaration, samples) -> writer.set(over, declaration, samples));
        if (values.getOrDefault(UsdLightValues.VISIBILITY, new TreeMap<>()).containsValue(UsdLightValues.VISIBLE)
                && (original.isSwitched() || !original.hiders().isEmpty())) {
            visibility.show(prim, original);
        }
        notes.add("edited values that the stage animates, written for all frames since one frame was imported",
                (int) values.keySet().stream().filter(original::isAnimated).count());
        if (values.containsKey(UsdLightValues.MATRIX)) {
            over.set(UsdPrimWriter.ORDER, changes.leavesRig() || original.resetsTransform() ? UsdPrimWriter.RESET_ORDER : RIG_ORDER);
        }
        notes.add("moved lights whose parents move or are flat, placed in the world", changes.leavesRig() ? 1 : 0);
        files.forEach(over::set);
        if (changes.has(LightAttribute.ILLUMINATES)) {
            writer.setLinks(over, "lightLink", light.illuminates());
        }
        if (changes.has(LightAttribute.SHADOWED_BY)) {
            writer.setLinks(over, "shadowLink", light.shadowedBy());
        }
    }

    /** Shows the added lights that objects above them hide in the stage. */
    public void finish() {
        visibility.write();
    }

    /** Removes a light from the stage. */
    public void remove(UsdPaths.Prim prim, Optional<UsdOriginal> original) {
        if (original.isPresent() && original.get().isShared()) {
            notes.add(SHARED);
            return;
        }
        (original.isPresent() ? editable(prim, original.get()) : layer.prim(prim.path())).metadata("active", "false");
    }

    /** Returns a prim whose instances can be edited. */
    private UsdLayer.Prim editable(UsdPaths.Prim prim, UsdOriginal original) {
        original.instances().forEach(path -> layer.prim(path).metadata("instanceable", "false"));
        return layer.prim(prim.path());
    }

    /** Opens the cone that the stage has, which a light of this type has not. */
    private static void openCone(UsdLayer.Prim prim) {
        UsdLightValues.OPEN_CONE.forEach(prim::set);
        prim.set(UsdPrimWriter.PROFILE, "@@");
    }

    private Map<String, String> files(Light light, String type, UsdLightChanges changes) throws IOException {
        Map<String, String> files = new LinkedHashMap<>();
        if (UsdLightValues.isShaped(type) && !writer.profile(light).equals(writer.profile(changes.before()))) {
            files.put(UsdPrimWriter.PROFILE, writer.profile(light));
        }
        if (type.equals("RectLight") && changes.has(LightAttribute.TEXTURE)) {
            files.put(UsdPrimWriter.TEXTURE, writer.texture(light));
        }
        return files;
    }

    /** Applies the schemas of attributes that are written, where the stage does not. */
    private static void addSchemas(UsdLayer.Prim prim, UsdOriginal original, Set<String> values, Set<String> files) {
        List<String> missing = new ArrayList<>();
        if (!original.hasSchema(SHAPING)
                && (files.contains(UsdPrimWriter.PROFILE) || values.stream().anyMatch(s -> s.contains("inputs:shaping:")))) {
            missing.add(SHAPING);
        }
        if (!original.hasSchema("ShadowAPI") && values.stream().anyMatch(s -> s.contains("inputs:shadow:"))) {
            missing.add("ShadowAPI");
        }
        if (!missing.isEmpty()) {
            prim.metadata("prepend apiSchemas", missing.stream().map(UsdLayer::quoted).collect(Collectors.joining(", ", "[", "]")));
        }
    }
}

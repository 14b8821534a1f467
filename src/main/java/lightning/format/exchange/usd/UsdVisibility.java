package lightning.format.exchange.usd;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;

/**
 * Shows lights that prims above them hide: makes these prims visible, and hides all else below them. An invisible prim hides all below it, so
 * there is no other way.
 */
final class UsdVisibility {
    private final UsdLayer layer;
    private final UsdPaths paths;
    private final ConversionNotes notes;
    private final List<String> lights = new ArrayList<>();
    private final Set<String> parents = new LinkedHashSet<>();

    UsdVisibility(UsdLayer layer, UsdPaths paths, ConversionNotes notes) {
        this.layer = layer;
        this.paths = paths;
        this.notes = notes;
    }

    /** Adds a light that must be visible at some frame. */
    void show(UsdPaths.Prim light, UsdOriginal original) {
        List<Optional<UsdHiddenParent>> above =
                original.hiders().stream().map(path -> Optional.ofNullable(paths.hidden().get(path))).toList();
        if (original.isSwitched()) {
            notes.add("lights that are on, visible only when the stage shows the objects above them");
        } else if (above.stream().anyMatch(parent -> parent.isEmpty() || parent.get().children().isEmpty())) {
            notes.add("lights that are on, but hidden by an object above them that has too many parts to hide them one by one");
        } else {
            lights.add(light.path());
            parents.addAll(original.hiders());
        }
    }

    /** Writes the visibility of all prims around the added lights. */
    void write() {
        for (String path : parents) {
            UsdHiddenParent parent = paths.hidden().get(path);
            if (parent == null) {
                continue;
            }
            if (parent.isHidden()) {
                layer.prim(path).set(UsdLightValues.VISIBILITY, UsdLightValues.VISIBLE);
            }
            for (String child : parent.children().orElse(List.of())) {
                if (lights.stream().noneMatch(light -> light.equals(child) || light.startsWith(child + "/"))) {
                    layer.prim(child).set(UsdLightValues.VISIBILITY, UsdLightValues.INVISIBLE);
                }
            }
        }
        notes.add("lights that are on below hidden objects, which the layer shows without their other parts", lights.size());
    }
}

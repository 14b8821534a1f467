package lightning.format.layer;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import lightning.render.shading.composition.LightComponent;

/**
 * Layer names in a file: ASCII letters, digits and underscores. They contain no dot, because Blender lists only the layers before
 * a first dot and Nuke replaces it by an underscore. Blender merges names that are equal in their first characters. Other
 * characters of a light's name become underscores; duplicate names get a number.
 */
final class LayerNames {
    /** Maximum length of a light's part, so that the name with number, term and color has at most 63 characters. */
    private static final int MAX_LENGTH = 44;

    private LayerNames() {}

    /** Returns a name for each layer, unique even ignoring case. */
    static List<String> of(List<Layer> layers) {
        List<String> names = new ArrayList<>();
        Set<String> used = new HashSet<>();
        String light = "";
        for (Layer layer : layers) {
            names.add(switch (layer) {
                case Layer.Background _ -> "background";
                case Layer.Ambient _ -> "ambient";
                case Layer.Emission _ -> "emission";
                case Layer.Gathered gathered -> gathered.settings().isIndirect() ? "indirect"
                        : gathered.settings().environment() ? Layer.ENVIRONMENT + "_gathered" : "reflected";
                case Layer.Reflections _ -> "reflections";
                case Layer.Lights lights -> {
                    if (lights.part() == LightComponent.DIFFUSE) {
                        light = unique(sanitize(lights.name()), used);
                    }
                    yield light + (lights.part() == LightComponent.DIFFUSE ? "_diffuse" : "_specular");
                }
            });
        }
        return names;
    }

    private static String unique(String name, Set<String> used) {
        String unique = name;
        for (int n = 2; !used.add(unique.toLowerCase(Locale.ROOT)); n++) {
            unique = name + "_" + n;
        }
        return unique;
    }

    private static String sanitize(String name) {
        String sanitized = name.substring(0, Math.min(name.length(), MAX_LENGTH)).replaceAll("[^A-Za-z0-9_]", "_");
        return Character.isDigit(sanitized.charAt(0)) ? "_" + sanitized : sanitized;
    }
}

package lightning.layer;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import lightning.scene.GatherSettings;

/**
 * Layer names in a file: ASCII letters, digits and underscores. They contain no dot, because Blender lists only the layers before
 * a first dot and Nuke replaces it by an underscore. Blender merges names that are equal in their first characters. Other
 * characters of a light's name become underscores; duplicate names get a number.
 */
final class LayerNames {
    /** Maximum length of a light's part, so that the name with number, term and color has at most 63 characters. */
    private static final int MAX_LENGTH = 44;

    private LayerNames() {}

    /**
     * Returns a name for each layer, unique even ignoring case.
     *
     * @param settings what the scene gathers; empty if nothing
     */
    static List<String> of(List<Layer> layers, Optional<GatherSettings> settings) {
        String gathered = settings.map(LayerNames::gathered).orElse("");
        List<String> names = new ArrayList<>();
        Set<String> used = new HashSet<>();
        LightSet named = null;
        String light = "";
        for (Layer layer : layers) {
            if (layer instanceof Layer.OfLights some && some.lights() != named) {
                named = some.lights();
                light = unique(sanitize(named.name()), used);
            }
            names.add(switch (layer) {
                case Layer.Background _ -> "background";
                case Layer.Ambient _ -> "ambient";
                case Layer.Emission _ -> "emission";
                case Layer.Gathered _ -> gathered;
                case Layer.Reflections _ -> "reflections";
                case Layer.OfLights some -> light + "_" + suffix(some.part(), gathered);
            });
        }
        return names;
    }

    private static String suffix(LightPart part, String gathered) {
        return switch (part) {
            case DIFFUSE -> "diffuse";
            case SPECULAR -> "specular";
            case GATHERED -> gathered;
            case REFLECTIONS -> "reflections";
            case FOG -> "fog";
        };
    }

    private static String gathered(GatherSettings settings) {
        return settings.isIndirect() ? "indirect" : settings.environment() ? "gathered" : "reflected";
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

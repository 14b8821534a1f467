package lightning.format.layer;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import lightning.render.shading.LightComponent;

/**
 * What layers are called in a file: letters, digits and underscores of ASCII, which Nuke and Blender take as they are, and a dot before
 * {@code diffuse} and {@code specular}. Any other character of a light's name becomes an underscore; a number is put behind a name that
 * another has already.
 */
final class LayerNames {
    /** So that a whole name with its part and color is not longer than a channel's may be. */
    private static final int MAX_LENGTH = 200;

    private LayerNames() {}

    /** A name for each layer, no two of which are the same, whatever the case. */
    static List<String> of(List<Layer> layers) {
        List<String> names = new ArrayList<>();
        Set<String> used = new HashSet<>();
        String light = "";
        for (Layer layer : layers) {
            names.add(switch (layer) {
                case Layer.Background _ -> "background";
                case Layer.Ambient _ -> "ambient";
                case Layer.Reflections _ -> "reflections";
                case Layer.Lights lights -> {
                    if (lights.part() == LightComponent.DIFFUSE) {
                        light = unique(sanitize(lights.name()), used);
                    }
                    yield light + (lights.part() == LightComponent.DIFFUSE ? ".diffuse" : ".specular");
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

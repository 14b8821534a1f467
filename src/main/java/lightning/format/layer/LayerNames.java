package lightning.format.layer;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import lightning.render.shading.LightPart;

/**
 * What layers are called in a file: letters, digits and underscores of ASCII, which Nuke and Blender take as they are, and a dot before
 * {@code diffuse} and {@code specular}. Any other character of a light's name becomes an underscore; a number is put behind a name that
 * another has already.
 */
final class LayerNames {
    /** So that a whole name with its part and colour is not longer than a channel's may be. */
    private static final int LONGEST = 200;

    private LayerNames() {}

    /** A name for each layer, no two of which are the same, whatever the case. */
    static List<String> of(List<Layer> layers) {
        List<String> names = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        String light = "";
        for (Layer layer : layers) {
            names.add(switch (layer) {
                case Layer.Background _ -> "background";
                case Layer.Ambient _ -> "ambient";
                case Layer.Reflections _ -> "reflections";
                case Layer.Lights lights -> {
                    if (lights.part() == LightPart.DIFFUSE) {
                        light = free(plain(lights.name()), taken);
                    }
                    yield light + (lights.part() == LightPart.DIFFUSE ? ".diffuse" : ".specular");
                }
            });
        }
        return names;
    }

    private static String free(String name, Set<String> taken) {
        String free = name;
        for (int n = 2; !taken.add(free.toLowerCase(Locale.ROOT)); n++) {
            free = name + "_" + n;
        }
        return free;
    }

    private static String plain(String name) {
        String plain = name.substring(0, Math.min(name.length(), LONGEST)).replaceAll("[^A-Za-z0-9_]", "_");
        return Character.isDigit(plain.charAt(0)) ? "_" + plain : plain;
    }
}

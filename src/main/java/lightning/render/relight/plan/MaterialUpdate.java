package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;

/**
 * What an edit of materials asks of a level's rows, from the cheapest to the dearest. A material may be in several sets.
 *
 * @param materials  as they are wanted
 * @param colorChanged  any color or the texture changed: the equation is closed anew where their rows are
 * @param specularChanged  the shininess, roughness or model changed, or highlights came or went: terms of each light are computed anew,
 *                   without a ray
 * @param textureChanged the texture changed: their rows' texels are looked up anew, without a search
 * @param mirroringChanged    reflectivity came or went: their rows begin or cease to cast mirrored rays
 */
public record MaterialUpdate(MaterialTable materials, MaterialSet colorChanged, MaterialSet specularChanged, MaterialSet textureChanged,
        MaterialSet mirroringChanged) {

    /** No material is another. */
    public static MaterialUpdate none(MaterialTable materials) {
        return new MaterialUpdate(materials, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE);
    }

    public boolean isEmpty() {
        return colorChanged.isEmpty() && specularChanged.isEmpty() && textureChanged.isEmpty() && mirroringChanged.isEmpty();
    }

    /** The steps in words, one for each material. */
    List<String> describe() {
        List<String> steps = new ArrayList<>();
        for (int m = 0; m < materials.count() && !isEmpty(); m++) {
            List<String> parts = new ArrayList<>();
            if (mirroringChanged.contains(m)) {
                parts.add(materials.isReflective(m) ? "begins to mirror" : "ceases to mirror");
            }
            if (textureChanged.contains(m)) {
                parts.add("texture");
            }
            if (specularChanged.contains(m)) {
                parts.add(materials.isSpecular(m) ? "specular term" : "no highlights");
            }
            if (parts.isEmpty() && colorChanged.contains(m)) {
                parts.add("colors");
            }
            if (!parts.isEmpty()) {
                steps.add(materials.material(m).name() + ": " + String.join(" + ", parts));
            }
        }
        return steps;
    }
}

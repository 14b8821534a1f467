package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;

/**
 * Update of a level's rows after an edit of materials, from the cheapest set to the most expensive. A material may be in several
 * sets.
 *
 * @param materials        the target materials
 * @param colorChanged     materials with another color or texture: the equation is evaluated again for their rows
 * @param specularChanged  materials with another shininess, roughness or model, or with highlights gained or lost: each light's
 *                         terms are recomputed without a ray
 * @param textureChanged   materials with another texture: their rows' texels are looked up again without intersection tests
 * @param mirroringChanged materials that gained or lost reflectivity: their rows start or stop casting mirrored rays
 */
public record MaterialUpdate(MaterialTable materials, MaterialSet colorChanged, MaterialSet specularChanged, MaterialSet textureChanged,
        MaterialSet mirroringChanged) {

    /** Creates an empty update. */
    public static MaterialUpdate none(MaterialTable materials) {
        return new MaterialUpdate(materials, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE);
    }

    public boolean isEmpty() {
        return colorChanged.isEmpty() && specularChanged.isEmpty() && textureChanged.isEmpty() && mirroringChanged.isEmpty();
    }

    /** Returns the steps as text, one for each material. */
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
